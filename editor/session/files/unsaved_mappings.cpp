// One line for each project, in JSON: {"file": "/home/me/game/world.ldtk", "mapping": [...]}, as in its
// companion.
#include "unsaved_mappings.h"

#include <filesystem>

#include "formats/files/real_path.h"
#include "formats/ldtk/ldtk_companion.h"
#include "state_lines.h"
#include "stored_path.h"

namespace talus {
namespace {

std::string place_of(const std::string& file) { return real_path(file).value_or(file); }

bool is_of(const std::string& line, const std::string& place) {
  const auto json = parse_json(line);
  return json && json->is_object() && path_in(*json, "file") == place;
}

}  // namespace

std::optional<LdtkMapping> UnsavedMappings::find(const std::string& file) const {
  const std::string place = place_of(file);
  for (const std::string& line : store_.empty() ? own_ : read_state_lines(store_, kMaxKept))
    if (is_of(line, place)) return ldtk_mapping_in(line);
  return std::nullopt;
}

void UnsavedMappings::keep(const std::string& file, const LdtkMapping& mapping) {
  forget(file);
  Json json = {{"mapping", json_of_mapping(mapping)}};
  put_path(json, "file", place_of(file));
  const std::string line = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (store_.empty()) return own_.push_back(line);
  (void)change_state_lines(store_, kMaxKept, [&](std::vector<std::string>& lines) { lines.push_back(line); });
}

void UnsavedMappings::forget(const std::string& file) {
  const std::string place = place_of(file);
  const auto forget_in = [&](std::vector<std::string>& lines) {
    std::erase_if(lines, [&](const std::string& line) { return is_of(line, place); });
  };
  if (store_.empty()) return forget_in(own_);
  if (find(file)) (void)change_state_lines(store_, kMaxKept, forget_in);
}

}  // namespace talus
