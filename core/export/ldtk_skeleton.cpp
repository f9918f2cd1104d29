#include "ldtk_skeleton.h"

namespace talus {
namespace {

constexpr const char* kAsset = "templates/ldtk.json";
constexpr const char* kParts[] = {
    "project", "level", "layer_definition", "entity_definition", "field_definition", "tileset_definition"};

}  // namespace

OrderedJson LdtkSkeleton::filled(const char* part, const OrderedJson& changes) const {
  OrderedJson object = parts_.at(part);
  object.update(changes);
  return object;
}

FormatResult<LdtkSkeleton> read_ldtk_skeleton(const ReadAsset& read_asset) {
  const FormatResult<std::string> text = read_asset(kAsset);
  if (!text) return tl::unexpected(text.error());
  OrderedJson parts = OrderedJson::parse(*text, nullptr, false);
  for (const char* part : kParts) {
    if (!parts.is_object() || !parts.contains(part) || !parts[part].is_object())
      return tl::unexpected(FormatError{kAsset, "has no object \"" + std::string(part) + "\""});
  }
  return LdtkSkeleton(std::move(parts));
}

}  // namespace talus
