// One line for each preset, in JSON: {"file": "/home/me/cave.talus.json", "preset": {...}, "place":
// "/home/me/game"}.
#include "export_permissions.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <tuple>
#include <utility>

#include "export/export_plan.h"
#include "formats/files/atomic_file.h"
#include "formats/files/held_file.h"
#include "formats/files/real_path.h"
#include "formats/native/native_exports.h"
#include "formats/text/utf8_text.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

struct KeptPermission {
  std::string file;
  ExportPreset preset;
  bool is_allowed = false;
  std::string place = {};
};

std::optional<KeptPermission> permission_of(const std::string& line) {
  const auto json = parse_json(line);
  if (!json || !json->is_object()) return std::nullopt;
  Json presets = Json::array({json->value("preset", Json())});
  const auto read = take_exports(presets);
  const Json file = json->value("file", Json()), place = json->value("place", Json());
  if (!read || !file.is_string()) return std::nullopt;
  return KeptPermission{file.get<std::string>(), read->front(), json->value("allowed", Json()) == Json(true),
                        place.is_string() ? place.get<std::string>() : ""};
}

// Empty: it is not stored.
std::string line_of(const KeptPermission& kept) {
  const auto preset = json_of(std::vector<ExportPreset>{kept.preset});
  if (!preset || !is_utf8(kept.file) || !is_utf8(kept.place)) return "";
  Json line = {{"file", kept.file}, {"preset", preset->front()}, {"allowed", kept.is_allowed}};
  if (!kept.place.empty()) line["place"] = kept.place;
  std::string text = line.dump();
  return text.size() > ExportPermissions::kMostBytes ? "" : text;
}

std::string text_of(const std::vector<KeptPermission>& all) {
  std::string text;
  for (const KeptPermission& kept : all) {
    if (const std::string line = line_of(kept); !line.empty()) text += line + "\n";
  }
  return text;
}

// Nothing: the file exists but cannot be read.
std::optional<std::vector<KeptPermission>> read_store(const std::string& store) {
  std::vector<KeptPermission> all;
  std::error_code error;
  if (store.empty() || (!fs::exists(store, error) && !error)) return all;
  const auto text = read_file(store);
  if (!text) return std::nullopt;
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    if (auto kept = permission_of(line)) all.push_back(*std::move(kept));
  }
  return all;
}

}  // namespace

void ExportPermissions::open(const std::string& level_file) {
  level_file_ = level_file;
  key_ = level_file.empty() ? "" : real_path(level_file).value_or("");
  entries_.clear();
  if (key_.empty()) return;
  auto all = read_store(store_);
  for (KeptPermission& kept : all ? *all : std::vector<KeptPermission>()) {
    if (kept.file == key_)
      entries_.push_back({std::move(kept.preset), kept.is_allowed, std::move(kept.place)});
  }
}

tl::expected<void, std::string> ExportPermissions::save(const std::string& level_file,
                                                        std::span<const ExportPreset> presets) {
  level_file_ = level_file;
  key_ = real_path(level_file).value_or("");
  for (Entry& e : entries_) {
    if (e.is_chosen) e.place = place_of(e.preset);
  }
  return remember(presets);
}

void ExportPermissions::note_edit(std::span<const ExportPreset> before, std::span<const ExportPreset> after) {
  for (std::size_t i = 0; i < after.size(); ++i) {
    if (std::find(before.begin(), before.end(), after[i]) != before.end()) continue;
    const bool keeps_path =
        i < before.size() && before.size() == after.size() && before[i].path == after[i].path;
    const Entry* old = keeps_path ? find(before[i]) : nullptr;
    const Entry like = old != nullptr ? *old : Entry();
    Entry& own = entry(after[i]);
    own.is_allowed = true;
    if (own.place.empty()) std::tie(own.place, own.is_chosen) = std::tie(like.place, like.is_chosen);
  }
}

tl::expected<void, std::string> ExportPermissions::allow(std::span<const ExportPreset> presets) {
  for (const ExportPreset& preset : presets) entry(preset).is_allowed = true;
  return remember(presets);
}

void ExportPermissions::allow_place(const ExportPreset& preset) {
  Entry& chosen = entry(preset);
  chosen.is_chosen = true;
  chosen.place = place_of(preset);
}

bool ExportPermissions::allows(const ExportPreset& preset) const {
  const Entry* known = find(preset);
  return known != nullptr && known->is_allowed;
}

ExportBounds ExportPermissions::bounds_of(const ExportPreset& preset) const {
  const ExportBounds inside = bounds_of_level(level_file_);
  const Entry* known = find(preset);
  const std::string place = known != nullptr && !known->place.empty() ? place_of(preset) : "";
  if (place.empty() || place != known->place || is_within(place, inside.folder)) return inside;
  const Exporter* exporter = find_exporter(preset.exporter);
  const bool is_folder = exporter != nullptr && exporter->is_folder();
  return {is_folder ? place : fs::path(place).parent_path().string(), true};
}

const ExportPermissions::Entry* ExportPermissions::find(const ExportPreset& preset) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.preset == preset; });
  return found == entries_.end() ? nullptr : &*found;
}

ExportPermissions::Entry& ExportPermissions::entry(const ExportPreset& preset) {
  const Entry* known = find(preset);
  if (known == nullptr) return entries_.emplace_back(Entry{preset});
  return entries_[static_cast<std::size_t>(known - entries_.data())];
}

// Where its path leads now; empty: not known.
std::string ExportPermissions::place_of(const ExportPreset& preset) const {
  const auto output = output_of(preset, level_file_);
  return output ? real_path(*output).value_or("") : "";
}

tl::expected<void, std::string> ExportPermissions::remember(std::span<const ExportPreset> presets) const {
  if (store_.empty() || key_.empty() || presets.empty()) return {};
  const auto failure = [&](const std::string& why) {
    return tl::unexpected("Cannot save which exports are allowed, so Talus will ask about them again: " +
                          store_ + " " + why + ".");
  };
  std::error_code ignored;
  fs::create_directories(fs::path(store_).parent_path(), ignored);
  const FileLock lock(store_);
  auto read = read_store(store_);
  if (!read) return failure("cannot be read");
  std::vector<KeptPermission>& all = *read;
  const std::string before = text_of(all);
  for (const ExportPreset& preset : presets) {
    const Entry* known = find(preset);
    if (known == nullptr) continue;
    auto kept = std::find_if(all.begin(), all.end(),
                             [&](const KeptPermission& k) { return k.file == key_ && k.preset == preset; });
    if (kept == all.end()) kept = all.insert(kept, {key_, preset});
    kept->is_allowed = known->is_allowed;
    kept->place = known->place;
  }
  if (all.size() > kMostKept)
    std::erase_if(all, [&](const KeptPermission& kept) { return !fs::exists(kept.file, ignored); });
  const std::string after = text_of(all);
  if (after == before) return {};
  if (const auto written = write_file_atomic(store_, after); !written)
    return failure(written.error().message);
  return {};
}

}  // namespace talus
