#include "atom_mapping/io/render_atoms.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkOpenGLRenderer.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkSSAOPass.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "atom_mapping/io/picture/headless_gl.h"

namespace atom_map {
namespace {

using Rgb = Eigen::Vector3f;

Rgb heightColor(float share) {
  static const std::array<Rgb, 6> kColors = {Rgb(0.28F, 0.36F, 0.52F), Rgb(0.16F, 0.56F, 0.63F), Rgb(0.45F, 0.75F, 0.48F),
                                             Rgb(0.96F, 0.81F, 0.38F), Rgb(0.93F, 0.50F, 0.24F), Rgb(0.78F, 0.26F, 0.26F)};
  const float scaled = std::clamp(share, 0.0F, 1.0F) * (kColors.size() - 1);
  const std::size_t below = std::min<std::size_t>(static_cast<std::size_t>(scaled), kColors.size() - 2);
  return kColors[below] + (kColors[below + 1] - kColors[below]) * (scaled - static_cast<float>(below));
}

// Which cubic cells of space hold an atom.
class CellGrid {
 public:
  CellGrid(const std::vector<Eigen::Vector3f>& centers, float side) : side_(side) {
    Eigen::AlignedBox3f box;
    for (const Eigen::Vector3f& center : centers) box.extend(center);
    side_ = std::max(side_, std::cbrt(box.volume() / 3e8F));
    low_ = box.min() - Eigen::Vector3f::Constant(side_);
    size_ = ((box.sizes() / side_).array() + 3.0F).cast<long>();
    filled_.resize(static_cast<std::size_t>(size_.prod()));
    for (const Eigen::Vector3f& center : centers) filled_[index(cellOf(center))] = true;
  }
  float side() const { return side_; }
  bool filled(const Eigen::Vector3f& point) const {
    const Cell cell = cellOf(point);
    return (cell >= 0).all() && (cell < size_).all() && filled_[index(cell)];
  }

