// One line for each file: its content as 16 hexadecimal digits, a blank, its path.
#include "export_record.h"

#include <charconv>
#include <filesystem>
#include <sstream>
#include <utility>

#include "formats/files/atomic_file.h"
#include "formats/files/held_file.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr int kHex = 16;

std::string whole_record_path(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  return (error ? fs::path(path) : whole).lexically_normal().string();
}

}  // namespace

ExportRecord::ExportRecord(std::string file) : file_(std::move(file)) { refresh(); }

bool ExportRecord::refresh() {
  const auto text = file_.empty() ? FormatResult<std::string>() : read_file(file_);
  std::error_code ignored;
  if (!text) return fs::status(file_, ignored).type() == fs::file_type::not_found;
  if (file_.empty()) return true;
  contents_.clear();
  std::istringstream lines(*text);
  std::string line;
  while (std::getline(lines, line)) {
    std::uint64_t content = 0;
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), content, kHex);
    const auto at = static_cast<std::size_t>(end - line.data());
    if (error == std::errc() && at + 1 < line.size()) contents_[line.substr(at + 1)] = content;
  }
  for (const auto& [path, content] : noted_) contents_[path] = content;
  return true;
}

bool ExportRecord::has(const std::string& path, std::uint64_t content) const {
  const auto found = contents_.find(whole_record_path(path));
  return found != contents_.end() && found->second == content;
}

bool ExportRecord::knows(const std::string& path) const {
  return contents_.contains(whole_record_path(path));
}

void ExportRecord::note(const std::string& path, std::uint64_t content) {
  const std::string whole = whole_record_path(path);
  contents_[whole] = noted_[whole] = content;
}

tl::expected<void, std::string> ExportRecord::save() {
  if (file_.empty() || noted_.empty()) return {};
  const auto failure = [&](const std::string& why) {
    return tl::unexpected("Cannot save which files were exported, so Talus will ask about them again: " +
                          file_ + " " + why + ".");
  };
  std::error_code ignored;
  fs::create_directories(fs::path(file_).parent_path(), ignored);
  const FileLock lock(file_);
  if (!refresh()) return failure("cannot be read");
  if (contents_.size() > kMostFiles)
    std::erase_if(contents_, [&](const auto& entry) { return !fs::exists(entry.first, ignored); });
  std::ostringstream text;
  for (const auto& [path, content] : contents_) {
    // A path with a line break would be read as another one.
    if (path.find('\n') == std::string::npos) text << std::hex << content << ' ' << path << '\n';
  }
  if (const auto written = write_file_atomic(file_, text.str()); !written)
    return failure(written.error().message);
  noted_.clear();
  return {};
}

}  // namespace talus
