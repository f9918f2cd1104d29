// Values of members.
#include "tiled_node.h"

#include <cmath>

namespace talus {
namespace {

// Members that have no meaning while they have their default values.
bool says_nothing(std::string_view key, const Json& value) {
  if (key == "opacity" || key == "parallaxx" || key == "parallaxy") return value == 1;
  if (key == "x" || key == "y" || key == "offsetx" || key == "offsety") return value == 0;
  return value == "" || (value.is_structured() && value.empty()) || key == kTiledLineKey;
}

}  // namespace

double TiledNodeReader::number(const TiledNode& node, const char* key, double fallback) {
  const Json* value = node.find(key);
  if (value == nullptr) return fallback;
  if (value->is_number()) return value->get<double>();
  fail(node, key, std::string("must have a number as ") + key);
  return fallback;
}

int TiledNodeReader::whole(const TiledNode& node, const char* key, int min, int max, int fallback) {
  const double value = number(node, key, fallback);
  if (value >= min && value <= max && value == std::trunc(value)) return static_cast<int>(value);
  fail(node, key,
       "must have a whole number from " + std::to_string(min) + " to " + std::to_string(max) + " as " + key);
  return fallback;
}

std::string TiledNodeReader::text(const TiledNode& node, const char* key) {
  const Json* value = node.find(key);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  fail(node, key, std::string("must have a string as ") + key);
  return {};
}

bool TiledNodeReader::truth(const TiledNode& node, const char* key) {
  const Json* value = node.find(key);
  return value != nullptr && (*value == true || (value->is_number() && *value != 0));
}

void TiledNodeReader::drop_others(const TiledNode& node, const std::string& of, Keys known) {
  for (auto it = node.json.begin(); it != node.json.end(); ++it) {
    const bool is_known = std::find(known.begin(), known.end(), it.key()) != known.end();
    if (!is_known && !says_nothing(it.key(), it.value())) drops_.add(tiled_quoted(it.key()) + " of " + of);
  }
}

}  // namespace talus
