#include "atom_mapping/io/write_mesh.h"

#include <cmath>
#include <filesystem>
#include <ostream>
#include <stdexcept>

#include "atom_mapping/io/write_file.h"
#include "atom_mapping/surface/sureness.h"

namespace atom_map {
namespace {

template <class Value>
void put(std::ostream& out, const Value& value) {
  out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

void writeHeader(const SurfaceMesh& mesh, std::ostream& out) {
  out << "ply\nformat binary_little_endian 1.0\ncomment implicit surface of an AtomMap, metres\n"
      << "element vertex " << mesh.vertices.size() << "\n"
      << "property double x\nproperty double y\nproperty double z\nproperty float variance\n"
      << "property uchar red\nproperty uchar green\nproperty uchar blue\n"
      << "element face " << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void checkMeshFile(const std::string& file) {
  if (std::filesystem::path(file).extension() != ".ply") {
    throw std::invalid_argument("cannot write a mesh to " + file + ": name a file that ends in .ply");
  }
  checkWritable(file);
}

void writeMesh(const SurfaceMesh& mesh, const std::string& file) {
  checkMeshFile(file);
  const std::vector<float> brightness = brightnessOf(mesh.variance);
  writeFile(file, [&](std::ostream& out) {
    writeHeader(mesh, out);
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
      const Eigen::Vector3d vertex = mesh.vertices[i].cast<double>() + mesh.origin;
      for (int axis = 0; axis < 3; ++axis) put(out, vertex[axis]);
      put(out, mesh.variance[i]);
      for (int channel = 0; channel < 3; ++channel) put(out, static_cast<unsigned char>(255.0F * brightness[i]));
    }
    for (const auto& triangle : mesh.triangles) {
      put(out, static_cast<unsigned char>(3));
      for (const std::uint32_t vertex : triangle) put(out, static_cast<std::int32_t>(vertex));
    }
  });
}

}  // namespace atom_map