 private:
  using Cell = Eigen::Array<long, 3, 1>;
  Cell cellOf(const Eigen::Vector3f& point) const { return ((point - low_) / side_).array().floor().cast<long>(); }
  std::size_t index(const Cell& cell) const {
    return static_cast<std::size_t>((cell.x() * size_.y() + cell.y()) * size_.z() + cell.z());
  }
  float side_;
  Eigen::Vector3f low_;
  Cell size_;
  std::vector<bool> filled_;
};

float openness(const CellGrid& grid, const Eigen::Vector3f& center, const std::vector<Eigen::Vector3f>& dirs, float reach) {
  float open = 0;
  for (const auto& d : dirs) {
    float t = 1.8F * grid.side();
    while (t < reach && !grid.filled(center + t * d)) t += grid.side()*0.7F;
    open += std::min(1.0F, t / reach);
  }
  return open / static_cast<float>(dirs.size());
}

vtkSmartPointer<vtkPolyData> makeSpheres(const std::vector<Eigen::Vector3f>& centers, float radius, const RenderOptions& o) {
  std::vector<float> z;
  for (const auto& c : centers) z.push_back(c.z());
  std::sort(z.begin(), z.end());
  const float low = z[z.size() / 50], high = z[z.size() - 1 - z.size() / 100];
  vtkNew<vtkPolyData> spheres;
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  colors->SetName("color");
  std::vector<Eigen::Vector3f> sky, sun;
  for (int i = 0; i < 48; ++i) {
    const float a = 2.39996F * i, u = (i + 0.5F) / 48, s = std::sqrt(u);
    sky.emplace_back(s * std::cos(a), s * std::sin(a), std::sqrt(1 - u));
  }
  const float az = (o.azimuth + 70) * M_PI / 180, el = 40 * M_PI / 180;
  for (int i = 0; i < 16; ++i) {
    const float a = 2.39996F * i, s = 0.06F * std::sqrt(i / 16.0F);
    sun.push_back(Eigen::Vector3f(std::cos(az + s * std::cos(a)) * std::cos(el + s * std::sin(a)), std::sin(az + s * std::cos(a)) * std::cos(el+ s * std::sin(a)), std::sin(el+ s * std::sin(a))));
  }
  const CellGrid grid(centers, 2 * radius);
  for (const auto& c : centers) {
    const vtkIdType id = points->InsertNextPoint(c.x(), c.y(), c.z());
    vertices->InsertNextCell(1, &id);
    float light = 0.30F + 0.40F * openness(grid, c, sky, 4.0F) + 0.35F * openness(grid, c, sun, 20.0F);
    if (getenv("NOBAKE")) light = 1;
    const Rgb color = (heightColor((c.z() - low) / std::max(high - low, 1e-3F)) * light * 255.0F).cwiseMin(255.0F);
    colors->InsertNextTuple3(color.x(), color.y(), color.z());
  }
  spheres->SetPoints(points);
  spheres->SetVerts(vertices);
  spheres->GetPointData()->SetScalars(colors);
  return spheres;
}

void frame(vtkCamera* camera, const std::vector<Eigen::Vector3f>& centers, const RenderOptions& o) {
  const double az = o.azimuth * M_PI / 180, el = o.elevation * M_PI / 180, half = 12.5 * M_PI / 180;
  const Eigen::Vector3d back(std::cos(az) * std::cos(el), std::sin(az) * std::cos(el), std::sin(el));
  const Eigen::Vector3d right(-std::sin(az), std::cos(az), 0), up = back.cross(right);
  const double ty = std::tan(half) * 0.93, tx = ty * o.width / o.height;
  // Each point confines the eye to a cone: four half planes.
  double r = -1e30, l = -1e30, t = -1e30, b = -1e30;
  for (const auto& c : centers) {
    const Eigen::Vector3d p = c.cast<double>();
    r = std::max(r, p.dot(right) + tx * p.dot(back));
    l = std::max(l, -p.dot(right) + tx * p.dot(back));
    t = std::max(t, p.dot(up) + ty * p.dot(back));
    b = std::max(b, -p.dot(up) + ty * p.dot(back));
  }
  const double depth = std::max((r + l) / (2 * tx), (t + b) / (2 * ty));
  const Eigen::Vector3d eye = right * (r - l) / 2 + up * (t - b) / 2 + back * depth;
  const Eigen::Vector3d at = eye - back;
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(at.data());
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(25);
}

}  // namespace

void renderAtoms(const std::vector<Eigen::Vector3f>& centers, float radius, const RenderOptions& options,
                 const std::string& png_file) {
  const HeadlessGl gl;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetIsCurrent(true);
  window->SetOwnContext(0);
  window->SetReadyForRendering(true);
  window->SetMapped(true);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(2*options.width, 2*options.height);

  const auto spheres = makeSpheres(centers, radius, options);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(spheres);
  mapper->SetRadius(radius);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.25);
  actor->GetProperty()->SetDiffuse(0.85);
  actor->GetProperty()->SetSpecular(0.1);
  actor->GetProperty()->SetSpecularPower(20);
  vtkNew<vtkOpenGLRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GradientBackgroundOn();
  if (getenv("DARK")) { renderer->SetBackground(0.06, 0.075, 0.10); renderer->SetBackground2(0.16, 0.19, 0.24);} else {renderer->SetBackground(0.80, 0.85, 0.90);
  renderer->SetBackground2(0.97, 0.98, 0.99);}
  window->AddRenderer(renderer);
  frame(renderer->GetActiveCamera(), centers, options);
  renderer->ResetCameraClippingRange();

  vtkNew<vtkRenderStepsPass> steps;
  vtkNew<vtkSSAOPass> ssao;
  ssao->SetRadius(8.0 * radius);
  ssao->SetBias(0.2 * radius);
  ssao->SetKernelSize(128);
  ssao->BlurOn();
  ssao->SetDelegatePass(steps);
  vtkNew<vtkOpenGLFXAAPass> fxaa;
  fxaa->SetDelegatePass(ssao);
  if (getenv("NOSSAO")) renderer->SetPass(steps); else renderer->SetPass(ssao);
  window->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(png_file.c_str());
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(image->GetOutputPort());
  shrink->SetShrinkFactors(2, 2, 1);
  shrink->AveragingOn();
  writer->SetInputConnection(shrink->GetOutputPort());
  writer->Write();
}

}  // namespace atom_map
