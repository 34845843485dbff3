#pragma once

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>

#include "atom_mapping/base/keep_memory.h"

namespace atom_mapping {

// Parses the arguments, then calls run(). Returns the program's exit code: 2 where an argument is wrong or run() throws,
// which stderr tells after the program's name (the app's).
template <class Run>
int runProgram(CLI::App& app, int argc, char** argv, Run&& run) {
  const auto fail = [&app](const std::exception& fault) {
    std::cerr << app.get_name() << ": " << fault.what() << std::endl;
    return 2;
  };
  atom_map::keepFreedMemory();
  try {
    app.parse(argc, argv);
    run();
  } catch (const CLI::ParseError& fault) {
    return fault.get_exit_code() == 0 ? app.exit(fault) : fail(fault);  // 0: --help
  } catch (const std::exception& fault) {
    return fail(fault);
  }
  return 0;
}

}  // namespace atom_mapping
