// What a reader did not take is in the texts `extra` of a level. Their objects are walked beside the kinds,
// and so is a whole file that no reader took.
#include "unknown_keys.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>

#include <talus/level/auto_tiles.h>
#include <talus/level/flag_roles.h>
#include <talus/level/tuning.h>
#include "../ldtk/ldtk_tiles.h"
#include "../text/json_text.h"
#include "../text/utf8_text.h"
#include "native.h"
#include "native_members.h"

namespace talus {
namespace {

using Words = std::vector<std::string_view>;
using Texts = std::vector<std::string>;

Words with_looks(Words keys) {
  for (const char* look : {"group", "visible", "locked", "opacity", "offset", "parallax", "tint"})
    keys.emplace_back(look);
  return keys;
}

// Of what a picture shows.
Words with_part(Words keys) {
  for (const char* key : {"picture", "rect", "shift", "keeps_ratio", "swaps_axes", "mirrors_x", "mirrors_y"})
    keys.emplace_back(key);
  return keys;
}

Words role_keys() {
  Words keys;
  for (const FlagRoleInfo& info : flag_role_infos()) keys.push_back(info.key);
  return keys;
}

Words part_keys() {
  Words keys;
  for (const GroundPartInfo& part : kGroundParts) keys.push_back(part.key);
  return keys;
}

Words tuning_keys(std::string_view group, Words keys) {
  for (const TuningField& field : tuning_fields())
    if (field.group == group) keys.push_back(field.key);
  return keys;
}

std::vector<KeyKind> make_kinds() {
  return {
      {"level",
       {"talus",       "$schema",    "palette",     "background", "flag_names",   "flag_fields", "roles",
        "flag_shapes", "tuning",     "spawns",      "curves",     "brushes",      "auto_tiles",  "exports",
        "tile_shapes", "tiles",      "sprites",     "tile_size",  "sheet_size",   "picture",     "tilesets",
        "animations",  "tile_notes", "large_tiles", "pictures",   "render_order", "map",         "layers",
        "groups",      "objects",    "cart",        "hard_case"}},
      {"roles", role_keys()},
      {"flag_field", {"name", "first", "bits", "values"}},
      {"tuning", tuning_keys("", {"solver", "balls_block", "exact", "player"})},
      {"exact_tuning", tuning_keys("exact", {})},
      {"player_tuning", tuning_keys("player", {})},
      {"spawn", {"name", "x", "y", "vx", "vy", "kind", "size", "foot", "picture"}},
      {"curve",
       {"name", "kind", "faces", "conveyor", "from", "to", "center", "radius", "x0", "x1", "upper",
        "from_slope", "to_slope", "middle", "ys", "amplitude", "wavelength", "origin", "control_y"}},
      {"brush", {"name", "random", "rows", "turns"}},
      {"auto_tiles", part_keys()},
      {"preset", {"name", "to", "path", "parts", "on_save"}},
      {"shapes", {}},
      {"shape", {"kind", "side", "one_way", "tiles", "heights", "points", "conveyor", "parts"}},
      {"sheet", {}},
      {"tile", {"flags", "pixels"}},
      {"tileset", {"name", "first", "count", "columns", "image", "tile_size", "spacing", "margin", "offset"}},
      {"map", {"width", "height", "rows", "turns"}},
      {"layer", with_looks({"name", "ground", "rows", "packed", "turns", "packed_turns", kLdtkLayerKey})},
      {"group", with_looks({"name"})},
      {"object_layer", with_looks({"name", "ground", "place", "by_y", "image", "objects", kLdtkLayerKey})},
      {"cart", {"kind", "chunks", "comment", "lines", "data"}},
      {"notes", {}},
      {"note", {"class", "probability", "properties"}},
      {"large_tiles", {}},
      {"large_tile", with_part({"size"})},
      {"layer_image", with_part({"path", "repeats_x", "repeats_y"})},
      {"object", with_part({"form", "name", "class", "x", "y", "width", "height", "rotation", "points",
                            "one_way", "visible", "tile", "anchor", "properties"})},
      {"body_picture", {"sheet", "size", "steps", "stand", "run", "jump", "fall"}},
      {"shape_part", {"kind", "side", "one_way", "tiles", "heights", "points"}},
      {"chunk", {"chunk", "bank", "reserved", "code", "data"}},
      {"hard_case",
       {"number", "title", "set_up", "right_answer", "frames", "input", "edits", "floor", "checks"}},
      {"case_input", {"frame", "mouse", "down", "keys"}},
      {"case_edit", {"frame", "remove", "turn_round"}},
      {"case_curve", {"arc", "bowl", "sine"}},
      {"case_check", {"measure", "body", "frame", "frames", "x", "y", "right", "bottom", "bound"}},
  };
}

// Where an object, or a list of objects, of one kind stands in one of another. The key "" stands for all
// numbers.
struct Inner {
  std::string_view in, key, kind;
};
constexpr std::array<Inner, 18> kInner = {{{"level", "roles", "roles"},
                                           {"level", "tuning", "tuning"},
                                           {"level", "auto_tiles", "auto_tiles"},
                                           {"level", "flag_shapes", "shapes"},
                                           {"level", "tile_shapes", "shapes"},
                                           {"level", "tiles", "sheet"},
                                           {"level", "sprites", "sheet"},
                                           {"level", "map", "map"},
                                           {"level", "cart", "cart"},
                                           {"level", "hard_case", "hard_case"},
                                           {"tuning", "exact", "exact_tuning"},
                                           {"tuning", "player", "player_tuning"},
                                           {"shapes", "", "shape"},
                                           {"sheet", "", "tile"},
                                           {"hard_case", "input", "case_input"},
                                           {"hard_case", "edits", "case_edit"},
                                           {"hard_case", "floor", "case_curve"},
                                           {"hard_case", "checks", "case_check"}}};

// The same where readers leave nothing there, so that only a whole file has them.
constexpr std::array<Inner, 18> kInnerOfFile = {{{"level", "flag_fields", "flag_field"},
                                                 {"level", "spawns", "spawn"},
                                                 {"level", "curves", "curve"},
                                                 {"level", "brushes", "brush"},
                                                 {"level", "exports", "preset"},
                                                 {"level", "tilesets", "tileset"},
                                                 {"level", "layers", "layer"},
                                                 {"level", "groups", "group"},
                                                 {"level", "objects", "object_layer"},
                                                 {"level", "tile_notes", "notes"},
                                                 {"level", "large_tiles", "large_tiles"},
                                                 {"spawn", "picture", "body_picture"},
                                                 {"shape", "parts", "shape_part"},
                                                 {"notes", "", "note"},
                                                 {"large_tiles", "", "large_tile"},
                                                 {"object_layer", "image", "layer_image"},
                                                 {"object_layer", "objects", "object"},
                                                 {"cart", "chunks", "chunk"}}};

const KeyKind& kind_of(std::string_view name) {
  const auto kinds = key_kinds();
  return *std::find_if(kinds.begin(), kinds.end(), [&](const KeyKind& kind) { return kind.name == name; });
}

const Inner* inner_of(const KeyKind& kind, const std::string& key, bool is_whole) {
  const bool is_number = number_of_key(key, kMaxTiles).has_value();
  const auto is_it = [&](const Inner& inner) {
    return inner.in == kind.name && (inner.key == key || (inner.key.empty() && is_number));
  };
  const auto found = std::find_if(kInner.begin(), kInner.end(), is_it);
  if (found != kInner.end()) return &*found;
  const auto of_file = std::find_if(kInnerOfFile.begin(), kInnerOfFile.end(), is_it);
  return is_whole && of_file != kInnerOfFile.end() ? &*of_file : nullptr;
}

// How many letters are missing, too many, wrong or swapped with the next one.
std::size_t typing_errors(std::string_view a, std::string_view b) {
  std::vector<std::vector<std::size_t>> errors(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t k = 0; k <= b.size(); ++k) {
      if (i == 0 || k == 0) {
        errors[i][k] = i + k;
        continue;
      }
      errors[i][k] = std::min({errors[i - 1][k] + 1, errors[i][k - 1] + 1,
                               errors[i - 1][k - 1] + (a[i - 1] == b[k - 1] ? 0 : 1)});
      const bool is_swapped = i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1];
      if (is_swapped) errors[i][k] = std::min(errors[i][k], errors[i - 2][k - 2] + 1);
    }
  }
  return errors[a.size()][b.size()];
}

