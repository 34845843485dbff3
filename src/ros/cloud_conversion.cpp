#include "atom_mapping/ros/cloud_conversion.h"

#include <sensor_msgs/PointField.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <sstream>

#include "atom_mapping/ros/no_returns.h"

namespace atom_mapping {
namespace {

using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr std::uint64_t kFloatBytes = 4;

using Offsets = std::array<std::uint64_t, 3>;  // of x, y, z in a point

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw MalformedCloud(text.str());
}

const PointField& findField(const PointCloud2& cloud, const char* name) {
  const auto is_it = [&](const PointField& field) { return field.name == name; };
  const auto found = std::find_if(cloud.fields.begin(), cloud.fields.end(), is_it);
  if (found == cloud.fields.end()) refuse("it has no field ", name, "; it must have the float32 fields x, y and z");
  if (std::any_of(found + 1, cloud.fields.end(), is_it)) refuse("it has two fields ", name, "; it must have one");
  return *found;
}

std::uint64_t offsetOf(const PointCloud2& cloud, const char* name) {
  const PointField& field = findField(cloud, name);
  if (field.datatype != PointField::FLOAT32) {
    refuse("field ", name, " has datatype ", int{field.datatype}, "; it must be ", int{PointField::FLOAT32},
           " (float32)");
  }
  if (field.count != 1) refuse("field ", name, " has count ", field.count, "; it must be 1");
  if (field.offset + kFloatBytes > cloud.point_step) {
    refuse("field ", name, " has offset ", field.offset, ", so that point_step must be at least ",
           field.offset + kFloatBytes, "; it is ", cloud.point_step);
  }
  return field.offset;
}

Offsets findOffsets(const PointCloud2& cloud) {
  const Offsets offsets{offsetOf(cloud, "x"), offsetOf(cloud, "y"), offsetOf(cloud, "z")};
  Offsets sorted = offsets;
  std::sort(sorted.begin(), sorted.end());
  if (sorted[0] + kFloatBytes > sorted[1] || sorted[1] + kFloatBytes > sorted[2]) {
    refuse("fields x, y and z have offsets ", offsets[0], ", ", offsets[1], " and ", offsets[2],
           "; they must lie at least ", kFloatBytes, " bytes apart");
  }
  return offsets;
}

// 64 bits hold every product of two 32-bit sizes.
void checkSizes(const PointCloud2& cloud) {
  const std::uint64_t row_bytes = std::uint64_t{cloud.width} * cloud.point_step;
  if (cloud.row_step < row_bytes) {
    refuse("row_step is ", cloud.row_step, "; it must be at least width * point_step = ", cloud.width, " * ",
           cloud.point_step, " = ", row_bytes);
  }
  const std::uint64_t bytes = std::uint64_t{cloud.height} * cloud.row_step;
  if (cloud.data.size() != bytes) {
    refuse("data has ", cloud.data.size(), " bytes; it must have height * row_step = ", cloud.height, " * ",
           cloud.row_step, " = ", bytes);
  }
}

bool isBigEndianMachine() {
  const std::uint16_t one = 1;
  std::uint8_t first = 0;
  std::memcpy(&first, &one, 1);
  return first == 0;
}

float readFloat(const std::uint8_t* at, bool swap) {
  std::array<std::uint8_t, kFloatBytes> bytes{};
  std::memcpy(bytes.data(), at, kFloatBytes);
  if (swap) std::reverse(bytes.begin(), bytes.end());
  float value = 0.0F;
  std::memcpy(&value, bytes.data(), kFloatBytes);
  return value;
}

std::vector<Eigen::Vector3f> readPoints(const PointCloud2& cloud, const Offsets& offsets) {
  const bool swap = (cloud.is_bigendian != 0) != isBigEndianMachine();
  std::vector<Eigen::Vector3f> points;
  points.reserve(std::size_t{cloud.width} * cloud.height);
  for (std::uint64_t row = 0; row < cloud.height; ++row) {
    const std::uint8_t* point = cloud.data.data() + row * cloud.row_step;
    for (std::uint64_t column = 0; column < cloud.width; ++column, point += cloud.point_step) {
      points.emplace_back(readFloat(point + offsets[0], swap), readFloat(point + offsets[1], swap),
                          readFloat(point + offsets[2], swap));
    }
  }
  return points;
}

}  // namespace

atom_map::LidarScan toLidarScan(const PointCloud2& cloud, bool infer_no_returns) {
  atom_map::LidarScan scan;
  const bool is_empty = cloud.width == 0 || cloud.height == 0;
  if (is_empty && cloud.data.empty()) return scan;  // drivers and PCL leave the fields out then
  if (is_empty) refuse("data has ", cloud.data.size(), " bytes; it must have none where width or height is 0");
  const Offsets offsets = findOffsets(cloud);
  checkSizes(cloud);
  scan.points = readPoints(cloud, offsets);
  if (infer_no_returns && cloud.height > 1) scan.no_returns = inferNoReturns(scan.points, cloud.width);
  return scan;
}

}  // namespace atom_mapping
