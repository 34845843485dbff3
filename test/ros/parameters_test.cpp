#include <XmlRpcValue.h>
#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <stdexcept>

#include "atom_mapping/ros/read_parameters.h"
#include "print_parameters.h"

namespace atom_mapping {
namespace {

std::map<std::string, std::string> print(const Parameters& parameters) {
  ParameterPrinter printer;
  atom_map::forEachParameter(parameters.mapping, printer);
  forEachNodeParameter(parameters.node, printer);
  return printer.texts;
}

Parameters readYaml(const std::string& text) {
  return readParameters(flatten(YAML::Load(text)));
}

// Of all faults; empty if there is none.
std::string faultsOf(const std::string& yaml) {
  try {
    readYaml(yaml);
    return "";
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
}

std::size_t countLines(const std::string& text) {
  return text.empty() ? 0 : static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1;
}

TEST(Parameters, TheConfigFileRepeatsEveryDefault) {
  const std::string here = __FILE__;
  const std::string root = here.substr(0, here.rfind("/test/ros/"));
  const ParameterValues values = flatten(YAML::LoadFile(root + "/config/atom_mapping.yaml"));
  const auto defaults = print(Parameters());
  EXPECT_EQ(print(readParameters(values)), defaults);
  for (const auto& [name, text] : defaults) EXPECT_EQ(values.count(name), 1U) << name << " is not in the file";
  EXPECT_EQ(values.size(), defaults.size());
}

TEST(Parameters, NothingGivesTheDefaults) {
  EXPECT_EQ(print(readParameters({})), print(Parameters()));
  EXPECT_EQ(print(readYaml("")), print(Parameters()));
}

TEST(Parameters, ValuesArrive) {
  const Parameters p = readYaml(
      "{radius: 0.1, seed: 4294967295, mode: signed_distance, map_frame: odom, scan: {max_range: 50, clear_no_returns: "
      "true},"
      " occupancy/max_log_odds: 2.5, publish: {color: distance, max_markers: 7}, services/max_points: 10,"
      " limits: {max_atoms: 1000000, max_megabytes: 20, policy: forget_farthest, window: 60}}");
  EXPECT_EQ(p.mapping.radius, 0.1);
  EXPECT_EQ(p.mapping.seed, 4294967295U);
  EXPECT_EQ(p.mapping.mode, atom_map::Mode::kSignedDistance);
  EXPECT_EQ(p.mapping.map_frame, "odom");
  EXPECT_EQ(p.mapping.scan.max_range, 50.0);  // a whole number where any will do
  EXPECT_TRUE(p.mapping.scan.clear_no_returns);
  EXPECT_EQ(p.mapping.occupancy.max_log_odds, 2.5);
  EXPECT_EQ(p.node.publish.color, AtomColor::kDistance);
  EXPECT_EQ(p.node.publish.max_markers, 7U);
  EXPECT_EQ(p.node.services.max_points, 10U);
  EXPECT_EQ(p.mapping.limits.max_atoms, 1000000U);
  EXPECT_EQ(p.mapping.limits.max_megabytes, 20.0);
  EXPECT_EQ(p.mapping.limits.policy, atom_map::LimitPolicy::kForgetFarthest);
  EXPECT_EQ(p.mapping.limits.window, 60.0);
}

TEST(Parameters, EveryFaultIsNamedAtOnce) {
  const std::string faults = faultsOf(
      "{radius: -1, raduis: 0.5, mode: octree, seed: 1.5, map_frame: 7,"
      " scan: {max_range: far, min_range: [1, 2], thinning: true, clear_no_returns: 1, normals: {k: 3}},"
      " publish: {color: red, period: 0}, input/queue_size: -1, services:  , rays: 5}");
  for (const char* expected :
       {"radius is -1; it must be a number, at least 0.01 and at most 100", "raduis is no parameter",
        "mode is 'octree'; it must be occupancy or signed_distance", "seed is 1.5; it must be a whole number",
        "map_frame is 7; it must be a text",
        "scan/max_range is 'far'; it must be a number, more than 0 and at most 1000", "scan/min_range is a list",
        "scan/thinning is true", "scan/clear_no_returns is 1; it must be true or false",
        "scan/normals/k is no parameter", "publish/color is 'red'; it must be distance or height or occupancy",
        "publish/period is 0", "input/queue_size is -1; it must be a whole number, at least 1",
        "services is no parameter", "rays is no parameter"}) {
    EXPECT_NE(faults.find(expected), std::string::npos) << expected << "\nis not in\n" << faults;
  }
  EXPECT_EQ(countLines(faults), 15U) << faults;
}

TEST(Parameters, NumbersThatAreNoneAreRefused) {
  for (const char* yaml : {"radius: .nan", "radius: .inf", "radius: 1e400", "radius: ''", "radius: '0.5'", "radius: ~",
                           "seed: -1", "seed: 4294967296", "radius: {}"}) {
    EXPECT_EQ(countLines(faultsOf(yaml)), std::string(yaml) == "radius: {}" ? 0U : 1U)
        << yaml << ": " << faultsOf(yaml);
  }
}

TEST(Parameters, FaultsBetweenParametersAreNamed) {
  EXPECT_NE(faultsOf("{scan: {min_range: 10, max_range: 5}}").find("scan/min_range is 10"), std::string::npos);
  EXPECT_NE(faultsOf("limits/window: 20").find("limits/window is 20; it must be 0 or at least scan/max_range"),
            std::string::npos);
  EXPECT_NE(faultsOf("map_frame: ''").find("map_frame is empty"), std::string::npos);
  EXPECT_NE(faultsOf("publish/color: distance").find("which mode occupancy does not know"), std::string::npos);
  EXPECT_NE(faultsOf("{mode: signed_distance, publish/color: occupancy}").find("must be height or distance"),
            std::string::npos);
}

TEST(Parameters, TheParameterServersValuesReadTheSame) {
  XmlRpc::XmlRpcValue root;
  root["radius"] = 1;
  root["map_frame"] = std::string("odom");
  root["scan"]["max_range"] = 12.5;
  root["scan"]["clear_no_returns"] = XmlRpc::XmlRpcValue(true);
  const Parameters p = readParameters(flatten(root));
  EXPECT_EQ(p.mapping.radius, 1.0);
  EXPECT_EQ(p.mapping.map_frame, "odom");
  EXPECT_EQ(p.mapping.scan.max_range, 12.5);
  EXPECT_TRUE(p.mapping.scan.clear_no_returns);
  root["scan"]["max_range"] = XmlRpc::XmlRpcValue("12.5");
  root["rays"][1] = 5;
  EXPECT_THROW(readParameters(flatten(root)), std::invalid_argument);
  EXPECT_TRUE(flatten(XmlRpc::XmlRpcValue()).empty());
}

TEST(Parameters, ARootThatIsNoMapIsRefused) {
  EXPECT_THROW(flatten(YAML::Load("[1, 2]")), std::invalid_argument);
  EXPECT_THROW(flatten(YAML::Load("radius")), std::invalid_argument);
  EXPECT_THROW(flatten(XmlRpc::XmlRpcValue(3)), std::invalid_argument);
}

}  // namespace
}  // namespace atom_mapping
