// A line a file: its content as 16 hexadecimal digits, a blank, its path.
#include "export_record.h"

#include <charconv>
#include <filesystem>
#include <sstream>
#include <utility>

#include "formats/atomic_file.h"

namespace talus {
namespace {

constexpr int kHex = 16;

}  // namespace

ExportRecord::ExportRecord(std::string file) : file_(std::move(file)) {
  if (file_.empty()) return;
  const auto text = read_file(file_);
  if (!text) return;
  std::istringstream lines(*text);
  std::string line;
  while (std::getline(lines, line) && contents_.size() < kMostFiles) {
    std::uint64_t content = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), content, kHex);
    const auto at = static_cast<std::size_t>(end - line.data());
    if (error == std::errc() && at + 1 < line.size()) contents_[line.substr(at + 1)] = content;
  }
}

bool ExportRecord::has(const std::string& path, std::uint64_t content) const {
  const auto found = contents_.find(path);
  return found != contents_.end() && found->second == content;
}

void ExportRecord::note(const std::string& path, std::uint64_t content) { contents_[path] = content; }

void ExportRecord::save() const {
  if (file_.empty()) return;
  std::ostringstream text;
  for (const auto& [path, content] : contents_) {
    // A path with a line break would be read as another one.
    if (path.find('\n') == std::string::npos) text << std::hex << content << ' ' << path << '\n';
  }
  std::error_code ignored;
  std::filesystem::create_directories(std::filesystem::path(file_).parent_path(), ignored);
  (void)write_file_atomic(file_, text.str());
}

}  // namespace talus
