// The program: arguments -> editor or sub-command.

#include <csignal>
#include <iostream>
#include <string>
#include <vector>

#include "cli/cli.h"

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a write error, as a full disk is
  return talus::run_cli(std::vector<std::string>(argv + 1, argv + argc), std::cout, std::cerr);
}
