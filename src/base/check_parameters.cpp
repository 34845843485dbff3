#include "atom_mapping/base/check_parameters.h"

#include <sstream>
#include <stdexcept>

#include "atom_mapping/base/describe_parameters.h"

namespace atom_map {
namespace {

struct FaultFinder {
  std::vector<std::string>& faults;

  template <class Number>
  void operator()(const char* name, Number value, const Range& range) const {
    if (range.contains(static_cast<double>(value))) return;
    std::ostringstream fault;
    fault << name << " is " << value << "; it must " << (range.or_zero ? "be 0 or " : "") << "lie between " << range.low
          << (range.open ? " (excluded)" : "") << " and " << range.high;
    faults.push_back(fault.str());
  }

  template <class Other>
  void operator()(const char* /*name*/, const Other& /*value*/) const {}
};

}  // namespace

std::vector<std::string> findFaults(const MappingParameters& parameters) {
  std::vector<std::string> faults;
  forEachParameter(parameters, FaultFinder{faults});
  if (parameters.map_frame.empty()) faults.emplace_back("map_frame is empty; name a frame, such as map");
  if (parameters.scan.min_range >= parameters.scan.max_range) {
    std::ostringstream fault;
    fault << "scan/min_range is " << parameters.scan.min_range << "; it must be less than scan/max_range, which is "
          << parameters.scan.max_range;
    faults.push_back(fault.str());
  }
  const double window = parameters.limits.window;
  if (window > 0.0 && window < parameters.scan.max_range) {
    std::ostringstream fault;
    fault << "limits/window is " << window << "; it must be 0 or at least scan/max_range, which is "
          << parameters.scan.max_range << ": lower that for a smaller window";
    faults.push_back(fault.str());
  }
  return faults;
}

void throwIfFaulty(const MappingParameters& parameters) {
  std::string message;
  for (const std::string& fault : findFaults(parameters)) message += (message.empty() ? "" : "\n") + fault;
  if (!message.empty()) throw std::invalid_argument(message);
}

}  // namespace atom_map
