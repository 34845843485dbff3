// make_corpus FOLDER: small inputs that the fuzzers start from, as of a scan and of a map that this program made.
#include <filesystem>
#include <fstream>

#include "atom_mapping/io/map_file.h"
#include "atom_mapping/io/map_stream.h"
#include "atom_mapping/io/sealed_file.h"
#include "atom_mapping/map/mapper.h"

namespace {

using atom_map::Mode;

atom_map::LidarScan ring() {
  atom_map::LidarScan scan;
  for (int i = 0; i < 12; ++i) {
    const float angle = 0.5F * static_cast<float>(i);
    scan.points.emplace_back(3.0F * std::cos(angle), 3.0F * std::sin(angle), 0.1F * static_cast<float>(i % 3));
  }
  return scan;
}

void write(const std::string& file, const std::string& bytes) {
  std::filesystem::create_directories(std::filesystem::path(file).parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

std::string streamOf(const std::string& map_file) {
  std::string stream;
  atom_map::sendMap(atom_map::readSealed(map_file),
                    [&](const void* bytes, std::size_t size) { stream.append(static_cast<const char*>(bytes), size); });
  return stream;
}

void writeMap(const std::string& folder, Mode mode, const std::string& name) {
  atom_map::MappingParameters parameters;
  parameters.mode = mode;
  parameters.radius = 0.5;
  atom_map::Mapper mapper(parameters);
  mapper.insertScan(ring(), atom_map::Pose::Identity());
  const std::string file = folder + "/map_file/" + name;
  std::filesystem::create_directories(folder + "/map_file");
  atom_map::saveMap(atom_map::copyMap(mapper), file);
  write(folder + "/map_stream/" + name, streamOf(file));
}

std::string cloudBytes() {
  std::string bytes;
  for (const Eigen::Vector3f& point : ring().points) bytes.append(reinterpret_cast<const char*>(point.data()), 12);
  return bytes + std::string(5, '\1');  // FuzzedDataProvider takes what is no data from the end
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const std::string folder = argv[1];
  writeMap(folder, Mode::kOccupancy, "occupancy");
  writeMap(folder, Mode::kSignedDistance, "signed_distance");
  write(folder + "/cloud_conversion/ring", cloudBytes());
  return 0;
}
