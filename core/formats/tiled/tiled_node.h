// Members of objects in Tiled's JSON.
#pragma once

#include <initializer_list>

#include "../import/import_drops.h"
#include "../import/json_node.h"

namespace talus {

// Reads members, and keeps the first error. After an error it goes on with fallbacks.
class TiledNodeReader : protected JsonNodeReader {
 protected:
  using Keys = std::initializer_list<std::string_view>;

  explicit TiledNodeReader(ImportDrops& drops) : drops_(drops) {}
  // Tiled 1.9 renamed "type" to "class"; 1.10 took that back.
  static const char* class_key(const JsonNode& node) { return node.find("class") ? "class" : "type"; }
  // Adds the members that nobody reads to the dropped ones.
  void drop_others(const JsonNode& node, const std::string& of, Keys known);

  ImportDrops& drops_;
};

}  // namespace talus
