#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

namespace {

struct Outcome {
  int exit_code;
  std::string output;
};

// Runs the node, which lies beside this test, until it ends.
Outcome runNode(const std::string& arguments) {
  const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
  const std::string command = "timeout 20 '" + (folder / "atom_mapping_node").string() + "' " + arguments + " 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  std::string output;
  std::array<char, 256> buffer{};
  while (fgets(buffer.data(), buffer.size(), pipe) != nullptr) output += buffer.data();
  const int status = pclose(pipe);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, output};
}

TEST(NodeParameters, FaultsStopTheNodeAndAreNamedAtOnce) {
  ros::param::set("/faulty/scan/max_range", -3);
  ros::param::set("/faulty/scan/max_rnage", 3);
  ros::param::set("/faulty/publish/color", "pink");
  const Outcome outcome = runNode("__name:=faulty _radius:=big _mode:=octree");
  EXPECT_EQ(outcome.exit_code, 1);
  for (const char* expected : {"radius is 'big'; it must be a number", "mode is 'octree'; it must be occupancy or",
                               "scan/max_range is -3; it must be a number, more than 0 and at most 1000",
                               "scan/max_rnage is no parameter", "publish/color is 'pink'"}) {
    EXPECT_NE(outcome.output.find(expected), std::string::npos) << expected << "\nis not in\n" << outcome.output;
  }
}

TEST(NodeParameters, LimitsThatCannotBeStopTheNode) {
  ros::param::set("/limitless/limits/max_atoms", -1);
  ros::param::set("/limitless/limits/max_megabytes", "all");
  ros::param::set("/limitless/limits/policy", "forget");
  ros::param::set("/limitless/limits/window", 10.0);
  const Outcome outcome = runNode("__name:=limitless");
  EXPECT_EQ(outcome.exit_code, 1);
  for (const char* expected :
       {"limits/max_atoms is -1; it must be a whole number", "limits/max_megabytes is 'all'; it must be a number",
        "limits/policy is 'forget'; it must be forget_farthest or refuse",
        "limits/window is 10; it must be 0 or at least scan/max_range, which is 25"}) {
    EXPECT_NE(outcome.output.find(expected), std::string::npos) << expected << "\nis not in\n" << outcome.output;
  }
}

TEST(NodeParameters, AParameterTreeThatIsNoneStopsTheNode) {
  ros::param::set("/scalar", 3);
  const Outcome outcome = runNode("__name:=scalar");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("no map from names to values"), std::string::npos) << outcome.output;
}

}  // namespace
