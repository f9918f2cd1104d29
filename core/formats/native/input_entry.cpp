// Reads and writes input entries.
#include "input_entry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace talus {
namespace {

constexpr double kMaxMouse = 1e8;  // px; farther away than any level reaches

// The keys in the list are held, all others are up.
std::string take_keys(const Json& names, RecordedInput& entry) {
  if (!names.is_array()) return "\"keys\" must be a list of names";
  entry.left = entry.right = entry.jump = false;
  for (const Json& name : names) {
    if (name == "left") {
      entry.left = true;
    } else if (name == "right") {
      entry.right = true;
    } else if (name == "jump") {
      entry.jump = true;
    } else {
      return "\"keys\" may hold \"left\", \"right\" and \"jump\", not " + name.dump();
    }
  }
  return "";
}

std::string take_mouse(const Json& at, RecordedInput& entry) {
  if (!at.is_array() || at.size() != 2 || !at[0].is_number() || !at[1].is_number())
    return "\"mouse\" must be [x, y]";
  entry.mouse = {at[0].get<double>(), at[1].get<double>()};
  const bool near = std::abs(entry.mouse.x) <= kMaxMouse && std::abs(entry.mouse.y) <= kMaxMouse;
  return near ? "" : "\"mouse\" must lie within 100 million pixels";
}

std::string take_member(const std::string& key, const Json& value, RecordedInput& entry) {
  if (key == "frame") {
    if (!is_whole(value, 1, std::numeric_limits<std::int64_t>::max()))
      return "\"frame\" must be a whole number from 1";
    entry.frame = value.get<std::int64_t>();
  } else if (key == "mouse") {
    return take_mouse(value, entry);
  } else if (key == "down") {
    if (!value.is_boolean()) return "\"down\" must be true or false";
    entry.mouse_down = value.get<bool>();
  } else if (key == "grab") {
    if (!is_whole(value, 0, 1'000'000'000)) return "\"grab\" must be the number of a body, from 0";
    entry.grab = value.get<int>();
  } else if (key == "keys") {
    return take_keys(value, entry);
  } else {
    return "unknown key " + Json(key).dump();
  }
  return "";
}

}  // namespace

std::string take_input_entry(const Json& json, RecordedInput& entry) {
  if (!json.is_object()) return "an input line must be a JSON object";
  for (const auto& [key, value] : json.items()) {
    if (const std::string wrong = take_member(key, value, entry); !wrong.empty()) return wrong;
  }
  return json.contains("frame") ? "" : "\"frame\" is missing";
}

FormatResult<std::vector<RecordedInput>> read_input_lines(std::string_view text) {
  std::vector<RecordedInput> inputs;
  RecordedInput entry;
  for (std::int64_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;
    const auto json = parse_json(line, {}, number);
    if (!json) return tl::unexpected(json.error());
    const std::int64_t last_frame = entry.frame;
    std::string wrong = take_input_entry(*json, entry);
    if (wrong.empty() && entry.frame < last_frame) wrong = "\"frame\" goes backwards";
    if (!wrong.empty()) return tl::unexpected(FormatError{"line " + std::to_string(number), wrong});
    inputs.push_back(entry);
  }
  return inputs;
}

Json input_entry(const RecordedInput& entry, const RecordedInput& before) {
  Json json = {{"frame", entry.frame}};
  if (entry.mouse != before.mouse) json["mouse"] = {json_number(entry.mouse.x), json_number(entry.mouse.y)};
  if (entry.mouse_down != before.mouse_down) json["down"] = entry.mouse_down;
  if (entry.grab != before.grab) json["grab"] = entry.grab;
  if (entry.left == before.left && entry.right == before.right && entry.jump == before.jump) return json;
  Json& keys = json["keys"] = Json::array();
  if (entry.left) keys.push_back("left");
  if (entry.right) keys.push_back("right");
  if (entry.jump) keys.push_back("jump");
  return json;
}

}  // namespace talus
