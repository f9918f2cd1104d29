// Runs other programs, for tests of the files that are written for them.
#pragma once

#include <cstdio>
#include <string>

namespace talus {

// The output of a shell command.
inline std::string output_of(const std::string& command) {
  std::string out;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "cannot run " + command;
  char part[65536];
  while (const std::size_t count = std::fread(part, 1, sizeof part, pipe)) out.append(part, count);
  pclose(pipe);
  return out;
}

}  // namespace talus
