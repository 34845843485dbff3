#include "atom_mapping/ros/read_parameters.h"

#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "atom_mapping/base/check_parameters.h"

namespace atom_mapping {
namespace {

using atom_map::LimitPolicy;
using atom_map::Mode;
using atom_map::Range;

template <class... Parts>
std::string join(const Parts&... parts) {
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

std::string describe(const ParameterValue& value) {
  struct Describe {
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(int number) const { return join(number); }
    std::string operator()(double number) const { return join(number); }
    std::string operator()(const std::string& text) const { return "'" + text + "'"; }
    std::string operator()(const OtherValue& other) const { return other.kind; }
  };
  return std::visit(Describe{}, value);
}

std::string describe(const Range& range) {
  return join(range.or_zero ? "0, or " : "", range.open ? "more than " : "at least ", range.low, " and at most ",
              range.high);
}

// Fills the fields that forEachParameter shows it, and remembers what is wrong with their values.
class Reader {
 public:
  // `config`: the file that lists all names.
  Reader(const ParameterValues& values, const char* config) : values_(values), config_(config) {}

  void operator()(const char* name, double& field, const Range& range) {
    if (const auto number = findNumber(name, range, false)) field = *number;
  }

  void operator()(const char* name, std::uint32_t& field, const Range& range) {
    if (const auto number = findNumber(name, range, true)) field = static_cast<std::uint32_t>(*number);
  }

  void operator()(const char* name, bool& field) { readAs(name, field, "true or false"); }
  void operator()(const char* name, std::string& field) { readAs(name, field, "a text"); }

  void operator()(const char* name, Mode& field) {
    readChoice(name, field, {{"occupancy", Mode::kOccupancy}, {"signed_distance", Mode::kSignedDistance}});
  }

  void operator()(const char* name, LimitPolicy& field) {
    readChoice(name, field, {{"refuse", LimitPolicy::kRefuse}, {"forget_farthest", LimitPolicy::kForgetFarthest}});
  }

  void operator()(const char* name, AtomColor& field) {
    readChoice(
        name, field,
        {{"height", AtomColor::kHeight}, {"occupancy", AtomColor::kOccupancy}, {"distance", AtomColor::kDistance}});
  }

  // Lines, one a fault: those of the values read, and a line for each that nothing read.
  std::vector<std::string> faults() const {
    std::vector<std::string> all = faults_;
    for (const auto& [name, value] : values_) {
      if (known_.count(name) == 0) all.push_back(join(name, " is no parameter; ", config_, " lists them all"));
    }
    return all;
  }

 private:
  const ParameterValue* find(const char* name) {
    known_.insert(name);
    const auto found = values_.find(name);
    return found == values_.end() ? nullptr : &found->second;
  }

  void expected(const char* name, const ParameterValue& value, const std::string& what) {
    faults_.push_back(join(name, " is ", describe(value), "; it must be ", what));
  }

  std::optional<double> findNumber(const char* name, const Range& range, bool is_whole) {
    const ParameterValue* const value = find(name);
    if (value == nullptr) return std::nullopt;
    const int* const whole = std::get_if<int>(value);
    const double* const real = std::get_if<double>(value);
    const double number = whole != nullptr ? *whole : real != nullptr ? *real : std::nan("");
    if (range.contains(number) && (!is_whole || std::floor(number) == number)) return number;
    expected(name, *value, join(is_whole ? "a whole number, " : "a number, ", describe(range)));
    return std::nullopt;
  }

  template <class Field>
  void readAs(const char* name, Field& field, const char* what) {
    const ParameterValue* const value = find(name);
    if (value == nullptr) return;
    if (const Field* const given = std::get_if<Field>(value)) {
      field = *given;
    } else {
      expected(name, *value, what);
    }
  }

  template <class Choice>
  void readChoice(const char* name, Choice& field, const std::map<std::string, Choice>& choices) {
    const ParameterValue* const value = find(name);
    if (value == nullptr) return;
    const std::string* const text = std::get_if<std::string>(value);
    const auto found = text == nullptr ? choices.end() : choices.find(*text);
    if (found != choices.end()) {
      field = found->second;
      return;
    }
    std::string names;
    for (const auto& choice : choices) names += (names.empty() ? "" : " or ") + choice.first;
    expected(name, *value, names);
  }

  const ParameterValues& values_;
  const char* config_;
  std::set<std::string> known_;
  std::vector<std::string> faults_;
};

// What no single value tells.
void addFaultsBetween(const Parameters& p, std::vector<std::string>& faults) {
  for (const std::string& fault : atom_map::findFaults(p.mapping)) faults.push_back(fault);
  const bool occupancy = p.mapping.mode == Mode::kOccupancy;
  if (p.node.publish.color == (occupancy ? AtomColor::kDistance : AtomColor::kOccupancy)) {
    faults.push_back(join("publish/color is ", occupancy ? "distance" : "occupancy", ", which mode ",
                          occupancy ? "occupancy" : "signed_distance", " does not know; it must be height or ",
                          occupancy ? "occupancy" : "distance"));
  }
}

void throwIfAny(const std::vector<std::string>& faults) {
  std::string message;
  for (const std::string& fault : faults) message += (message.empty() ? "" : "\n") + fault;
  if (!message.empty()) throw std::invalid_argument(message);
}

}  // namespace

Parameters readParameters(const ParameterValues& values) {
  Parameters parameters;
  Reader reader(values, "config/atom_mapping.yaml");
  atom_map::forEachParameter(parameters.mapping, reader);
  forEachNodeParameter(parameters.node, reader);
  std::vector<std::string> faults = reader.faults();
  addFaultsBetween(parameters, faults);
  throwIfAny(faults);
  return parameters;
}

BaselineParameters readBaselineParameters(const ParameterValues& values) {
  constexpr double kFinest = 0.01;  // m; OctoMap reaches no farther than 2^15 voxels from its origin
  BaselineParameters parameters;
  Reader reader(values, "config/octomap_baseline.yaml");
  forEachBaselineParameter(parameters, reader);
  std::vector<std::string> faults = reader.faults();
  for (const std::string& fault : atom_map::findFaults(parameters.mapping)) faults.push_back(fault);
  const double resolution = parameters.octomap.resolution;
  if (resolution > 0.0 && resolution < kFinest) {
    faults.push_back(join("resolution is ", resolution, "; it must be 0 or at least ", kFinest));
  }
  throwIfAny(faults);
  return parameters;
}

}  // namespace atom_mapping
