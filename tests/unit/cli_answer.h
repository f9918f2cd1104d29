// Runs the command line in the tests' own process.
#pragma once

#include <sstream>
#include <string>
#include <vector>

#include "cli/cli.h"

namespace talus {

// What a command printed, and its exit status.
struct CliAnswer {
  int status;
  std::string out, err;
};

inline CliAnswer cli_answer(const std::vector<std::string>& arguments) {
  std::ostringstream out, err;
  const int status = run_cli(arguments, out, err);
  return {status, out.str(), err.str()};
}

}  // namespace talus
