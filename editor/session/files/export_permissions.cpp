// One line for each preset, in JSON, the newest at the end: {"file": "/home/me/cave.talus.json", "preset":
// {...}, "allowed": true, "place": "/home/me/game"}. A path that is not UTF-8 is "file_base64" or
// "place_base64".
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
#include "formats/text/base64.h"
#include "formats/text/utf8_text.h"
#include "stored_path.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

// The name of a level's file in the store: its folder without links, in which its exports go. A link in
// another folder is another file, although it leads to the same level. Empty: it has none.
std::string key_of(const std::string& level_file) {
  const auto folder =
      level_file.empty() ? FormatResult<std::string>(std::string()) : real_folder_of(level_file);
  return folder && !folder->empty() ? (fs::path(*folder) / last_name(level_file)).string() : "";
}

constexpr std::size_t kMaxRead = std::size_t{1} << 30;  // bytes; earlier versions had no bound

struct KeptPermission {
  std::string file;
  ExportPreset preset;
  bool is_allowed = false;
  std::string place = {};
};

struct StoreLine {
  std::string text;
  std::optional<KeptPermission> own = {};  // nothing: it is of another file than the wanted one, or damaged
};

std::optional<KeptPermission> permission_of(const std::string& line) {
  const auto json = parse_json(line);
  if (!json || !json->is_object()) return std::nullopt;
  Json presets = Json::array({json->value("preset", Json())});
  const auto read = take_exports(presets);
  if (!read) return std::nullopt;
  return KeptPermission{path_in(*json, "file"), read->front(), json->value("allowed", Json()) == Json(true),
                        path_in(*json, "place")};
}

// The error says why it cannot be kept.
tl::expected<std::string, std::string> line_of(const KeptPermission& kept) {
  const auto preset = json_of(std::vector<ExportPreset>{kept.preset});
  if (!preset) return tl::unexpected(preset.error().message);
  Json line = {{"preset", preset->front()}, {"allowed", kept.is_allowed}};
  put_path(line, "file", kept.file);
  if (!kept.place.empty()) put_path(line, "place", kept.place);
  try {
    std::string text = line.dump();
    if (text.size() <= ExportPermissions::kMaxBytes) return text;
    return tl::unexpected("is longer than " + std::to_string(ExportPermissions::kMaxBytes >> 10) + " KB");
  } catch (const Json::exception&) {
    return tl::unexpected<std::string>("is not valid UTF-8");
  }
}

// All lines; only those of the file are parsed, as there may be many. Nothing: the store is there, and cannot
// be read.
std::optional<std::vector<StoreLine>> read_store(const std::string& store, const std::string& file) {
  std::vector<StoreLine> all;
  std::error_code error;
  if (store.empty() || (!fs::exists(store, error) && !error)) return all;
  const auto text = read_file(store, kMaxRead);
  if (!text) return std::nullopt;
  const std::string name = Json(is_utf8(file) ? file : encode_base64(file)).dump();
  std::istringstream lines(*text);
  for (std::string line; std::getline(lines, line);) {
    all.push_back({std::move(line)});
    if (all.back().text.find(name) == std::string::npos) continue;
    auto kept = permission_of(all.back().text);
    if (kept && kept->file == file) all.back().own = *std::move(kept);
  }
  return all;
}

// The oldest lines go until the others fit.
std::string text_of(const std::vector<StoreLine>& all) {
  std::size_t bytes = 0;
  auto first = all.end();
  while (first != all.begin() && (bytes += (first - 1)->text.size() + 1) <= ExportPermissions::kMaxKept)
    --first;
  std::string text;
  for (; first != all.end(); ++first) text.append(first->text).append("\n");
  return text;
}

}  // namespace

void ExportPermissions::open(const std::string& level_file) {
  level_file_ = level_file;
  key_ = key_of(level_file);
  entries_.clear();
  if (key_.empty()) return;
  auto all = read_store(store_, key_);
  for (StoreLine& line : all ? *all : std::vector<StoreLine>()) {
    if (line.own)
      entries_.push_back({std::move(line.own->preset), line.own->is_allowed, std::move(line.own->place)});
  }
}

tl::expected<void, std::string> ExportPermissions::save(const std::string& level_file,
                                                        std::span<const ExportPreset> presets) {
  level_file_ = level_file;
  key_ = key_of(level_file);
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

tl::expected<void, std::string> ExportPermissions::remember(std::span<const ExportPreset> presets) {
  if (store_.empty() || key_.empty() || presets.empty()) return {};
  const auto failure = [&](const std::string& why) {
    return tl::unexpected(
        "Cannot save which exports are allowed, so Talus will ask about them again: " + why + ".");
  };
  std::error_code ignored;
  fs::create_directories(fs::path(store_).parent_path(), ignored);
  const FileLock lock(store_);
  auto read = read_store(store_, key_);
  if (!read) return failure(store_ + " cannot be read");
  std::vector<StoreLine>& all = *read;
  std::string problem;
  bool is_changed = false;
  for (const ExportPreset& preset : presets) {
    if (find(preset) == nullptr) continue;
    Entry& known = entry(preset);
    KeptPermission kept{key_, preset, known.is_allowed, known.place};
    auto line = line_of(kept);
    if (!line && !std::exchange(known.is_told, true))
      problem = "the preset " + preset.name + " " + line.error();
    if (!line || std::any_of(all.begin(), all.end(), [&](const StoreLine& l) { return l.text == *line; }))
      continue;
    std::erase_if(all, [&](const StoreLine& l) { return l.own && l.own->preset == preset; });
    all.push_back({*std::move(line), std::move(kept)});
    is_changed = true;
  }
  if (is_changed) {
    if (const auto written = write_file_atomic(store_, text_of(all)); !written)
      return failure(store_ + " " + written.error().message);
  }
  if (!problem.empty()) return failure(problem);
  return {};
}

}  // namespace talus
