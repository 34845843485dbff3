// Checks of what requests hold; each throws a Refusal that names the element, its value and what is expected.
#pragma once

#include <geometry_msgs/Point.h>
#include <geometry_msgs/Vector3.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <stdexcept>
#include <string>

namespace atom_mapping {

class Refusal : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Where it is: "points[3]", or the name alone for what is no array.
std::string element(const char* array, std::size_t index);

// Within kFarthest.
Eigen::Vector3d checkedPoint(const std::string& where, const geometry_msgs::Point& point);

// Between two corners, as checkedPoint, the lower one first.
Eigen::AlignedBox3d checkedBox(const geometry_msgs::Point& min, const geometry_msgs::Point& max);

// A vector of any length but zero; returns its direction.
Eigen::Vector3d checkedDirection(const std::string& where, const geometry_msgs::Vector3& vector);

// Finite and not negative.
float checkedLength(const std::string& where, float length);

// A sphere's radius: as checkedLength and, unless unknown is free, at most `largest`.
float checkedSphere(const std::string& where, float radius, float largest, bool unknown_is_free);

// The absolute path of a file that a request names, from where the node runs; neither empty nor with a zero byte in it, where
// the system would take it to end.
std::string checkedFile(const std::string& file);

// At most `max_points` elements, as services/max_points permits.
void checkSize(const char* array, std::size_t size, std::size_t max_points);

void checkEqualSizes(const char* a, std::size_t size_a, const char* b, std::size_t size_b);

}  // namespace atom_mapping
