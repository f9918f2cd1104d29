#include "preferences_fields.h"

#include <nlohmann/json.hpp>

namespace talus {
namespace {

using nlohmann::json;

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

// Only commands whose keys were changed; commands that nobody knows are kept.
Field<Preferences> keys_field(const char* key) {
  return {key, json::object(), [](const json& v) { return v.is_object(); },
          [](Preferences& p, const json& v) { p.keys = bindings_of(v); },
          [](const Preferences& p) {
            json keys = json::object();
            for (const auto& [command, chords] : p.keys.changed)
              keys[command] = {to_string(chords[0]), to_string(chords[1])};
            return keys;
          }};
}

// The command of each program; one that is missing, or no text, is the program's usual one.
Field<Preferences> programs_field(const char* key) {
  return {key, json::object(), [](const json& v) { return v.is_object(); },
          [](Preferences& p, const json& v) {
            p.programs = default_program_commands();
            for (const ProgramInfo& info : program_infos()) {
              const auto it = v.find(std::string(info.key));
              if (it != v.end() && it->is_string())
                p.programs[static_cast<std::size_t>(info.id)] = it->get<std::string>();
            }
          },
          [](const Preferences& p) {
            json programs = json::object();
            for (const ProgramInfo& info : program_infos())
              programs[std::string(info.key)] = p.programs[static_cast<std::size_t>(info.id)];
            return programs;
          }};
}

// Of a gamepad.
Field<PadBindings> buttons_field(const char* key, PadButtons PadBindings::*member) {
  return {key, json(PadBindings().*member),
          [](const json& v) {
            return v.is_array() && v.size() == PadButtons().size() &&
                   std::all_of(v.begin(), v.end(), [](const json& name) { return name.is_string(); });
          },
          [member](PadBindings& pad, const json& v) { pad.*member = v.get<PadButtons>(); },
          [member](const PadBindings& pad) { return json(pad.*member); }};
}

Fields<PadBindings> pad_fields() {
  return {buttons_field("left", &PadBindings::left), buttons_field("right", &PadBindings::right),
          buttons_field("jump", &PadBindings::jump),
          toggle("stick", &PadBindings::stick, PadBindings().stick),
          number("dead_zone", &PadBindings::dead_zone, PadBindings().dead_zone, 0.05, 0.95)};
}

}  // namespace

Fields<Preferences> preferences_fields() {
  return {choice("theme", &Preferences::theme, ThemeKind::dark, {"dark", "light"}),
          number("font_size", &Preferences::font_size, Preferences().font_size, kMinFontSize, kMaxFontSize),
          toggle("plays_opened", &Preferences::plays_opened, Preferences().plays_opened),
          choice("starts_with", &Preferences::starts_with, StartsWith::welcome,
                 {"welcome", "last_level", "demo"}),
          toggle("middle_picks", &Preferences::middle_picks, Preferences().middle_picks),
          keys_field("keys"),
          object("gamepad", &Preferences::pad, pad_fields()),
          programs_field("programs")};
}

}  // namespace talus
