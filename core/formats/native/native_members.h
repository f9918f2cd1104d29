// Members of JSON objects, and lists of objects; shared by the parts of native levels (see native.h).
//
// What is read is taken out of the JSON, so what remains is unknown. Errors have their place by key: "key
// curves[3].radius".
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../text/json_text.h"

namespace talus {

using ChoiceNames = std::span<const std::string_view>;  // of an enum's values, in order

// "must be a number from -64 to 64 px/frame", or "a whole number".
std::string range_text(double min, double max, std::string_view unit, bool whole = false);
// "must be "floor" or "ceiling"".
std::string choice_text(ChoiceNames names);
// "must be a string of up to 1000 bytes".
std::string length_text(std::size_t most);

// The number below `count` that a key spells without leading zeros; nothing for any other key.
std::optional<std::size_t> number_of_key(const std::string& key, std::size_t count);

// "has the key "x", which is no number of a tile".
std::string no_tile_text(const std::string& key);

// "has more than 65536 keys that this Talus does not know".
std::string too_many_unknown();

// Unknown keys as a level keeps them. The result is an object in any case.
FormatResult<Json> parse_extra(const std::string& extra);

// Takes members out of an object and remembers the first error.
class MemberTaker {
 public:
  // Both must outlive it. JSON that is not an object is an error.
  MemberTaker(Json& json, const std::string& path);

  // A member that must be there.
  template <class Value>
  void operator()(const char* key, Value& value) {
    require(key);
    optional(key, value);
  }
  void require(const char* key);
  // A member that keeps its value if it is missing.
  template <class Value>
  void optional(const char* key, Value& value) {
    member(key, [&](const Json& json) { read(json, key, value); });
  }
  // Whether the member is there and is one of the names.
  template <class Enum>
  bool choice(const char* key, ChoiceNames names, Enum& value) {
    bool chosen = false;
    member(key, [&](const Json& json) {
      const auto found = std::find(names.begin(), names.end(), json);
      if (found == names.end()) return fail(key, choice_text(names));
      value = static_cast<Enum>(found - names.begin());
      chosen = true;
    });
    return chosen;
  }
  void ranged(const char* key, double min, double max, std::string_view unit, double& value);
  // A string of up to `most` bytes.
  void text(const char* key, std::size_t most, std::string& value);
  // The size of a body.
  void size(const char* key, Vec2& value);
  // Calls read(value) if the member is there.
  template <class Read>
  void member(const char* key, Read read) {
    if (error_) return;
    const auto found = json_.find(key);
    if (found == json_.end()) return;
    read(std::as_const(*found));
    json_.erase(key);
  }
  // Sets an error about a member; about the whole object with the key "".
  void fail(std::string_view key, std::string message);

  // Returns the value, unless a member or the whole object is wrong.
  template <class Value>
  FormatResult<Value> result(Value value, std::optional<std::string> problem = {}) {
    if (problem) fail("", *std::move(problem));
    if (json_.size() > kMaxUnknownKeys) fail("", too_many_unknown());
    if (error_) return tl::unexpected(*error_);
    return value;
  }
  // The members that were not taken.
  std::string rest() const { return error_ || json_.empty() ? "" : json_.dump(); }

 private:
  void read(const Json& json, const char* key, double& value);
  void read(const Json& json, const char* key, int& value);
  void read(const Json& json, const char* key, bool& value);
  void read(const Json& json, const char* key, std::string& value);
  void read(const Json& json, const char* key, Vec2& value);
  void read(const Json& json, const char* key, std::vector<double>& values);
  void read(const Json& json, const char* key, std::vector<Vec2>& points);

  Json& json_;
  const std::string& path_;
  std::optional<FormatError> error_;
};

// Sets members of an object; the counterpart of MemberTaker.
class MemberPutter {
 public:
  explicit MemberPutter(Json& json) : json_(json) {}
  void operator()(const char* key, double value) { json_[key] = json_number(value); }
  void operator()(const char* key, Vec2 value) { json_[key] = {json_number(value.x), json_number(value.y)}; }
  void operator()(const char* key, const std::vector<double>& values);
  void operator()(const char* key, const std::vector<Vec2>& points);

 private:
  Json& json_;
};

// Reads each entry of a list with take(entry, path of the entry). Anything but a list, or a list of more than
// `most` entries, is the error `wanted`.
template <class Value, class Take>
FormatResult<std::vector<Value>> take_list(Json& list, const std::string& path, Take take,
                                           std::size_t most = SIZE_MAX,
                                           const char* wanted = "must be a list") {
  if (!list.is_array() || list.size() > most) return tl::unexpected(FormatError{"key " + path, wanted});
  std::vector<Value> values;
  values.reserve(list.size());
  for (Json& json : list) {
    auto value = take(json, path + "[" + std::to_string(values.size()) + "]");
    if (!value) return tl::unexpected(value.error());
    values.push_back(*std::move(value));
  }
  return values;
}

// The counterpart of take_list: put(value, path) makes each entry.
template <class Value, class Put>
FormatResult<Json> put_list(const std::vector<Value>& values, const std::string& path, Put put) {
  Json list = Json::array();
  for (const Value& value : values) {
    auto json = put(value, path + "[" + std::to_string(list.size()) + "]");
    if (!json) return json;
    list.push_back(*std::move(json));
  }
  return list;
}

}  // namespace talus
