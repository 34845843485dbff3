// The ranges of the parameters keep out what the mathematics does not bear.
#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "atom_mapping/base/check_parameters.h"
#include "atom_mapping/base/describe_parameters.h"

namespace atom_map {
namespace {

// Sets each number in its turn, says which passed.
struct Setter {
  double number;
  std::string& passed;

  void operator()(const char* name, double& value, const Range& range) const {
    value = number;
    if (range.contains(value)) passed += std::string(name) + " ";
  }
  template <class... Others>
  void operator()(Others&&... /*others*/) const {}
};

std::string namesThatTake(double number) {
  MappingParameters parameters;
  std::string passed;
  forEachParameter(parameters, Setter{number, passed});
  return passed;
}

TEST(Parameters, NoneTakesWhatSquaresToInfinityNorNan) {
  for (const double number :
       {1e30, 1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN(), -1e30, -1.0}) {
    EXPECT_EQ(namesThatTake(number), "") << number;
  }
}

TEST(Parameters, ACellHasASideOrIsLeftOut) {
  MappingParameters parameters;
  for (double* const cell :
       {&parameters.scan.thinning, &parameters.scan.shared_normals, &parameters.rays.candidate_cell}) {
    const double usual = *cell;
    for (const double side : {0.0, 0.01, 10.0}) {
      *cell = side;
      EXPECT_TRUE(findFaults(parameters).empty()) << side;
    }
    for (const double side : {1e-9, 0.009, 10.1}) {
      *cell = side;
      ASSERT_EQ(findFaults(parameters).size(), 1U) << side;
      EXPECT_NE(findFaults(parameters)[0].find("it must be 0 or lie between 0.01 and 10"), std::string::npos);
    }
    *cell = usual;
  }
}

}  // namespace
}  // namespace atom_map
