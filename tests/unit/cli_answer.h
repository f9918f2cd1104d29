// Runs the command line in the tests' own process.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

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

// The exit status of a command in a process of its own, for `talus shot`: OpenGL does not work in a process
// that is forked after it has begun, and its driver never frees some of its memory, which is no leak here.
inline int status_of_own_process(const std::vector<std::string>& arguments) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(cli_answer(arguments).status);
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace talus
