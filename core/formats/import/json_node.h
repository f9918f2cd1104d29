// Members of objects in the JSON of other programs: values, or an error with its place.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "../text/json_text.h"

namespace talus {

// In an object that was an XML element: its line number, for errors.
inline constexpr const char* kXmlLineKey = "@line";

// An object of a file, with its path.
struct JsonNode {
  const Json& json;
  std::string path;  // "layers[2]"; empty: the file itself

  const Json* find(std::string_view key) const {
    const auto found = json.find(key);
    return found == json.end() ? nullptr : &*found;
  }
  std::string path_of(std::string_view key) const {
    return path.empty() || key.empty() ? path + std::string(key) : path + "." + std::string(key);
  }
  std::string place_of(std::string_view key) const {
    if (const Json* line = find(kXmlLineKey)) return "line " + line->dump();
    const std::string where = path_of(key);
    return where.empty() ? "" : "key " + where;
  }
};

// Reads members, and keeps the first error. After an error it goes on with fallbacks.
class JsonNodeReader {
 protected:
  // The value, or the error.
  template <class Value>
  FormatResult<Value> result(Value value) {
    if (error_) return tl::unexpected(*error_);
    return value;
  }
  void fail(const JsonNode& node, std::string_view key, std::string message) {
    if (!error_) error_ = FormatError{node.place_of(key), std::move(message)};
  }
  double number(const JsonNode& node, const char* key, double fallback = 0);
  int whole(const JsonNode& node, const char* key, int min, int max, int fallback);
  std::string text(const JsonNode& node, const char* key);
  static bool truth(const JsonNode& node, const char* key);
  // Calls use(entry) for each object of a list that may be missing.
  template <class Use>
  void for_each(const JsonNode& node, const char* key, Use use) {
    const Json* list = node.find(key);
    if (list == nullptr) return;
    if (!list->is_array()) return fail(node, key, std::string("must have a list as ") + key);
    for (std::size_t i = 0; i < list->size() && !error_; ++i) {
      const JsonNode entry{(*list)[i], node.path_of(key) + "[" + std::to_string(i) + "]"};
      if (entry.json.is_object())
        use(entry);
      else
        fail(entry, "", "must be an object");
    }
  }

  std::optional<FormatError> error_;
};

}  // namespace talus
