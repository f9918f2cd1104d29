// The headless sub-commands. Never starts SDL, except for `shot`, which draws without a screen.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace talus {

// The exit status of the program.
enum ExitStatus : int {
  kExitGood = 0,
  kExitBad = 1,    // the input is bad, or a check failed
  kExitUsage = 2,  // the command line itself is wrong
};

// Runs `talus ARGUMENTS...` (without the program's name); results go to `out`, errors to `err`, one line
// each. `edit` opens the window and blocks until it is closed. Returns an ExitStatus.
int run_cli(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err);

}  // namespace talus
