#include "state_lines.h"

#include <filesystem>
#include <sstream>

#include "formats/files/atomic_file.h"
#include "formats/files/held_file.h"

namespace talus {

std::vector<std::string> read_state_lines(const std::string& store, std::size_t most) {
  std::vector<std::string> all;
  if (store.empty()) return all;
  std::istringstream lines(read_file(store, most).value_or(""));
  for (std::string line; std::getline(lines, line);) all.push_back(std::move(line));
  return all;
}

tl::expected<void, std::string> change_state_lines(
    const std::string& store, std::size_t most,
    const std::function<void(std::vector<std::string>&)>& change) {
  if (store.empty()) return {};
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(store).parent_path(), ignored);
  const FileLock lock(store);
  std::vector<std::string> lines = read_state_lines(store, most);
  change(lines);
  std::size_t bytes = 0;
  auto first = lines.end();
  while (first != lines.begin() && (bytes += (first - 1)->size() + 1) <= most) --first;
  std::string text;
  for (; first != lines.end(); ++first) text.append(*first).append("\n");
  if (const auto written = write_file_atomic(store, text); !written)
    return tl::unexpected(store + " " + written.error().message);
  return {};
}

}  // namespace talus
