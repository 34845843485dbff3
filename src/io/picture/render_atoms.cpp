#include "atom_mapping/io/render_atoms.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkErrorCode.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageShrink3D.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLSphereMapper.h>
#include <vtkPNGWriter.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "atom_mapping/base/quantile.h"
#include "atom_mapping/io/picture/find_ceiling.h"
#include "atom_mapping/io/picture/headless_gl.h"
#include "atom_mapping/io/picture/light_atoms.h"

namespace atom_map {
namespace {

constexpr int kSupersampling = 2;       // pixels drawn a side for one of the picture
constexpr double kViewAngle = 25.0;     // deg, vertical
constexpr double kMargin = 0.07;        // of the picture, kept empty
constexpr double kSunElevation = 40.0;  // deg

double radians(double degrees) {
  return degrees * M_PI / 180.0;
}

// Unit vector; angles in degrees.
Eigen::Vector3d direction(double azimuth, double elevation) {
  return {std::cos(radians(azimuth)) * std::cos(radians(elevation)),
          std::sin(radians(azimuth)) * std::cos(radians(elevation)), std::sin(radians(elevation))};
}

// The sun stands at the camera's right.
Eigen::Vector3d sunDirection(const RenderOptions& options) {
  return direction(options.azimuth + 70.0, kSunElevation);
}

std::vector<Eigen::Vector3f> cutAway(const std::vector<Eigen::Vector3f>& centers, float radius,
                                     const RenderOptions& options) {
  std::vector<Eigen::Vector3f> kept = centers;
  if (kept.empty()) throw std::runtime_error("nothing to draw: the map has no occupied atom");
  const double cut = std::isnan(options.cut_z) ? findCeiling(centers, radius).value_or(INFINITY) : options.cut_z;
  kept.erase(std::remove_if(kept.begin(), kept.end(), [cut](const auto& center) { return center.z() > cut; }),
             kept.end());
  if (kept.empty()) throw std::runtime_error("nothing to draw: every occupied atom lies above the cut");
  return kept;
}

// From blue ground to red heights.
Eigen::Vector3f heightColor(float share) {
  static const std::array<Eigen::Vector3f, 6> kColors = {
      Eigen::Vector3f(0.30F, 0.40F, 0.60F), Eigen::Vector3f(0.15F, 0.60F, 0.68F), Eigen::Vector3f(0.45F, 0.78F, 0.50F),
      Eigen::Vector3f(0.99F, 0.84F, 0.40F), Eigen::Vector3f(0.96F, 0.54F, 0.26F), Eigen::Vector3f(0.86F, 0.30F, 0.30F)};
  const float place = std::clamp(share, 0.0F, 1.0F) * static_cast<float>(kColors.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), kColors.size() - 2);
  return kColors[below] + (place - static_cast<float>(below)) * (kColors[below + 1] - kColors[below]);
}

std::vector<Eigen::Vector3f> colorAtoms(const std::vector<Eigen::Vector3f>& centers, float radius,
                                        const RenderOptions& options) {
  const std::vector<float> light = lightAtoms(centers, radius, sunDirection(options).cast<float>());
  std::vector<double> heights;
  for (const Eigen::Vector3f& center : centers) heights.push_back(center.z());
  const auto low = static_cast<float>(quantile(heights, 0.02));
  const auto span = std::max(static_cast<float>(quantile(heights, 0.99)) - low, 1.0F);

  std::vector<Eigen::Vector3f> colors;
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const float lit = 0.25F + 0.95F * light[i];
    colors.emplace_back((lit * heightColor((centers[i].z() - low) / span)).cwiseMin(1.0F));
  }
  return colors;
}

