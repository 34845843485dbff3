// Starts a program of the package as a user would, with a roscore out of reach.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "../test_folder.h"

namespace atom_mapping {

struct ProgramResult {
  int exit_code;
  std::string out;
  std::string err;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

// `folder`: for what it prints. The programs lie beside the test.
inline ProgramResult runProgram(const std::string& name, const std::string& arguments,
                                const std::filesystem::path& folder) {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
  const std::string command = "ROS_MASTER_URI=http://127.0.0.1:1 " + program.string() + " " + arguments + " >" +
                              (folder / "out").string() + " 2>" + (folder / "err").string();
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder / "out"), contents(folder / "err")};
}

}  // namespace atom_mapping
