// Writes and reads the preferences.
#include "preferences_json.h"

#include <nlohmann/json.hpp>

namespace talus {
namespace {

using nlohmann::json;

constexpr const char* kThemeNames[] = {"dark", "light"};  // by ThemeKind

KeyBindings bindings_of(const json& object) {
  KeyBindings bindings;
  for (const auto& [command, keys] : object.items()) {
    if (!keys.is_array()) continue;
    CommandKeys& chords = bindings.changed[command];
    for (std::size_t i = 0; i < std::min(keys.size(), chords.size()); ++i) {
      if (keys[i].is_string()) chords[i] = parse_chord(keys[i].get<std::string>()).value_or(KeyChord{});
    }
  }
  return bindings;
}

}  // namespace

json to_json(const Preferences& preferences) {
  json keys = json::object(), programs = json::object();
  for (const auto& [command, chords] : preferences.keys.changed)
    keys[command] = {to_string(chords[0]), to_string(chords[1])};
  for (const ProgramInfo& info : program_infos())
    programs[std::string(info.key)] = preferences.programs[static_cast<std::size_t>(info.id)];
  return {{"theme", kThemeNames[static_cast<std::size_t>(preferences.theme)]},
          {"font_size", preferences.font_size},
          {"keys", keys},
          {"programs", programs}};
}

Preferences preferences_of_json(const json& value) {
  Preferences preferences;
  if (!value.is_object()) return preferences;
  if (value.contains("theme") && value["theme"] == kThemeNames[1]) preferences.theme = ThemeKind::light;
  if (value.contains("font_size") && value["font_size"].is_number()) {
    const double size = value["font_size"];
    if (size >= kMinFontSize && size <= kMaxFontSize) preferences.font_size = size;
  }
  if (value.contains("keys") && value["keys"].is_object()) preferences.keys = bindings_of(value["keys"]);
  if (!value.contains("programs") || !value["programs"].is_object()) return preferences;
  for (const ProgramInfo& info : program_infos()) {
    const auto it = value["programs"].find(std::string(info.key));
    if (it != value["programs"].end() && it->is_string())
      preferences.programs[static_cast<std::size_t>(info.id)] = it->get<std::string>();
  }
  return preferences;
}

}  // namespace talus
