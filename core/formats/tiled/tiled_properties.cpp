#include "tiled_properties.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "../text/json_text.h"

namespace talus {
namespace {

std::string compact(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

decltype(TiledProperty::value) value_of(const Json& json) {
  const bool is_large = json.is_number_unsigned() && json > std::numeric_limits<std::int64_t>::max();
  if (json.is_boolean()) return json.get<bool>();
  if (json.is_number_integer() && !is_large) return json.get<std::int64_t>();
  if (json.is_number()) return json.get<double>();
  return json.is_string() ? json.get<std::string>() : compact(json);
}

}  // namespace

std::string json_of_properties(const TiledProperties& properties) {
  if (properties.empty()) return "";
  Json json = Json::object();
  for (const TiledProperty& property : properties)
    json[property.name] = std::visit([](const auto& value) { return Json(value); }, property.value);
  return compact(json);
}

TiledProperties properties_of_json(const std::string& json) {
  TiledProperties properties;
  const auto object = json.empty() ? FormatResult<Json>(Json::object()) : parse_json(json);
  if (!object || !object->is_object()) return properties;
  for (const auto& [name, value] : object->items()) properties.push_back({name, value_of(value)});
  return properties;
}

void put_property(TiledProperties& properties, TiledProperty property) {
  std::erase_if(properties, [&](const TiledProperty& other) { return other.name == property.name; });
  properties.push_back(std::move(property));
}

bool have_same_values(const std::string& a, const std::string& b) {
  const auto values = [](const std::string& json) {
    TiledProperties properties = properties_of_json(json);
    std::erase_if(properties, [](const TiledProperty& p) { return std::holds_alternative<bool>(p.value); });
    return properties;
  };
  return a == b || values(a) == values(b);
}

std::vector<TiledPropertyEdit> property_edits(const std::string& before, const std::string& now) {
  const TiledProperties was = properties_of_json(before), is = properties_of_json(now);
  const auto has_name = [](const TiledProperties& properties, const std::string& name) {
    return std::any_of(properties.begin(), properties.end(),
                       [&](const TiledProperty& property) { return property.name == name; });
  };
  std::vector<TiledPropertyEdit> edits;
  for (const TiledProperty& property : was)
    if (!has_name(is, property.name)) edits.push_back({property.name, std::nullopt});
  for (const TiledProperty& property : is)
    if (std::find(was.begin(), was.end(), property) == was.end())
      edits.push_back({property.name, property.value});
  return edits;
}

}  // namespace talus