// The known key that is meant, if one is near: one error, or one in three letters.
std::optional<std::string_view> nearest(const std::string& key, const Words& known) {
  constexpr std::size_t kLongestKey = 32;  // no known one is longer
  if (key.size() > kLongestKey) return std::nullopt;
  std::optional<std::string_view> best;
  std::size_t least = std::max<std::size_t>(1, key.size() / 3) + 1;
  for (const std::string_view word : known) {
    const std::size_t errors = typing_errors(key, word);
    if (errors < least && errors < key.size()) least = errors, best = word;
  }
  return best;
}

bool has_key(const KeyKind& kind, std::string_view key) {
  return std::find(kind.keys.begin(), kind.keys.end(), key) != kind.keys.end();
}

// "tuning.exact.gravity" for "gravity": the places below an object where a key is known. Of numbered objects,
// and of those in lists, there are too many.
void add_known_places(std::string_view kind, const std::string& key, const std::string& place, Texts& out) {
  for (const Inner& inner : kInner) {
    if (inner.in != kind || inner.key.empty() || inner.in == "hard_case") continue;
    const std::string path = place + std::string(inner.key) + ".";
    if (has_key(kind_of(inner.kind), key)) out.push_back(path + key);
    add_known_places(inner.kind, key, path, out);
  }
}

