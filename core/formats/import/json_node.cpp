// Finds members of JSON values, and checks their kinds.
#include "json_node.h"

#include <cmath>

namespace talus {

double JsonNodeReader::number(const JsonNode& node, const char* key, double fallback) {
  const Json* value = node.find(key);
  if (value == nullptr) return fallback;
  if (value->is_number()) return value->get<double>();
  fail(node, key, std::string("must have a number as ") + key);
  return fallback;
}

int JsonNodeReader::whole(const JsonNode& node, const char* key, int min, int max, int fallback) {
  const double value = number(node, key, fallback);
  if (value >= min && value <= max && value == std::trunc(value)) return static_cast<int>(value);
  fail(node, key,
       "must have a whole number from " + std::to_string(min) + " to " + std::to_string(max) + " as " + key);
  return fallback;
}

std::string JsonNodeReader::text(const JsonNode& node, const char* key) {
  const Json* value = node.find(key);
  if (value == nullptr) return {};
  if (value->is_string()) return value->get<std::string>();
  fail(node, key, std::string("must have a string as ") + key);
  return {};
}

bool JsonNodeReader::truth(const JsonNode& node, const char* key) {
  const Json* value = node.find(key);
  return value != nullptr && (*value == true || (value->is_number() && *value != 0));
}

}  // namespace talus
