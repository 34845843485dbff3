#include "atom_mapping/ros/check_request.h"

#include <cmath>
#include <filesystem>
#include <sstream>

#include "atom_mapping/ros/pose_conversion.h"

namespace atom_mapping {
namespace {

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw Refusal(text.str());
}

}  // namespace

std::string element(const char* array, std::size_t index) {
  return array + ("[" + std::to_string(index) + "]");
}

Eigen::Vector3d checkedPoint(const std::string& where, const geometry_msgs::Point& point) {
  const Eigen::Vector3d p(point.x, point.y, point.z);
  if (p.hasNaN() || p.cwiseAbs().maxCoeff() > kFarthest) {
    refuse(where, " is (", p.transpose(), "); its coordinates must be numbers within ", kFarthest, " m");
  }
  return p;
}

Eigen::AlignedBox3d checkedBox(const geometry_msgs::Point& min, const geometry_msgs::Point& max) {
  const Eigen::AlignedBox3d box(checkedPoint("min", min), checkedPoint("max", max));
  if (box.isEmpty()) {
    refuse("a coordinate of min is greater than that of max; min must be the lower corner of the box");
  }
  return box;
}

Eigen::Vector3d checkedDirection(const std::string& where, const geometry_msgs::Vector3& vector) {
  const Eigen::Vector3d v(vector.x, vector.y, vector.z);
  const double length = v.stableNorm();
  if (!std::isfinite(length) || length == 0.0) {
    refuse(where, " is (", v.transpose(), "); it must be a finite vector other than zero");
  }
  return v.stableNormalized();
}

float checkedLength(const std::string& where, float length) {
  if (!std::isfinite(length) || length < 0.0F) refuse(where, " is ", length, "; it must be finite and not negative");
  return length;
}

float checkedSphere(const std::string& where, float radius, float largest, bool unknown_is_free) {
  if (checkedLength(where, radius) > largest && !unknown_is_free) {
    refuse(where, " is ", radius, " m; it must be at most ", largest, " m, unless unknown_is_free is set");
  }
  return radius;
}

std::string checkedFile(const std::string& file) {
  if (file.empty()) refuse("file is empty; name one, such as /tmp/map.h5");
  if (file.find('\0') != std::string::npos) refuse("file holds a zero byte; name one without");
  return std::filesystem::absolute(file).string();
}

void checkSize(const char* array, std::size_t size, std::size_t max_points) {
  if (size <= max_points) return;
  refuse(array, " has ", size, " elements; services/max_points permits ", max_points, ": ask in several requests");
}

void checkEqualSizes(const char* a, std::size_t size_a, const char* b, std::size_t size_b) {
  if (size_a != size_b) {
    refuse(a, " has ", size_a, " elements and ", b, " has ", size_b, "; they must have equally many");
  }
}

}  // namespace atom_mapping