vtkNew<vtkPolyData> makePoints(const std::vector<Eigen::Vector3f>& centers,
                               const std::vector<Eigen::Vector3f>& colors) {
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;  // the mapper draws nothing without cells
  vtkNew<vtkUnsignedCharArray> scalars;
  scalars->SetNumberOfComponents(3);
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const vtkIdType id = points->InsertNextPoint(centers[i].data());
    vertices->InsertNextCell(1, &id);
    const Eigen::Vector3f color = 255.0F * colors[i];
    scalars->InsertNextTuple3(color.x(), color.y(), color.z());
  }
  vtkNew<vtkPolyData> cloud;
  cloud->SetPoints(points);
  cloud->SetVerts(vertices);
  cloud->GetPointData()->SetScalars(scalars);
  return cloud;
}

// Places the camera as near as it sees all atoms, save some stray ones. Each atom confines it to a cone around the
// viewing direction; their common part is found for each side of the picture alone.
void frameAtoms(const std::vector<Eigen::Vector3f>& centers, const RenderOptions& options, vtkCamera* camera) {
  const Eigen::Vector3d back = direction(options.azimuth, options.elevation);
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(back).normalized();
  const Eigen::Vector3d up = back.cross(right);
  const double slope_y = std::tan(radians(kViewAngle / 2.0)) * (1.0 - kMargin);
  const double slope_x = slope_y * options.width / options.height;
  const auto bound = [&](const Eigen::Vector3d& side, double slope) {
    std::vector<double> bounds;
    for (const Eigen::Vector3f& center : centers) bounds.push_back(center.cast<double>().dot(side + slope * back));
    return quantile(bounds, 0.9995);
  };
  const double at_right = bound(right, slope_x);
  const double at_left = bound(-right, slope_x);
  const double at_top = bound(up, slope_y);
  const double at_bottom = bound(-up, slope_y);

  const double distance = std::max((at_right + at_left) / (2.0 * slope_x), (at_top + at_bottom) / (2.0 * slope_y));
  const Eigen::Vector3d eye = (at_right - at_left) / 2.0 * right + (at_top - at_bottom) / 2.0 * up + distance * back;
  const Eigen::Vector3d target = eye - back;
  camera->SetPosition(eye.data());
  camera->SetFocalPoint(target.data());
  camera->SetViewUp(up.data());
  camera->SetViewAngle(kViewAngle);
}

void addLights(const RenderOptions& options, vtkRenderer* renderer) {
  vtkNew<vtkLight> sun;
  sun->SetLightTypeToSceneLight();
  const Eigen::Vector3d from = sunDirection(options);
  sun->SetPosition(from.data());
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetIntensity(0.6);
  renderer->AddLight(sun);
  vtkNew<vtkLight> lamp;
  lamp->SetLightTypeToHeadlight();
  lamp->SetIntensity(0.55);
  renderer->AddLight(lamp);
}

void writePng(vtkRenderWindow* window, const std::string& file) {
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(window);
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  vtkNew<vtkImageShrink3D> shrink;
  shrink->SetInputConnection(image->GetOutputPort());
  shrink->SetShrinkFactors(kSupersampling, kSupersampling, 1);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(shrink->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError) throw std::runtime_error("cannot write the picture " + file);
}

}  // namespace

void renderAtoms(const std::vector<Eigen::Vector3f>& centers, float radius, const RenderOptions& options,
                 const std::string& png_file) {
  const std::vector<Eigen::Vector3f> shown = cutAway(centers, radius, options);

  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(makePoints(shown, colorAtoms(shown, radius, options)));
  mapper->SetRadius(radius);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.80);
  actor->GetProperty()->SetSpecular(0.12);
  actor->GetProperty()->SetSpecularPower(15.0);

  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  renderer->GradientBackgroundOn();
  renderer->SetBackground(0.05, 0.065, 0.09);
  renderer->SetBackground2(0.17, 0.20, 0.26);
  addLights(options, renderer);

  const HeadlessGl gl;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetOwnContext(0);
  window->SetIsCurrent(true);
  window->SetMapped(true);
  window->SetReadyForRendering(true);
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(kSupersampling * options.width, kSupersampling * options.height);
  window->AddRenderer(renderer);
  frameAtoms(shown, options, renderer->GetActiveCamera());
  renderer->ResetCameraClippingRange();
  window->Render();
  writePng(window, png_file);
}

}  // namespace atom_map
