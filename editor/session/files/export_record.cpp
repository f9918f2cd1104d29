// One line for each file: its content as 16 hexadecimal digits, a blank, its path. A path with a line break
// is
// "=" and Base64; other paths begin with "/".
#include "export_record.h"

#include <charconv>
#include <filesystem>
#include <sstream>
#include <utility>

#include "formats/files/atomic_file.h"
#include "formats/files/held_file.h"
#include "formats/text/base64.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr int kHex = 16;

std::string whole_record_path(const std::string& path) {
  std::error_code error;
  const fs::path whole = fs::absolute(path, error);
  return (error ? fs::path(path) : whole).lexically_normal().string();
}

constexpr char kEncoded = '=';

std::string record_line(const std::string& path, std::uint64_t content) {
  std::ostringstream line;
  line << std::hex << content << ' ';
  const bool is_plain = path.find('\n') == std::string::npos && !path.starts_with(kEncoded);
  line << (is_plain ? path : kEncoded + encode_base64(path)) << '\n';
  return line.str();
}

// Empty: it is damaged.
std::string path_of_text(const std::string& text) {
  return text.starts_with(kEncoded) ? decode_base64(text.substr(1)).value_or("") : text;
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
    if (error != std::errc() || at + 1 >= line.size()) continue;
    if (const std::string path = path_of_text(line.substr(at + 1)); !path.empty()) contents_[path] = content;
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
  if (contents_.size() > kMaxFiles)
    std::erase_if(contents_, [&](const auto& entry) { return !fs::exists(entry.first, ignored); });
  std::string text;
  for (const bool is_new : {true, false}) {
    for (const auto& [path, content] : contents_) {
      if (noted_.contains(path) != is_new) continue;
      const std::string line = record_line(path, content);
      if (is_new || text.size() + line.size() <= kMaxBytes) text += line;
    }
  }
  if (const auto written = write_file_atomic(file_, text); !written) return failure(written.error().message);
  noted_.clear();
  return {};
}

}  // namespace talus
