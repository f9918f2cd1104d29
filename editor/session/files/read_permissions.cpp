// One line for each folder, in JSON, the newest at the end: {"maps": "/home/me/game/maps", "read":
// "/home/me/game"}.
#include "read_permissions.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "formats/files/real_path.h"
#include "state_lines.h"
#include "stored_path.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

fs::path common_start(const fs::path& a, const fs::path& b) {
  fs::path common;
  for (auto in_a = a.begin(), in_b = b.begin(); in_a != a.end() && in_b != b.end() && *in_a == *in_b;
       ++in_a, ++in_b)
    common /= *in_a;
  return common;
}

}  // namespace

std::vector<std::string> ReadPermissions::folders_of(const std::string& file) const {
  std::vector<std::string> folders;
  const auto map_folder = real_folder_of(file);
  if (!map_folder) return folders;
  std::vector<Entry> all = own_;
  for (const std::string& line : read_state_lines(store_, kMaxKept))
    if (auto entry = entry_of(line)) all.push_back(*std::move(entry));
  for (const Entry& entry : all) {
    const bool is_new = std::find(folders.begin(), folders.end(), entry.folder) == folders.end();
    if (entry.map_folder == *map_folder && is_new) folders.push_back(entry.folder);
  }
  return folders;
}

tl::expected<void, std::string> ReadPermissions::allow(const std::string& file, const std::string& folder) {
  const auto map_folder = real_folder_of(file);
  if (!map_folder || folder.empty()) return {};
  const Entry entry{*map_folder, folder};
  own_.push_back(entry);
  const auto kept = change_state_lines(store_, kMaxKept, [&](std::vector<std::string>& lines) {
    std::erase_if(lines, [&](const std::string& line) {
      const auto known = entry_of(line);
      return !known || *known == entry;
    });
    lines.push_back(line_of(entry));
  });
  if (kept) return {};
  return tl::unexpected("Cannot save that these files may be read, so Talus will ask again: " + kept.error() +
                        ".");
}

// Nothing for a damaged line.
std::optional<ReadPermissions::Entry> ReadPermissions::entry_of(const std::string& line) {
  const auto json = parse_json(line);
  if (!json || !json->is_object()) return std::nullopt;
  Entry entry{path_in(*json, "maps"), path_in(*json, "read")};
  if (!entry.map_folder.starts_with('/') || !entry.folder.starts_with('/')) return std::nullopt;
  return entry;
}

std::string ReadPermissions::line_of(const Entry& entry) {
  Json json = Json::object();
  put_path(json, "maps", entry.map_folder);
  put_path(json, "read", entry.folder);
  return json.dump();
}

std::string common_folder(const std::string& file, const std::vector<std::string>& names) {
  const auto own = real_folder_of(file);
  if (!own) return "";
  fs::path common = *own;
  for (const std::string& name : names) {
    const auto place = real_path((fs::path(file).parent_path() / name).string());
    if (!place) return "";
    common = common_start(common, fs::path(*place).parent_path());
  }
  return common.string();
}

}  // namespace talus
