// The levels of a project, and its mapping.
#include "ldtk_companion.h"

#include <algorithm>
#include <array>

#include "../native/moved_companion.h"
#include "../native/moved_members.h"
#include "../native/native.h"
#include "../native/native_document.h"
#include "ldtk_additions.h"
#include "ldtk_meanings.h"
#include "ldtk_moved.h"

namespace talus {
namespace {

constexpr std::array<const char*, 3> kLdtkKinds = {"value", "tag", "entity"};  // by LdtkMapping::Kind
constexpr std::size_t kMaxChoices = 65'536;

std::string ldtk_text(const Json& object, const char* key) {
  if (!object.is_object()) return {};
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// Leaves out what is no choice.
LdtkMapping mapping_of_json(const Json& list) {
  LdtkMapping mapping;
  for (const Json& entry : list) {
    const std::string kind = ldtk_text(entry, "kind");
    const auto found = std::find(kLdtkKinds.begin(), kLdtkKinds.end(), kind);
    if (found == kLdtkKinds.end() || mapping.choices.size() == kMaxChoices) continue;
    const LdtkMapping::Choice choice{static_cast<LdtkMapping::Kind>(found - kLdtkKinds.begin()),
                                     ldtk_text(entry, "of"),
                                     ldtk_text(entry, "name"),
                                     ldtk_text(entry, "shape"),
                                     ldtk_text(entry, "flag"),
                                     ldtk_text(entry, "body")};
    if (is_good(choice)) mapping.choices.push_back(choice);
  }
  return mapping;
}

// Why this version cannot read a companion; nothing if it can.
std::optional<FormatError> problem_of_companion(const Json& document) {
  if (!is_whole(document.value("talus", Json()), 1, kNativeVersion))
    return FormatError{"key talus", "is not a version that this Talus reads"};
  const auto levels = document.find("levels");
  if (levels != document.end() && !levels->is_object()) return FormatError{"key levels", "must be an object"};
  return std::nullopt;
}

// The companion's document. An error if it is none of this project. project: its iid.
FormatResult<Json> ldtk_companion(std::string_view bytes, const std::string& file,
                                  const std::string& project) {
  auto document = parse_json(bytes);
  if (!document) return document;
  if (!document->is_object() || !document->contains("companion"))
    return tl::unexpected(FormatError{
        "", "is a level of its own, not what Talus adds to " + file + ": save the level under another name"});
  const Json& about = (*document)["companion"];
  const std::string its = ldtk_text(about, "project");
  const bool is_same = its.empty() || project.empty() ? ldtk_text(about, "file") == file : its == project;
  if (!is_same) {
    return tl::unexpected(
        FormatError{"", "belongs to another project than " + file + ": save the level under another name"});
  }
  if (auto problem = problem_of_companion(*document)) return tl::unexpected(*std::move(problem));
  return document;
}

std::string count_of(int count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

std::string conflict_note(const LdtkConflicts& conflicts, const std::string& file) {
  std::string text;
  const auto add = [&](int count, const std::string& phrase) {
    if (count > 0) text += (text.empty() ? "" : ", ") + phrase;
  };
  add(conflicts.cells, count_of(conflicts.cells, "painted cell is", "painted cells are") + " as in LDtk now");
  add(conflicts.entries, count_of(conflicts.entries, "body is", "bodies are") +
                             " there both as changed here and as LDtk has it");
  add(conflicts.layers, count_of(conflicts.layers, "layer", "layers") + " with painted cells " +
                            (conflicts.layers == 1 ? "is" : "are") + " gone");
  return text.empty() ? "" : "LDtk has changed " + file + ": " + text;
}

// place: where the ground of the level was when they were added; nothing if that is not known.
FormatResult<JoinedLevel> joined_with(Json additions, const Level& held, const std::string& file,
                                      const std::optional<GroundPlace>& place) {
  LdtkConflicts conflicts;
  const Cell by = place ? ground_shift(*place, held) : Cell{0, 0};
  const bool has_moved = by != Cell{0, 0};
  const int lost_curves = has_moved ? move_ldtk_places(additions, by, *place, held, conflicts) : 0;
  auto level = add_to_ldtk(additions, held, conflicts);
  if (!level) return tl::unexpected(level.error());
  level->ldtk = held.ldtk;
  std::string note = conflict_note(conflicts, file);
  if (has_moved)
    note = with_shift_note(note, file, by, growth_at_corner(*place, held.map, by) == by, lost_curves);
  return JoinedLevel{*std::move(level), std::move(note), !conflicts.any() && lost_curves == 0};
}

}  // namespace

// A text that was cut need not have the key any more.
bool is_damaged_ldtk_companion(std::string_view text) {
  const auto document = parse_json(text);
  if (!document || !document->is_object()) return true;
  return document->contains("companion") && problem_of_companion(*document);
}

Json json_of_mapping(const LdtkMapping& mapping) {
  Json list = Json::array();
  for (const LdtkMapping::Choice& choice : mapping.choices) {
    Json entry = {{"kind", kLdtkKinds[static_cast<std::size_t>(choice.kind)]}, {"name", choice.name}};
    if (!choice.of.empty()) entry["of"] = choice.of;
    if (!choice.shape.empty()) entry["shape"] = choice.shape;
    if (!choice.flag.empty()) entry["flag"] = choice.flag;
    if (!choice.body.empty()) entry["body"] = choice.body;
    list.push_back(std::move(entry));
  }
  return list;
}

std::optional<LdtkMapping> ldtk_mapping_in(std::string_view text) {
  const auto json = parse_json(text);
  if (!json) return std::nullopt;
  const Json list = json->is_object() ? json->value("mapping", Json()) : *json;
  return list.is_array() ? std::optional(mapping_of_json(list)) : std::nullopt;
}

LdtkMemory ldtk_memory_of(std::string_view companion) {
  LdtkMemory memory;
  if (companion.empty()) return memory;
  const auto json = parse_json(companion);
  if (!json || !json->is_object() || !json->contains("companion")) return memory;
  const auto mapping = json->find("mapping");
  if (mapping != json->end() && mapping->is_array()) memory.mapping = mapping_of_json(*mapping);
  memory.last = ldtk_text((*json)["companion"], "last");
  return memory;
}

std::vector<std::string> ldtk_tiles_of_companion(std::string_view companion, const std::string& level) {
  std::vector<std::string> tiles;
  if (companion.empty()) return tiles;
  const auto json = parse_json(companion);
  const Json levels = json && json->is_object() ? json->value("levels", Json()) : Json();
  const Json its = levels.is_object() ? levels.value(level, Json()) : Json();
  const Json list = its.is_object() ? its.value("tiles", Json()) : Json();
  if (!list.is_array() || list.size() > kMaxTiles) return tiles;
  for (const Json& tile : list) tiles.push_back(tile.is_string() ? tile.get<std::string>() : std::string());
  return tiles;
}

FormatResult<std::string> write_ldtk_companion(const Level& level, std::string_view before,
                                               const std::string& file) {
  const LdtkOrigin& origin = *level.ldtk;
  Json document = Json::object();
  if (!before.empty()) {
    auto known = ldtk_companion(before, file, origin.project);
    if (!known) return tl::unexpected(known.error());
    document = *std::move(known);
  }
  auto added = ldtk_additions(level, *origin.opened);
  if (!added) return tl::unexpected(added.error());
  document["talus"] = kTilesetVersion;
  document["companion"] = {{"file", file}, {"last", origin.level}};
  if (!origin.project.empty()) document["companion"]["project"] = origin.project;
  document["mapping"] = json_of_mapping(origin.mapping);
  std::vector<std::string> tiles = origin.tiles;
  // The user's own tiles keep their numbers, too.
  if (!added->empty()) tiles.resize(static_cast<std::size_t>(level.tile_count()));
  document["levels"][origin.level] = {{"name", origin.name},
                                      {"tiles", tiles},
                                      {"ground", json_of_ground(ground_place(*origin.opened))},
                                      {"added", *std::move(added)}};
  return print_document(document);
}

FormatResult<JoinedLevel> join_ldtk_companion(std::string_view bytes, const Level& held,
                                              const std::string& file) {
  const auto document = ldtk_companion(bytes, file, held.ldtk->project);
  if (!document) return tl::unexpected(document.error());
  const Json levels = document->value("levels", Json::object());
  const Json its = levels.value(held.ldtk->level, Json());
  const Json added = its.is_object() ? its.value("added", Json::object()) : Json::object();
  if (!added.is_object()) return tl::unexpected(FormatError{"key levels", "must have objects as added"});
  if (added.empty()) return JoinedLevel{held};
  return joined_with(added, held, file, ground_of_json(its.value("ground", Json())));
}

FormatResult<JoinedLevel> move_ldtk_additions(const Level& level, const Level& fresh,
                                              const std::string& file) {
  auto added = ldtk_additions(level, *level.ldtk->opened);
  if (!added) return tl::unexpected(added.error());
  if (added->empty()) return JoinedLevel{fresh};
  return joined_with(*std::move(added), fresh, file, ground_place(*level.ldtk->opened));
}

}  // namespace talus
