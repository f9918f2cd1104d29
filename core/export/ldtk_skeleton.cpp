#include "ldtk_skeleton.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr const char* kAsset = "templates/ldtk.json";
constexpr const char* kParts[] = {
    "project", "level", "layer_definition", "entity_definition", "field_definition", "tileset_definition"};

// LDtk has whole pixels.
int rounded_px(double px) { return static_cast<int>(std::lround(std::clamp(px, -1e9, 1e9))); }

}  // namespace

OrderedJson LdtkSkeleton::filled(const char* part, const OrderedJson& changes) const {
  OrderedJson object = parts_.at(part);
  object.update(changes);
  return object;
}

OrderedJson LdtkSkeleton::field_definition(const std::string& name, const std::string& type, int uid) const {
  return filled("field_definition",
                {{"identifier", name}, {"__type", type}, {"uid", uid}, {"type", "F_" + type}});
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

std::string ldtk_iid(int number) {
  const std::string digits = std::to_string(number);
  return "7a105000-0000-11f0-8000-" + std::string(12 - digits.size(), '0') + digits;
}

OrderedJson ldtk_field(const std::string& name, const std::string& type, const OrderedJson& value, int uid) {
  const bool is_tile = type == "Tile";
  OrderedJson edited = OrderedJson::array();
  if (is_tile && !value.is_null()) {
    std::string rect;
    for (const char* const key : {"x", "y", "w", "h"})
      rect += (rect.empty() ? "" : ",") + std::to_string(value[key].get<int>());
    edited.push_back({{"id", "V_String"}, {"params", OrderedJson::array({rect})}});
  } else if (!value.is_null()) {
    edited.push_back({{"id", "V_" + type}, {"params", OrderedJson::array({value})}});
  }
  return {{"__identifier", name}, {"__type", type},
          {"__value", value},     {"__tile", is_tile ? value : OrderedJson()},
          {"defUid", uid},        {"realEditorValues", edited}};
}

OrderedJson ldtk_entity(const LdtkEntityHead& head, int cell) {
  const int x = rounded_px(head.box.x), y = rounded_px(head.box.y);
  const auto cell_of = [&](int px) { return static_cast<int>(std::floor(1.0 * px / cell)); };
  return {{"__identifier", head.identifier},
          {"__grid", {cell_of(x), cell_of(y)}},
          {"__pivot", {0, 0}},
          {"__tags", OrderedJson::array()},
          {"__tile", nullptr},
          {"__smartColor", head.color},
          {"__worldX", x},
          {"__worldY", y},
          {"iid", ldtk_iid(head.iid)},
          {"width", std::max(1, rounded_px(head.box.w))},
          {"height", std::max(1, rounded_px(head.box.h))},
          {"defUid", head.uid},
          {"px", {x, y}},
          {"fieldInstances", OrderedJson::array()}};
}

}  // namespace talus
