// The only file that is compiled with the commit, so that a new commit compiles no other.
#include <fstream>

#include "table.h"

namespace talus {
namespace {

std::string first_line_with(const std::string& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with(key) && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

}  // namespace

BuildFacts build_facts() {
  return {TALUS_COMMIT, TALUS_COMPILER, TALUS_FLAGS, first_line_with("/proc/cpuinfo", "model name")};
}

}  // namespace talus
