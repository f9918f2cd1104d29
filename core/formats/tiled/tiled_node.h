// Members of objects in Tiled's JSON: values, or an error with its place.
#pragma once

#include <algorithm>
#include <initializer_list>
#include <optional>

#include "../text/json_text.h"
#include "tiled_map.h"

namespace talus {

// In an object that was an XML element: its line number, for errors.
inline constexpr const char* kTiledLineKey = "@line";

// An object of a file, with its path.
struct TiledNode {
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
    if (const Json* line = find(kTiledLineKey)) return "line " + line->dump();
    const std::string where = path_of(key);
    return where.empty() ? "" : "key " + where;
  }
};

// Reads members, and keeps the first error. After an error it goes on with fallbacks.
class TiledNodeReader {
 protected:
  using Keys = std::initializer_list<std::string_view>;

  explicit TiledNodeReader(TiledDrops& drops) : drops_(drops) {}

  // The value, or the error.
  template <class Value>
  FormatResult<Value> result(Value value) {
    if (error_) return tl::unexpected(*error_);
    return value;
  }
  void fail(const TiledNode& node, std::string_view key, std::string message) {
    if (!error_) error_ = FormatError{node.place_of(key), std::move(message)};
  }
  double number(const TiledNode& node, const char* key, double fallback = 0);
  int whole(const TiledNode& node, const char* key, int min, int max, int fallback);
  std::string text(const TiledNode& node, const char* key);
  static bool truth(const TiledNode& node, const char* key);
  // Tiled 1.9 renamed "type" to "class"; 1.10 took that back.
  static const char* class_key(const TiledNode& node) { return node.find("class") ? "class" : "type"; }
  // Calls use(entry) for each object of a list that may be missing.
  template <class Use>
  void for_each(const TiledNode& node, const char* key, Use use) {
    const Json* list = node.find(key);
    if (list == nullptr) return;
    if (!list->is_array()) return fail(node, key, std::string("must have a list as ") + key);
    for (std::size_t i = 0; i < list->size() && !error_; ++i) {
      const TiledNode entry{(*list)[i], node.path_of(key) + "[" + std::to_string(i) + "]"};
      if (entry.json.is_object())
        use(entry);
      else
        fail(entry, "", "must be an object");
    }
  }
  // Adds the members that nobody reads to the dropped ones.
  void drop_others(const TiledNode& node, const std::string& of, Keys known);

  TiledDrops& drops_;
  std::optional<FormatError> error_;
};

}  // namespace talus
