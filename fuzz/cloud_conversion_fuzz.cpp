// Any PointCloud2 at all becomes a scan of the right points, or is refused; and a map of any scan at all holds numbers.
#include <fuzzer/FuzzedDataProvider.h>

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "atom_mapping/map/mapper.h"
#include "atom_mapping/ros/cloud_conversion.h"

namespace {

using sensor_msgs::PointCloud2;

void expect(bool holds) {
  if (!holds) std::abort();
}

PointCloud2 drawCloud(FuzzedDataProvider& bytes) {
  PointCloud2 cloud;
  const bool is_ours = bytes.ConsumeBool();  // fields and sizes that fit; else anything
  const auto fields = is_ours ? 3 : bytes.ConsumeIntegralInRange<std::size_t>(0, 8);
  for (std::size_t i = 0; i < fields; ++i) {
    sensor_msgs::PointField field;
    field.name = is_ours ? std::string(1, static_cast<char>('x' + i)) : bytes.PickValueInArray({"x", "y", "z", "ring"});
    field.offset = is_ours ? static_cast<std::uint32_t>(4 * i) : bytes.ConsumeIntegral<std::uint32_t>();
    field.datatype = is_ours ? 7 : bytes.ConsumeIntegral<std::uint8_t>();
    field.count = is_ours ? 1 : bytes.ConsumeIntegral<std::uint32_t>();
    cloud.fields.push_back(field);
  }
  cloud.is_bigendian = bytes.ConsumeBool() ? 1 : 0;
  cloud.height = is_ours ? bytes.ConsumeIntegralInRange<std::uint32_t>(1, 4) : bytes.ConsumeIntegral<std::uint32_t>();
  cloud.point_step = is_ours ? 12 : bytes.ConsumeIntegral<std::uint32_t>();
  cloud.width = is_ours ? static_cast<std::uint32_t>(bytes.remaining_bytes()) / (cloud.height * 12)
                        : bytes.ConsumeIntegral<std::uint32_t>();
  cloud.row_step = is_ours ? cloud.width * 12 : bytes.ConsumeIntegral<std::uint32_t>();
  cloud.data = bytes.ConsumeRemainingBytes<std::uint8_t>();
  if (is_ours) cloud.data.resize(std::size_t{cloud.height} * cloud.row_step);
  return cloud;
}

void expectPointsOf(const PointCloud2& cloud, const atom_map::LidarScan& scan) {
  expect(scan.points.size() == std::size_t{cloud.width} * cloud.height);
  if (cloud.is_bigendian != 0 || scan.points.empty()) return;
  for (const sensor_msgs::PointField& field : cloud.fields) {
    if (field.name.size() != 1 || field.name[0] < 'x') continue;
    const std::size_t last = std::size_t{cloud.height - 1} * cloud.row_step + (cloud.width - 1) * cloud.point_step;
    expect(std::memcmp(&scan.points.back()[field.name[0] - 'x'], &cloud.data.at(last + field.offset), 4) == 0);
  }
}

void mapTwice(const atom_map::LidarScan& scan, atom_map::Mode mode) {
  atom_map::MappingParameters parameters;
  parameters.mode = mode;
  parameters.radius = 0.5;
  parameters.scan.clear_no_returns = true;
  atom_map::Mapper mapper(parameters);
  for (int i = 0; i < 2; ++i) mapper.insertScan(scan, atom_map::Pose::Identity());
  mapper.read([&](const atom_map::AtomMap& map) {
    map.atoms().forEach([&](atom_map::ConstAtomRef atom) {
      expect(atom.center().allFinite() && std::isfinite(atom.value()));
      expect(mode == atom_map::Mode::kOccupancy || atom.value(1) >= 0.0F);
    });
  });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const bool infer_no_returns = bytes.ConsumeBool();
  const auto mode = bytes.ConsumeBool() ? atom_map::Mode::kOccupancy : atom_map::Mode::kSignedDistance;
  const PointCloud2 cloud = drawCloud(bytes);
  try {
    const atom_map::LidarScan scan = atom_mapping::toLidarScan(cloud, infer_no_returns);
    expectPointsOf(cloud, scan);
    mapTwice(scan, mode);
  } catch (const atom_mapping::MalformedCloud&) {
  }
  return 0;
}
