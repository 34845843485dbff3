#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/base/describe_parameters.h"
#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/io/map_stream.h"

namespace atom_map {
namespace {

using namespace map_file;
using Receive = std::function<void(void*, std::size_t)>;

template <class Number>
Number receiveNumber(const Receive& receive) {
  Number number{};
  receive(&number, sizeof number);
  return number;
}

// For forEachParameter.
struct ParameterReceiver {
  const Receive& receive;

  template <class Number>
  void operator()(const char* /*name*/, Number& value, const Range& /*range*/) const {
    value = receiveNumber<Number>(receive);
  }
  void operator()(const char* name, std::string& value) const {
    const auto size = receiveNumber<std::uint64_t>(receive);
    if (size > kLongestText) fail(name, " has ", size, " bytes; it may have ", kLongestText);
    value.resize(size);
    receive(value.data(), size);
  }
  void operator()(const char* /*name*/, bool& value) const { value = receiveNumber<std::uint8_t>(receive) != 0; }
  void operator()(const char* /*name*/, Mode& value) const {
    value = receiveNumber<std::uint8_t>(receive) == 0 ? Mode::kOccupancy : Mode::kSignedDistance;
  }
  void operator()(const char* /*name*/, LimitPolicy& value) const {
    value = receiveNumber<std::uint8_t>(receive) == 0 ? LimitPolicy::kRefuse : LimitPolicy::kForgetFarthest;
  }
};

Eigen::Vector3d receiveOrigin(const Receive& receive) {
  Eigen::Vector3d origin;
  receive(origin.data(), 3 * sizeof(double));
  if (!origin.allFinite() || origin != Eigen::Vector3d(origin.array().round())) {
    fail("origin is (", origin.transpose(), "); it must be of whole metres");
  }
  return origin;
}

bool isPossible(const std::array<float, 2>& values, const MappingParameters& parameters) {
  if (parameters.mode == Mode::kSignedDistance) {
    return std::isfinite(values[0]) && std::isfinite(values[1]) && values[1] >= 0.0F;
  }
  return std::abs(values[0]) <= static_cast<float>(parameters.occupancy.max_log_odds);
}

// m, from the origin along each axis. Beyond, the index does not tell places apart.
float farthest(const AtomMap& map) {
  return 0x1p30F * map.radius();
}

bool isPlace(const Eigen::Vector3f& point, const AtomMap& map) {
  return point.allFinite() && point.cwiseAbs().maxCoeff() <= farthest(map);
}

void addAtom(std::uint64_t row, const Eigen::Vector3f& center, const std::array<float, 2>& values,
             const MappingParameters& parameters, AtomMap& map) {
  const float rounding = 1e-6F * center.cwiseAbs().maxCoeff();  // of atoms that were moved
  const float reach = std::max(0.0F, (1.0F - 1e-5F) * AtomMap::kOverlapTolerance * 2.0F * map.radius() - rounding);
  if (!isPlace(center, map)) {
    fail("centers[", row, "] is (", center.transpose(), "); it must be of numbers within ", farthest(map), " m");
  }
  if (!isPossible(values, parameters)) {
    fail("atom ", row, " holds ", values[0], ", ", values[1], ", which mode ", nameOf(parameters.mode), " never gives");
  }
  map.atoms().forEachWithin(center, reach, [&](ConstAtomRef, float squared_distance) {
    fail("centers[", row, "] lies ", std::sqrt(squared_distance), " m from another atom's; no two lie nearer than ",
         reach, " m");
  });
  map.atoms().insert(center, values.data());
}

// Calls visit(row's number, its `width` values) for each row. Stretch by stretch, so that a lie about how many there are costs
// no memory.
template <class Visit>
void receiveRows(std::uint64_t count, std::size_t width, const Receive& receive, Visit&& visit) {
  std::vector<std::vector<float>> stretch(width);
  std::vector<float> row(width);
  for (std::uint64_t begin = 0; begin < count; begin += kChunk) {
    const auto rows = static_cast<std::size_t>(std::min(kChunk, count - begin));
    for (std::vector<float>& column : stretch) {
      column.resize(rows);
      receive(column.data(), rows * sizeof(float));
    }
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t c = 0; c < width; ++c) row[c] = stretch[c][i];
      visit(begin + i, row);
    }
  }
}

void receiveAtoms(const MappingParameters& parameters, const Receive& receive, AtomMap& map) {
  const auto count = receiveNumber<std::uint64_t>(receive);
  const std::size_t width = 3 + valueNames(parameters.mode).size();
  receiveRows(count, width, receive, [&](std::uint64_t i, const std::vector<float>& row) {
    addAtom(i, {row[0], row[1], row[2]}, {row[3], width > 4 ? row[4] : 0.0F}, parameters, map);
  });
}

void receivePlanes(const Receive& receive, AtomMap& map) {
  constexpr float kMostFits = 1e6F;
  constexpr std::uint64_t kMostPlanes = 1'000'000;  // more than the returns of any scan tell of
  const auto count = receiveNumber<std::uint64_t>(receive);
  if (count > kMostPlanes) fail("it tells of ", count, " known planes; it may of ", kMostPlanes);
  receiveRows(count, kPlaneWidth, receive, [&](std::uint64_t i, const std::vector<float>& row) {
    const KnownPlane plane{{row[0], row[1], row[2]}, {row[3], row[4], row[5]}, row[6], row[7]};
    const bool is_finite = isPlace(plane.place, map) && plane.normal.allFinite() && std::isfinite(plane.level);
    const bool is_plane = is_finite && std::abs(plane.normal.norm() - 1.0F) < 1e-3F;
    if (!is_plane || !(plane.fits >= 1.0F && plane.fits <= kMostFits)) fail("known_planes[", i, "] is no plane");
    map.planes().push_back(plane);
  });
}

}  // namespace

LoadedMap receiveMap(const Receive& receive) {
  MappingParameters parameters;
  forEachParameter(parameters, ParameterReceiver{receive});
  throwIfFaulty(parameters);
  const auto scans = receiveNumber<std::uint64_t>(receive);
  LoadedMap loaded{parameters, scans, AtomMap(parameters.mode, parameters.radius)};
  loaded.map.anchor(receiveOrigin(receive));
  receiveAtoms(parameters, receive, loaded.map);
  receivePlanes(receive, loaded.map);
  return loaded;
}

}  // namespace atom_map
