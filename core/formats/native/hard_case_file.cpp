#include "hard_case_file.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "../text/json_text.h"

namespace talus {
namespace {

constexpr std::int64_t kMaxFrames = 1'000'000;
constexpr double kMaxCaseNumber = 1e8;  // px or px/frame; farther away than any level reaches
constexpr std::size_t kMaxFloorParts = 256;
constexpr std::size_t kMaxChecks = 256;  // some of them take a run each
constexpr std::size_t kMaxEdits = 256;
constexpr int kMaxId = 1000;  // of a body that a case names

// Thrown and caught in this file only: ends the reading of nested values at the first error.
struct Wrong {
  FormatError error;
};
[[noreturn]] void fail(const std::string& key, const std::string& message) {
  throw Wrong{{"key hard_case." + key, message}};
}

const Json& member(const Json& object, const std::string& path, const char* key) {
  if (!object.contains(key)) fail(path + key, "is missing");
  return object[key];
}

std::string text_in(const Json& object, const char* key) {
  const Json& value = member(object, "", key);
  if (!value.is_string()) fail(key, "must be a string");
  return value.get<std::string>();
}

std::int64_t whole(const Json& value, const std::string& path, std::int64_t min, std::int64_t max) {
  if (!is_whole(value, min, max)) {
    fail(path, "must be a whole number from " + std::to_string(min) + " to " + std::to_string(max));
  }
  return value.get<std::int64_t>();
}

double number(const Json& value, const std::string& path) {
  const double number = value.is_number() ? value.get<double>() : 2 * kMaxCaseNumber;
  if (!(std::abs(number) <= kMaxCaseNumber)) fail(path, "must be a number from -100000000 to 100000000");
  return number;
}

std::vector<double> numbers(const Json& value, const std::string& path, std::size_t count) {
  if (!value.is_array() || value.size() != count)
    fail(path, "must be a list of " + std::to_string(count) + " numbers");
  std::vector<double> list;
  for (const Json& entry : value) list.push_back(number(entry, path));
  return list;
}

const Json& list_in(const Json& object, const char* key) {
  static const Json kNone = Json::array();
  if (!object.contains(key)) return kNone;
  if (!object[key].is_array()) fail(key, "must be a list");
  return object[key];
}

CaseInput read_input(const Json& json, const std::string& path) {
  if (!json.is_object()) fail(path, "must be an object");
  CaseInput input;
  input.frame = whole(member(json, path + ".", "frame"), path + ".frame", 1, kMaxFrames);
  if (json.contains("mouse")) {
    const std::vector<double> at = numbers(json["mouse"], path + ".mouse", 2);
    input.mouse = {at[0], at[1]};
  }
  if (json.contains("down")) {
    if (!json["down"].is_boolean()) fail(path + ".down", "must be true or false");
    input.mouse_down = json["down"].get<bool>();
  }
  if (!json.contains("keys")) return input;
  const auto wrong_keys = [&] { fail(path + ".keys", "must be a list of \"left\", \"right\" and \"jump\""); };
  if (!json["keys"].is_array()) wrong_keys();
  for (const Json& key : json["keys"]) {
    if (key != "left" && key != "right" && key != "jump") wrong_keys();
    (key == "left" ? input.left : key == "right" ? input.right : input.jump) = true;
  }
  return input;
}

CaseEdit read_edit(const Json& json, const std::string& path, std::int64_t frames) {
  if (!json.is_object()) fail(path, "must be an object");
  CaseEdit edit;
  edit.frame = whole(member(json, path + ".", "frame"), path + ".frame", 0, frames);
  if (json.contains("remove"))
    edit.remove = static_cast<int>(whole(json["remove"], path + ".remove", 1, kMaxId));
  if (json.contains("turn_round")) {
    if (json["turn_round"] != true) fail(path + ".turn_round", "must be true");
    edit.turns_round = true;
  }
  if (edit.remove == 0 && !edit.turns_round) fail(path, "must have \"remove\" or \"turn_round\"");
  return edit;
}

// Adds an entry to a list that is sorted by frame.
template <class Entry>
void add_by_frame(std::vector<Entry>& list, const Entry& entry, const std::string& path) {
  if (!list.empty() && entry.frame < list.back().frame) fail(path + ".frame", "goes backwards");
  list.push_back(entry);
}

void read_line(const Json& points, const std::string& path, CaseFloor& floor) {
  std::vector<Vec2> ends;
  for (const Json& point : points) {
    const std::vector<double> at = numbers(point, path, 2);
    ends.push_back({at[0], at[1]});
  }
  if (ends.size() < 2) fail(path, "must have at least two points");
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (ends[i].x <= ends[i - 1].x) fail(path, "must go from left to right");
    floor.parts.emplace_back(Segment{ends[i - 1], ends[i]});
    if (floor.parts.size() > kMaxFloorParts) return;  // read_case() reports it
  }
}

void read_floor_part(const Json& part, const std::string& path, CaseFloor& floor) {
  if (part.is_array()) return read_line(part, path, floor);
  for (const char* key : {"arc", "bowl"}) {
    if (!part.is_object() || !part.contains(key)) continue;
    const auto n = numbers(part[key], path + "." + key, 5);
    floor.parts.emplace_back(Arc{{n[0], n[1]}, n[2], n[3], n[4], key == std::string_view("arc")});
    return;
  }
  if (part.is_object() && part.contains("sine")) {
    const auto n = numbers(part["sine"], path + ".sine", 6);
    floor.parts.emplace_back(Sine{n[0], n[1], n[2], n[3], n[4], n[5]});
  } else {
    fail(path, "must be a list of points, or an object with \"arc\", \"bowl\" or \"sine\"");
  }
}

CaseCheck::Measure measure_of(const Json& key, const std::string& path) {
  const auto& infos = case_measure_infos();
  const auto found =
      std::find_if(infos.begin(), infos.end(), [&](const CaseMeasureInfo& info) { return key == info.key; });
  if (found == infos.end()) fail(path, "must be one of the measures");
  return found->measure;
}

CaseCheck read_check(const Json& json, const std::string& path, std::int64_t frames) {
  if (!json.is_object()) fail(path, "must be an object");
  CaseCheck check;
  check.measure = measure_of(member(json, path + ".", "measure"), path + ".measure");
  if (json.contains("body")) check.body = static_cast<int>(whole(json["body"], path + ".body", 1, kMaxId));
  if (json.contains("frame")) check.first = check.last = whole(json["frame"], path + ".frame", 1, frames);
  if (json.contains("frames")) {
    if (!json["frames"].is_array() || json["frames"].size() != 2) fail(path + ".frames", "must be [a, b]");
    check.first = whole(json["frames"][0], path + ".frames", 1, frames);
    check.last = whole(json["frames"][1], path + ".frames", check.first, frames);
  }
  const auto take = [&](const char* key, std::optional<double>& value) {
    if (json.contains(key)) value = number(json[key], path + "." + key);
  };
  take("x", check.x);
  take("y", check.y);
  take("right", check.right);
  take("bottom", check.bottom);
  if (json.contains("bound")) check.bound = number(json["bound"], path + ".bound");
  return check;
}

// The moved level must be one, too.
void check_translate(const CaseCheck& check, const std::string& path, const Level& level) {
  const TileSize tile = level.map.tile_size();
  const auto tiles = [&](const std::optional<double>& px, int side, const char* key) {
    const double count = px.value_or(0) / side;
    if (!(count >= 0) || count != std::floor(count))
      fail(path + "." + key, "must be whole tiles to move by, 0 or more");
    return static_cast<std::int64_t>(count);
  };
  const std::int64_t columns = tiles(check.x, tile.width, "x"), rows = tiles(check.y, tile.height, "y");
  if (is_terrain_size(level.map.width() + columns, level.map.height() + rows, tile)) return;
  fail(path, "moves the level by " + std::to_string(columns) + "x" + std::to_string(rows) +
                 " tiles, which makes it larger than a level may be");
}

HardCase read_case(const Json& json, const Level& level) {
  if (!json.is_object()) throw Wrong{{"key hard_case", "must be an object"}};
  HardCase hard;
  hard.number = static_cast<int>(whole(member(json, "", "number"), "number", 1, 999));
  hard.title = text_in(json, "title");
  hard.set_up = text_in(json, "set_up");
  hard.right_answer = text_in(json, "right_answer");
  hard.frames = whole(member(json, "", "frames"), "frames", 1, kMaxFrames);
  const auto each = [&](const char* key, auto read) {
    const Json& list = list_in(json, key);
    for (std::size_t i = 0; i < list.size(); ++i)
      read(list[i], std::string(key) + "[" + std::to_string(i) + "]");
  };
  each("input", [&](const Json& entry, const std::string& path) {
    add_by_frame(hard.input, read_input(entry, path), path);
  });
  each("edits", [&](const Json& entry, const std::string& path) {
    if (hard.edits.size() == kMaxEdits)
      fail("edits", "may have at most " + std::to_string(kMaxEdits) + " edits");
    add_by_frame(hard.edits, read_edit(entry, path, hard.frames), path);
  });
  each("floor", [&](const Json& part, const std::string& path) {
    read_floor_part(part, path, hard.floor);
    if (hard.floor.parts.size() > kMaxFloorParts)
      fail("floor", "may have at most " + std::to_string(kMaxFloorParts) + " lines and curves");
  });
  each("checks", [&](const Json& check, const std::string& path) {
    if (hard.checks.size() == kMaxChecks)
      fail("checks", "may have at most " + std::to_string(kMaxChecks) + " checks");
    hard.checks.push_back(read_check(check, path, hard.frames));
    if (hard.checks.back().measure == CaseCheck::Measure::translate)
      check_translate(hard.checks.back(), path, level);
  });
  return hard;
}

}  // namespace

std::span<const std::string_view> hard_case_keys() {
  static constexpr std::array<std::string_view, 24> kKeys = {
      "hard_case", "number", "title", "set_up", "right_answer", "measure", "body",   "frame",
      "frames",    "mouse",  "down",  "keys",   "input",        "edits",   "remove", "turn_round",
      "floor",     "arc",    "bowl",  "sine",   "checks",       "right",   "bottom", "bound"};
  return kKeys;
}

FormatResult<std::optional<HardCase>> hard_case_of(const Level& level) {
  if (level.extra.empty()) return std::nullopt;
  const auto keys = parse_json(level.extra);
  if (!keys) return tl::unexpected(keys.error());
  if (!keys->contains("hard_case")) return std::nullopt;
  try {
    return read_case((*keys)["hard_case"], level);
  } catch (const Wrong& wrong) {
    return tl::unexpected(wrong.error);
  }
}

}  // namespace talus
