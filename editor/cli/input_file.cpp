#include "input_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace talus {
namespace {

using Json = nlohmann::json;

constexpr double kMaxMouse = 1e6;  // px; farther than any level reaches

// The keys that are held; those that the line does not name are up. Returns what is wrong, or an empty text.
std::string read_keys(const Json& names, Input& input) {
  input.left = input.right = input.jump = false;
  for (const Json& name : names) {
    if (name == "left") {
      input.left = true;
    } else if (name == "right") {
      input.right = true;
    } else if (name == "jump") {
      input.jump = true;
    } else {
      return "\"keys\" may hold \"left\", \"right\" and \"jump\", not " + name.dump();
    }
  }
  return "";
}

// Returns what is wrong with the line, or an empty text after having changed `timed`.
std::string read_line(const Json& line, TimedInput& timed) {
  if (!line.is_object()) return "an input line must be a JSON object";
  for (const auto& [key, value] : line.items()) {
    if (key == "frame") {
      if (!value.is_number_integer() || value.get<std::int64_t>() < 1)
        return "\"frame\" must be a whole number from 1";
      timed.frame = value.get<std::int64_t>();
    } else if (key == "mouse") {
      if (!value.is_array() || value.size() != 2 || !value[0].is_number() || !value[1].is_number()) {
        return "\"mouse\" must be [x, y]";
      }
      timed.input.mouse = {value[0].get<double>(), value[1].get<double>()};
      if (!(std::abs(timed.input.mouse.x) <= kMaxMouse && std::abs(timed.input.mouse.y) <= kMaxMouse)) {
        return "\"mouse\" must lie within a million pixels";
      }
    } else if (key == "down") {
      if (!value.is_boolean()) return "\"down\" must be true or false";
      timed.input.mouse_down = value.get<bool>();
    } else if (key == "keys") {
      if (!value.is_array()) return "\"keys\" must be a list of names";
      if (const std::string wrong = read_keys(value, timed.input); !wrong.empty()) return wrong;
    } else {
      return "unknown key " + Json(key).dump();
    }
  }
  return line.contains("frame") ? "" : "\"frame\" is missing";
}

}  // namespace

tl::expected<std::vector<TimedInput>, FormatError> read_input(std::string_view text) {
  std::vector<TimedInput> inputs;
  TimedInput timed;
  int line_number = 0;
  while (!text.empty()) {
    ++line_number;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.find_first_not_of(" \t\r") == std::string_view::npos) continue;

    const std::string place = "line " + std::to_string(line_number);
    const std::int64_t last_frame = timed.frame;
    const Json json = Json::parse(line, nullptr, false);
    if (json.is_discarded()) return tl::unexpected(FormatError{place, "not a JSON object"});
    const std::string wrong = read_line(json, timed);
    if (!wrong.empty()) return tl::unexpected(FormatError{place, wrong});
    if (timed.frame < last_frame) return tl::unexpected(FormatError{place, "\"frame\" goes backwards"});
    inputs.push_back(timed);
  }
  return inputs;
}

const Input& InputPlayer::at(std::int64_t frame) {
  while (next_ < inputs_.size() && inputs_[next_].frame <= frame) current_ = inputs_[next_++].input;
  return current_;
}

}  // namespace talus
