// What members of each kind must be, and the sentences that say so.
#include "native_members.h"

#include <algorithm>
#include <charconv>

namespace talus {
namespace {

bool is_in(const Json& json, double min, double max) {
  return json.is_number() && json.get<double>() >= min && json.get<double>() <= max;
}

bool are_numbers(const Json& json) {
  return json.is_array() &&
         std::all_of(json.begin(), json.end(), [](const Json& v) { return v.is_number(); });
}

}  // namespace

std::string range_text(double min, double max, std::string_view unit, bool whole) {
  std::string text = whole ? "must be a whole number from " : "must be a number from ";
  text += json_number(min).dump() + " to " + json_number(max).dump();  // "64", not "64.000000"
  return unit.empty() ? text : text + " " + std::string(unit);
}

std::string choice_text(ChoiceNames names) {
  std::string text = "must be ";
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text.append("\"").append(names[i]).append("\"");
  }
  return text;
}

std::string length_text(std::size_t most) {
  return "must be a string of up to " + std::to_string(most) + " bytes";
}

std::optional<std::size_t> number_of_key(const std::string& key, std::size_t count) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
  const bool good = error == std::errc() && end == key.data() + key.size() && number < count &&
                    std::to_string(number) == key;
  return good ? std::optional(number) : std::nullopt;
}

std::string no_tile_text(const std::string& key) {
  return "has the key \"" + key + "\", which is no number of a tile";
}

std::string too_many_unknown() {
  return "has more than " + std::to_string(kMaxUnknownKeys) + " keys that this Talus does not know";
}

FormatResult<Json> parse_extra(const std::string& extra) {
  if (extra.empty()) return Json::object();
  auto json = parse_json(extra);
  if (!json || !json->is_object())
    return tl::unexpected(FormatError{"", "the level's unknown keys are not a JSON object"});
  return json;
}

MemberTaker::MemberTaker(Json& json, const std::string& path) : json_(json), path_(path) {
  if (!json.is_object()) fail("", "must be an object");
}

void MemberTaker::require(const char* key) {
  if (!error_ && !json_.contains(key)) fail(key, "is missing");
}

void MemberTaker::ranged(const char* key, double min, double max, std::string_view unit, double& value) {
  member(key, [&](const Json& json) {
    if (!is_in(json, min, max)) return fail(key, range_text(min, max, unit));
    value = json.get<double>();
  });
}

void MemberTaker::text(const char* key, std::size_t most, std::string& value) {
  member(key, [&](const Json& json) {
    const bool good = json.is_string() && json.get_ref<const std::string&>().size() <= most;
    if (!good) return fail(key, length_text(most));
    value = json.get<std::string>();
  });
}

void MemberTaker::size(const char* key, Vec2& value) {
  member(key, [&](const Json& json) {
    const bool good = json.is_array() && json.size() == 2 && is_in(json[0], kMinBodySize, kMaxBodySize) &&
                      is_in(json[1], kMinBodySize, kMaxBodySize);
    if (!good) return fail(key, "must be [width, height], each from 0.00390625 to 1024 px");
    value = {json[0].get<double>(), json[1].get<double>()};
  });
}

void MemberTaker::fail(std::string_view key, std::string message) {
  const std::string place = key.empty() ? path_ : path_ + "." + std::string(key);
  if (!error_) error_ = FormatError{"key " + place, std::move(message)};
}

void MemberTaker::read(const Json& json, const char* key, double& value) {
  if (!json.is_number()) return fail(key, "must be a number");
  value = json.get<double>();
}

void MemberTaker::read(const Json& json, const char* key, int& value) {
  if (!is_whole(json, -999, 999)) return fail(key, "must be a whole number");
  value = json.get<int>();
}

void MemberTaker::read(const Json& json, const char* key, bool& value) {
  if (!json.is_boolean()) return fail(key, "must be true or false");
  value = json.get<bool>();
}

void MemberTaker::read(const Json& json, const char* key, std::string& value) {
  if (!json.is_string()) return fail(key, "must be a string");
  value = json.get<std::string>();
}

void MemberTaker::read(const Json& json, const char* key, Vec2& value) {
  if (!are_numbers(json) || json.size() != 2) return fail(key, "must be a point [x, y]");
  value = {json[0].get<double>(), json[1].get<double>()};
}

void MemberTaker::read(const Json& json, const char* key, std::vector<double>& values) {
  if (!are_numbers(json)) return fail(key, "must be a list of numbers");
  values = json.get<std::vector<double>>();
}

void MemberTaker::read(const Json& json, const char* key, std::vector<Vec2>& points) {
  const auto is_point = [](const Json& point) { return are_numbers(point) && point.size() == 2; };
  if (!json.is_array() || !std::all_of(json.begin(), json.end(), is_point))
    return fail(key, "must be a list of points [x, y]");
  for (const Json& point : json) points.push_back({point[0].get<double>(), point[1].get<double>()});
}

void MemberPutter::operator()(const char* key, const std::vector<Vec2>& points) {
  Json& list = json_[key] = Json::array();
  for (const Vec2 point : points) list.push_back({json_number(point.x), json_number(point.y)});
}

void MemberPutter::operator()(const char* key, const std::vector<double>& values) {
  Json& list = json_[key] = Json::array();
  for (const double value : values) list.push_back(json_number(value));
}

}  // namespace talus
