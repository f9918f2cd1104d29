// Runs other programs, for tests of what is written for them.
#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

namespace talus {

// What a shell command prints.
inline std::string output_of(const std::string& command) {
  std::string out;
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "cannot run " + command;
  char part[65536];
  while (const std::size_t count = std::fread(part, 1, sizeof part, pipe)) out.append(part, count);
  pclose(pipe);
  return out;
}

inline void put_file(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

}  // namespace talus
