#include "atom_mapping/ros/cloud_conversion.h"

#include <gtest/gtest.h>
#include <sensor_msgs/PointField.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "atom_mapping/base/random.h"

namespace atom_mapping {
namespace {

using Eigen::Vector3f;
using sensor_msgs::PointCloud2;
using sensor_msgs::PointField;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

PointField makeField(const std::string& name, std::uint32_t offset) {
  PointField field;
  field.name = name;
  field.offset = offset;
  field.datatype = PointField::FLOAT32;
  field.count = 1;
  return field;
}

// Coordinates at the given offsets in a point, other bytes 0xAB.
PointCloud2 makeCloud(const std::vector<Vector3f>& points, std::uint32_t rows,
                      const std::array<std::uint32_t, 3>& offsets, std::uint32_t point_step,
                      std::uint32_t padding = 0) {
  PointCloud2 cloud;
  cloud.height = rows;
  cloud.width = static_cast<std::uint32_t>(points.size()) / rows;
  cloud.point_step = point_step;
  cloud.row_step = cloud.width * point_step + padding;
  for (int axis = 0; axis < 3; ++axis) cloud.fields.push_back(makeField(std::string(1, "xyz"[axis]), offsets[axis]));
  cloud.data.assign(std::size_t{cloud.row_step} * rows, 0xAB);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::uint8_t* at = &cloud.data[i / cloud.width * cloud.row_step + i % cloud.width * point_step];
    for (int axis = 0; axis < 3; ++axis) std::memcpy(at + offsets[axis], &points[i][axis], 4);
  }
  return cloud;
}

const std::vector<Vector3f> kPoints{{1.0F, 2.0F, 3.0F}, {-4.0F, 5.5F, 0.0F}, {7.0F, -8.0F, 9.0F}, {0.1F, 0.2F, 0.3F}};

PointCloud2 makePlainCloud() {
  return makeCloud(kPoints, 1, {0, 4, 8}, 16);
}

TEST(CloudConversion, ReadsAnyLayout) {
  const std::vector<std::array<std::uint32_t, 3>> layouts{{0, 4, 8}, {8, 4, 0}, {3, 17, 9}, {1, 5, 40}};
  for (const auto& offsets : layouts) {
    for (const std::uint32_t rows : {1U, 2U, 4U}) {
      for (const std::uint32_t padding : {0U, 7U}) {
        EXPECT_EQ(toLidarScan(makeCloud(kPoints, rows, offsets, 44, padding)).points, kPoints);
      }
    }
  }
}

TEST(CloudConversion, ReadsBigEndian) {
  PointCloud2 cloud = makePlainCloud();
  cloud.is_bigendian = 1;
  for (std::size_t i = 0; i < cloud.data.size(); i += 4) std::reverse(&cloud.data[i], &cloud.data[i] + 4);
  EXPECT_EQ(toLidarScan(cloud).points, kPoints);
}

TEST(CloudConversion, KeepsWhatIsNotFinite) {
  const float nan = std::nanf("");
  const auto points =
      toLidarScan(makeCloud({{nan, 0, 0}, {kInfinity, 1, 1}, {0, -kInfinity, 0}}, 1, {0, 4, 8}, 12)).points;
  ASSERT_EQ(points.size(), 3U);
  EXPECT_TRUE(std::isnan(points[0].x()));
  EXPECT_EQ(points[1].x(), kInfinity);
  EXPECT_EQ(points[2].y(), -kInfinity);
}

TEST(CloudConversion, NoPointsAreAnEmptyScan) {
  EXPECT_TRUE(toLidarScan(PointCloud2()).points.empty());
  EXPECT_TRUE(toLidarScan(makeCloud({}, 1, {0, 4, 8}, 16)).points.empty());
  PointCloud2 columns_only = makeCloud({}, 1, {0, 4, 8}, 16);
  columns_only.height = 0;
  columns_only.width = 4000000000U;
  EXPECT_TRUE(toLidarScan(columns_only, true).points.empty());
}

struct Hostile {
  const char* name;
  std::function<void(PointCloud2&)> spoil;
  const char* expected;  // in the message
};

const std::vector<Hostile> kHostile{
    {"no x", [](auto& c) { c.fields[0].name = "a"; }, "no field x"},
    {"no y", [](auto& c) { c.fields.erase(c.fields.begin() + 1); }, "no field y"},
    {"no fields", [](auto& c) { c.fields.clear(); }, "no field x"},
    {"two z", [](auto& c) { c.fields.push_back(makeField("z", 12)); }, "two fields z"},
    {"doubles", [](auto& c) { c.fields[2].datatype = PointField::FLOAT64; }, "datatype 8; it must be 7"},
    {"unknown datatype", [](auto& c) { c.fields[0].datatype = 255; }, "datatype 255"},
    {"three x in one", [](auto& c) { c.fields[0].count = 3; }, "count 3"},
    {"no x in one", [](auto& c) { c.fields[0].count = 0; }, "count 0"},
    {"point_step of zero", [](auto& c) { c.point_step = 0; }, "point_step must be at least"},
    {"point_step too small", [](auto& c) { c.point_step = 11; }, "point_step must be at least 12; it is 11"},
    {"field beyond the point", [](auto& c) { c.fields[1].offset = 13; }, "must be at least 17"},
    {"field at the end of the address space", [](auto& c) { c.fields[1].offset = 0xFFFFFFFFU; }, "offset 4294967295"},
    {"overlapping fields", [](auto& c) { c.fields[1].offset = 2; }, "4 bytes apart"},
    {"the same field", [](auto& c) { c.fields[2].offset = 0; }, "4 bytes apart"},
    {"point_step too large", [](auto& c) { c.point_step = 17; }, "row_step is 64; it must be at least"},
    {"row_step too small", [](auto& c) { c.row_step = 63; }, "row_step is 63"},
    {"row_step of zero", [](auto& c) { c.row_step = 0; }, "row_step is 0"},
    {"row_step too large", [](auto& c) { c.row_step = 65; }, "must have height * row_step"},
    {"data cut short", [](auto& c) { c.data.resize(63); }, "data has 63 bytes"},
    {"no data", [](auto& c) { c.data.clear(); }, "data has 0 bytes"},
    {"too much data", [](auto& c) { c.data.resize(65); }, "data has 65 bytes"},
    {"too many rows", [](auto& c) { c.height = 2; }, "must have height * row_step = 2 * 64"},
    {"four billion points", [](auto& c) { c.width = 4000000000U; }, "4000000000 * 16 = 64000000000"},
    {"four billion points in a matching row",
     [](auto& c) {
       c.width = 4000000000U;
       c.point_step = 1;
       c.row_step = c.width;
     },
     "point_step must be at least"},
    {"sizes whose product wraps to the data's",
     [](auto& c) {
       c.width = 0x10000000U;  // times 16 is 2^32
       c.row_step = 0;
       c.height = 0xFFFFFFFFU;
       c.data.clear();
     },
     "row_step is 0; it must be at least"},
    {"largest of all", [](auto& c) { c.width = c.height = c.row_step = c.point_step = 0xFFFFFFFFU; },
     "18446744065119617025"},
    {"data without points", [](auto& c) { c.width = 0; }, "it must have none"},
};

TEST(CloudConversion, EveryContradictionIsNamed) {
  for (const Hostile& hostile : kHostile) {
    SCOPED_TRACE(hostile.name);
    PointCloud2 cloud = makePlainCloud();
    hostile.spoil(cloud);
    try {
      toLidarScan(cloud, true);
      ADD_FAILURE() << "was taken for a good cloud";
    } catch (const MalformedCloud& fault) {
      EXPECT_NE(std::string(fault.what()).find(hostile.expected), std::string::npos) << fault.what();
    }
  }
}

// A number that headers like to break at.
std::uint32_t drawSize(atom_map::Random& random) {
  static constexpr std::array<std::uint32_t, 14> kSizes{
      0, 1, 3, 4, 11, 12, 16, 0x10000000, 0x7FFFFFFF, 0x80000000, 0xFFFF, 0xFFFFFFFC, 0xFFFFFFFF, 64};
  const std::uint64_t draw = random.next();
  return draw % 4 == 0 ? static_cast<std::uint32_t>(draw >> 32) % 100 : kSizes[(draw >> 32) % kSizes.size()];
}

void spoil(PointCloud2& cloud, atom_map::Random& random) {
  const auto any_field = [&]() -> PointField& { return cloud.fields[random.next() % cloud.fields.size()]; };
  switch (random.next() % 9) {
    case 0:
      cloud.width = drawSize(random);
      break;
    case 1:
      cloud.height = drawSize(random);
      break;
    case 2:
      cloud.point_step = drawSize(random);
      break;
    case 3:
      cloud.row_step = drawSize(random);
      break;
    case 4:
      cloud.data.resize(random.next() % 200);
      break;
    case 5:
      any_field().offset = drawSize(random);
      break;
    case 6:
      any_field().datatype = static_cast<std::uint8_t>(random.next() % 10);
      break;
    case 7:
      any_field().count = static_cast<std::uint32_t>(random.next() % 3);
      break;
    default:
      any_field().name = std::string(1, "xyzw"[random.next() % 4]);
  }
}

// Never anything but MalformedCloud, never more points than the data holds. (Run under AddressSanitizer by hand.)
TEST(CloudConversion, SurvivesRandomHeaders) {
  atom_map::Random random(2);
  int good = 0;
  constexpr int kClouds = 200000;
  for (int i = 0; i < kClouds; ++i) {
    PointCloud2 cloud = makeCloud(kPoints, 2, {0, 4, 8}, 16);
    for (std::uint64_t faults = random.next() % 4; faults > 0; --faults) spoil(cloud, random);
    try {
      const auto scan = toLidarScan(cloud, true);
      ASSERT_EQ(scan.points.size(), std::uint64_t{cloud.width} * cloud.height);
      ASSERT_LE(scan.points.size() * 12, cloud.data.size());
      ++good;
    } catch (const MalformedCloud&) {
    }
  }
  EXPECT_GT(good, kClouds / 10);
  EXPECT_LT(good, kClouds / 2);
}

}  // namespace
}  // namespace atom_mapping
