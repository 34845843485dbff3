#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/base/describe_parameters.h"
#include "atom_mapping/io/map_file_format.h"
#include "atom_mapping/io/map_stream.h"

namespace atom_map {
namespace {

using namespace map_file;
using Receive = std::function<void(void*, std::size_t)>;

template <class... Parts>
[[noreturn]] void fail(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  throw std::runtime_error(text.str());
}

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

void addAtom(std::uint64_t row, const Eigen::Vector3f& center, const std::array<float, 2>& values,
             const MappingParameters& parameters, AtomMap& map) {
  const float rounding = 1e-6F * center.cwiseAbs().maxCoeff();  // of atoms that were moved
  const float reach = (1.0F - 1e-5F) * AtomMap::kOverlapTolerance * 2.0F * map.radius() - rounding;
  const float farthest = 0x1p30F * map.radius();  // beyond, the index does not tell places apart
  if (!center.allFinite() || center.cwiseAbs().maxCoeff() > farthest) {
    fail("centers[", row, "] is (", center.transpose(), "); it must be of numbers within ", farthest, " m");
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

// Stretch by stretch, so that a lie about how many there are costs no memory.
void receiveAtoms(std::uint64_t count, const MappingParameters& parameters, const Receive& receive, AtomMap& map) {
  const std::size_t width = 3 + valueNames(parameters.mode).size();
  std::array<std::vector<float>, 5> stretch;
  for (std::uint64_t begin = 0; begin < count; begin += kChunk) {
    const auto rows = static_cast<std::size_t>(std::min(kChunk, count - begin));
    for (std::size_t c = 0; c < width; ++c) {
      stretch[c].resize(rows);
      receive(stretch[c].data(), rows * sizeof(float));
    }
    for (std::size_t i = 0; i < rows; ++i) {
      const std::array<float, 2> values{stretch[3][i], width > 4 ? stretch[4][i] : 0.0F};
      addAtom(begin + i, Eigen::Vector3f(stretch[0][i], stretch[1][i], stretch[2][i]), values, parameters, map);
    }
  }
}

}  // namespace

LoadedMap receiveMap(const Receive& receive) {
  MappingParameters parameters;
  forEachParameter(parameters, ParameterReceiver{receive});
  throwIfFaulty(parameters);
  const auto scans = receiveNumber<std::uint64_t>(receive);
  LoadedMap loaded{parameters, scans, AtomMap(parameters.mode, parameters.radius)};
  loaded.map.anchor(receiveOrigin(receive));
  receiveAtoms(receiveNumber<std::uint64_t>(receive), parameters, receive, loaded.map);
  return loaded;
}

}  // namespace atom_map
