#include "atom_mapping/ros/baseline_parameters.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <stdexcept>

#include "atom_mapping/ros/read_parameters.h"
#include "print_parameters.h"

namespace atom_mapping {
namespace {

std::map<std::string, std::string> print(const BaselineParameters& parameters) {
  ParameterPrinter printer;
  forEachBaselineParameter(parameters, printer);
  return printer.texts;
}

std::string faultsOf(const std::string& yaml) {
  try {
    readBaselineParameters(flatten(YAML::Load(yaml)));
    return "";
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
}

TEST(BaselineParameters, TheConfigFileRepeatsEveryDefault) {
  const std::string here = __FILE__;
  const ParameterValues values =
      readParameterFile(here.substr(0, here.rfind("/test/ros/")) + "/config/octomap_baseline.yaml");
  const auto defaults = print(BaselineParameters());
  EXPECT_EQ(print(readBaselineParameters(values)), defaults);
  for (const auto& [name, text] : defaults) EXPECT_EQ(values.count(name), 1U) << name << " is not in the file";
  EXPECT_EQ(values.size(), defaults.size());
  EXPECT_EQ(defaults.size(), 13U);
}

TEST(BaselineParameters, FaultsAreNamedAtOnce) {
  EXPECT_EQ(faultsOf("{radius: 1, resolution: 0.4, prune: true, scan: {max_range: 40}}"), "");
  const std::string faults = faultsOf("{radius: big, prune: 1, scan: {max_range: -1, range_noise: 0.1}}");
  for (const char* expected : {"radius is 'big'", "prune is 1; it must be true or false", "scan/max_range is -1",
                               "scan/range_noise is no parameter; config/octomap_baseline.yaml lists them all"}) {
    EXPECT_NE(faults.find(expected), std::string::npos) << expected << "\nis not in\n" << faults;
  }
  EXPECT_NE(faultsOf("resolution: 0.001").find("resolution is 0.001; it must be 0 or at least 0.01"),
            std::string::npos);
}

}  // namespace
}  // namespace atom_mapping
