// Joins objects and templates as JSON, so that one function reads both.
#include "tiled_templates.h"

#include <set>

namespace talus {
namespace {

// The object's properties, and those of the template with other names.
Json joined_properties(const Json& own, const Json& inherited) {
  if (!own.is_array() || !inherited.is_array()) return own;
  const auto name_of = [](const Json& property) -> std::string {
    const auto name = property.is_object() ? property.find("name") : property.end();
    return name != property.end() && name->is_string() ? name->get<std::string>() : "";
  };
  std::set<std::string> names;
  for (const Json& property : own) names.insert(name_of(property));
  Json all = own;
  for (const Json& property : inherited) {
    if (!names.contains(name_of(property))) all.push_back(property);
  }
  return all;
}

}  // namespace

FormatResult<TiledTemplate> read_tiled_template(const Json& json, const std::string& folder) {
  const bool is_template = json.is_object() && json.contains("object") && json["object"].is_object();
  if (!is_template) return tl::unexpected(FormatError{"", "is not a template of Tiled"});
  TiledTemplate read{json["object"], "", 1, 0};
  read.object.erase("template");  // templates are not nested
  for (const char* place : {"x", "y", "id"}) read.object.erase(place);
  const auto tileset = json.find("tileset");
  if (tileset == json.end() || !tileset->is_object()) return read;
  if (const auto source = tileset->find("source"); source != tileset->end() && source->is_string())
    read.tileset = tiled_path(folder, *source);
  if (const auto first = tileset->find("firstgid"); first != tileset->end() && first->is_number_integer())
    read.first_gid = *first;
  return read;
}

Json with_template(const Json& object, const TiledTemplate& from, std::uint32_t first_gid) {
  Json joined = from.object;
  if (const auto gid = joined.find("gid"); gid != joined.end() && gid->is_number_integer()) {
    const auto number = gid->get<std::int64_t>();
    const std::int64_t id = (number & kTiledIdBits) - from.first_gid;
    const bool is_known = first_gid > 0 && number >= from.first_gid && number <= 0xffffffff && id >= 0 &&
                          id + first_gid <= kTiledIdBits;
    *gid = is_known ? (number & ~std::int64_t{kTiledIdBits}) | (id + first_gid) : 0;
  }
  if (object.contains("type") || object.contains("class")) joined.erase("type"), joined.erase("class");
  for (auto it = object.begin(); it != object.end(); ++it) {
    Json& member = joined[it.key()];
    member =
        it.key() == "properties" && !member.is_null() ? joined_properties(it.value(), member) : it.value();
  }
  return joined;
}

}  // namespace talus
