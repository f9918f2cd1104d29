// Notes of tiles as JSON.
#include "native_notes.h"

#include <utility>

#include "native_members.h"

namespace talus {
namespace {

tl::unexpected<FormatError> note_error(std::string message) {
  return tl::unexpected(FormatError{"key tile_notes", std::move(message)});
}

FormatResult<TileNote> take_note(Json& json, const std::string& path) {
  MemberTaker take(json, path);
  TileNote note;
  take.optional("class", note.type);
  take.ranged("probability", 0, kMaxProbability, "", note.probability);
  take.member("properties", [&](const Json& its) {
    if (!its.is_object()) return take.fail("properties", "must be an object");
    if (!its.empty()) note.properties = its.dump();
  });
  std::optional<std::string> problem;
  if (json.is_object() && !json.empty())
    problem = "has the key \"" + json.begin().key() + "\", which no note of a tile has";
  return take.result(std::move(note), std::move(problem));
}

}  // namespace

FormatResult<TileNotes> take_notes(Json& json, int tile_count) {
  if (!json.is_object()) return note_error("must be an object");
  TileNotes notes;
  for (auto& [key, value] : json.items()) {
    const auto tile = number_of_key(key, kMaxTiles);
    if (!tile) return note_error(no_tile_text(key));
    auto note = take_note(value, "tile_notes." + key);
    if (!note) return tl::unexpected(note.error());
    put_note(notes, static_cast<TileNumber>(*tile), *std::move(note));
  }
  if (auto problem = problem_of(notes, tile_count))
    return note_error("has one that cannot be: " + *std::move(problem));
  return notes;
}

FormatResult<Json> json_of(const TileNotes& notes, int tile_count) {
  if (auto problem = problem_of(notes, tile_count))
    return note_error("has one that cannot be: " + *std::move(problem));
  Json json = Json::object();
  for (const auto& [tile, note] : notes) {
    Json& entry = json[std::to_string(tile)] = Json::object();
    if (!note.type.empty()) entry["class"] = note.type;
    if (note.probability != 1) entry["probability"] = json_number(note.probability);
    if (note.properties.empty()) continue;
    auto properties = parse_extra(note.properties);
    if (!properties) return properties;
    entry["properties"] = *std::move(properties);
  }
  return json;
}

}  // namespace talus