// What is said of a key of an object at a place. is_whole: see Walk.
std::string problem_of_key(const std::string& key, const KeyKind& kind, const std::string& place,
                           bool is_whole) {
  if (has_key(kind, key)) return "is not used here, and is kept as it is";
  Texts places;
  add_known_places("level", key, "", places);
  // In the same member of the level.
  const std::string member = place.empty() ? "" : place.substr(0, place.find_first_of(".[")) + ".";
  std::erase_if(places, [&](const std::string& other) { return !other.starts_with(member); });
  std::string meant;
  for (const std::string& other : places) meant += (meant.empty() ? "\"" : " or \"") + other + '"';
  if (!meant.empty()) return "is not known here; did you mean " + meant + "?";
  if (const auto near = nearest(key, kind.keys))
    return "is not known; did you mean \"" + std::string(*near) + "\"?";
  if (has_key(kind_of("level"), key)) return "is not known here, but at the top of the file";
  return is_whole ? "is not known" : "is not known, and is kept as it is";
}

// Whether the reader of levels leaves a known key in its place, for others to read.
bool is_kept(const std::string& key, const KeyKind& kind) {
  const bool is_of_case = kind.name == "hard_case" || kind.name.starts_with("case_");
  if (is_of_case) return has_key(kind, key);
  return key == "$schema" || key == "hard_case" || key == kLdtkLayerKey;
}

class Walk {
 public:
  // is_whole: whether it is of a file as it is, not of what readers left: known keys are not listed.
  explicit Walk(bool is_whole = false) : is_whole_(is_whole) {}

  // An object, or a list of objects.
  void visit(const Json& json, const KeyKind& kind, const std::string& place) {
    for (std::size_t i = 0; json.is_array() && i < json.size() && !is_full(); ++i)
      visit(json[i], kind, place + "[" + std::to_string(i) + "]");
    if (!json.is_object()) return;
    for (auto at = json.begin(); at != json.end() && !is_full(); ++at) visit_key(at.key(), *at, kind, place);
  }
  // What is left of an entry of a list.
  void visit(const std::string& extra, const char* kind, const char* list, std::size_t index) {
    if (!extra.empty() && !is_full())
      visit(json_part(extra), kind_of(kind), std::string(list) + "[" + std::to_string(index) + "]");
  }
  template <class Entry>
  void visit_all(const std::vector<Entry>& entries, const char* kind, const char* list) {
    for (std::size_t i = 0; i < entries.size(); ++i) visit(entries[i].extra, kind, list, i);
  }
  std::vector<UnknownKey> found() && { return std::move(found_); }

 private:
  bool is_full() const { return found_.size() >= kMaxUnknownListed; }

  void visit_key(const std::string& key, const Json& value, const KeyKind& kind, const std::string& place) {
    const std::string inner_place = (place.empty() ? "" : place + ".") + printable(key);
    if (const Inner* inner = inner_of(kind, key, is_whole_))
      return visit(value, kind_of(inner->kind), inner_place);
    if (!is_kept(key, kind) && !(is_whole_ && has_key(kind, key)))
      found_.push_back({inner_place, problem_of_key(key, kind, place, is_whole_)});
  }

  bool is_whole_;
  std::vector<UnknownKey> found_;
};

}  // namespace

std::span<const KeyKind> key_kinds() {
  static const std::vector<KeyKind> kKinds = make_kinds();
  return kKinds;
}

std::vector<UnknownKey> unknown_keys(const Level& level) {
  Walk walk;
  if (!level.extra.empty()) walk.visit(json_part(level.extra), kind_of("level"), "");
  walk.visit_all(level.flag_fields, "flag_field", "flag_fields");
  walk.visit_all(level.spawns, "spawn", "spawns");
  walk.visit_all(level.curves, "curve", "curves");
  walk.visit_all(level.brushes, "brush", "brushes");
  walk.visit_all(level.exports, "preset", "exports");
  walk.visit_all(level.tilesets, "tileset", "tilesets");
  walk.visit_all(level.layers.list, "layer", "layers");
  walk.visit_all(level.layers.groups, "group", "groups");
  walk.visit_all(level.objects, "object_layer", "objects");
  return std::move(walk).found();
}

std::vector<UnknownKey> unknown_keys_of_file(std::string_view bytes) {
  const auto json = parse_json(bytes);
  if (!json || !json->is_object()) return {};
  const auto version = json->find("talus");
  const bool is_newer = version != json->end() && version->is_number() && *version > kNativeVersion;
  if (is_newer || json->contains("companion")) return {};
  Walk walk(true);
  walk.visit(*json, kind_of("level"), "");
  return std::move(walk).found();
}

}  // namespace talus
