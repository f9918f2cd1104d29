#include "ldtk_entities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <talus/level/limits.h>
#include "../native/native_object_layers.h"
#include "../tiled/tiled_map.h"
#include "ldtk_meanings.h"

namespace talus {
namespace {

// The fields of an object that Talus exported (see docs/export-data.md).
class ExportedFields {
 public:
  explicit ExportedFields(const Json& fields) : fields_(fields) {}

  std::optional<double> number(const char* key) const {
    const auto found = fields_.find(key);
    if (found == fields_.end() || !found->is_number()) return {};
    return found->get<double>();
  }
  std::string text(const char* key) const {
    const auto found = fields_.find(key);
    return found != fields_.end() && found->is_string() ? found->get<std::string>() : std::string();
  }
  bool truth(const char* key) const {
    const auto found = fields_.find(key);
    return found != fields_.end() && found->is_boolean() && found->get<bool>();
  }
  // Numbers in pairs; empty: there are none, or they are no points.
  std::vector<Vec2> points() const {
    std::vector<Vec2> points;
    const auto list = parse_json(text("points"));
    if (!list || !list->is_array() || list->size() % 2 != 0) return {};
    for (std::size_t i = 0; i < list->size(); i += 2) {
      if (!(*list)[i].is_number() || !(*list)[i + 1].is_number()) return {};
      points.push_back({(*list)[i].get<double>(), (*list)[i + 1].get<double>()});
    }
    return points;
  }

 private:
  const Json& fields_;
};

constexpr std::array<const char*, 14> kExportedKeys = {"form",   "class",  "name",    "x",     "y",
                                                       "w",      "h",      "tile",    "turn",  "rotation",
                                                       "points", "ground", "one_way", "hidden"};

std::optional<MapObject::Form> form_of_word(const std::string& word) {
  using Form = MapObject::Form;
  constexpr std::array<std::pair<const char*, Form>, 7> kWords = {{{"point", Form::box},
                                                                   {"box", Form::box},
                                                                   {"ellipse", Form::ellipse},
                                                                   {"polygon", Form::polygon},
                                                                   {"polyline", Form::polyline},
                                                                   {"tile", Form::tile},
                                                                   {"other", Form::other}}};
  for (const auto& [known, form] : kWords)
    if (word == known) return form;
  return {};
}

// The exact number, if it is what LDtk shows as whole px, of which a size has at least 1.
double exact_or(double exact, double shown, bool is_size = false) {
  const double rounded = std::round(exact);
  return (is_size ? std::max(1.0, rounded) : rounded) == shown ? exact : shown;
}

bool has_points(MapObject::Form form) {
  return form == MapObject::Form::polygon || form == MapObject::Form::polyline;
}

// The number of a tile in a map of Tiled, with its turn.
std::uint32_t turned_tile(double tile, double turn) {
  if (!(tile >= 1 && tile < kTiledFlipXY)) return 0;
  const auto flips = static_cast<TileTurn>(turn >= 0 && turn < kTileTurns ? static_cast<int>(turn) : 0);
  return static_cast<std::uint32_t>(tile) | (has_flip(flips, TileTurn::diagonal) ? kTiledFlipXY : 0) |
         (has_flip(flips, TileTurn::up_down) ? kTiledFlipY : 0) |
         (has_flip(flips, TileTurn::left_right) ? kTiledFlipX : 0);
}

// The object that Talus exported, moved as LDtk moved it; nothing: it is another entity.
std::optional<MapObject> exported_object(const LdtkEntity& entity) {
  const ExportedFields fields(entity.fields);
  const auto form = form_of_word(fields.text("form"));
  const auto x = fields.number("x"), y = fields.number("y"), w = fields.number("w"), h = fields.number("h");
  std::vector<Vec2> points = fields.points();
  if (!form || !x || !y || !w || !h || has_points(*form) == points.empty()) return {};
  MapObject object{.form = *form, .name = fields.text("name"), .type = fields.text("class")};
  object.visible = !fields.truth("hidden");
  object.one_way = fields.truth("one_way");
  if (has_points(*form)) {
    Vec2 corner = points.front();
    for (const Vec2 point : points) corner = {std::min(corner.x, point.x), std::min(corner.y, point.y)};
    for (Vec2& point : points) point = point - Vec2{*x, *y};
    object.points = std::move(points);
    object.position = Vec2{*x, *y} + entity.position - Vec2{std::round(corner.x), std::round(corner.y)};
    return object;
  }
  object.position = {exact_or(*x, entity.position.x), exact_or(*y, entity.position.y)};
  object.size = {exact_or(*w, entity.size.x, true), exact_or(*h, entity.size.y, true)};
  object.rotation = fields.number("rotation").value_or(0);
  object.tile = turned_tile(fields.number("tile").value_or(0), fields.number("turn").value_or(0));
  if (*form == MapObject::Form::tile) object.anchor = {0, 0};
  return object;
}

// offset: px, of the layer on the map. Nothing if a level cannot hold it.
std::optional<MapObject> object_of(const LdtkEntity& entity, Vec2 offset) {
  constexpr int kDeepest = 16;  // far below what a level may nest
  Json properties = entity.fields;
  auto object = exported_object(entity);
  if (object) {
    for (const char* const key : kExportedKeys) properties.erase(key);
  } else {
    object = {.name = entity.name, .type = entity.type, .size = entity.size};
    object->position = entity.position - Vec2{entity.pivot.x * entity.size.x, entity.pivot.y * entity.size.y};
    const auto name = properties.find("name");
    if (name != properties.end() && name->is_string()) properties.erase(name);
  }
  object->position = object->position + offset;
  if (!properties.empty() && depth_of(properties) <= kDeepest) object->properties = properties.dump();
  if (!json_of({ObjectLayer{.objects = {*object}}}, "", {})) return {};
  return object;
}

// Counts what a level may hold of objects.
class ObjectRoom {
 public:
  bool takes(const MapObject& object) {
    ++objects_;
    points_ += object.points.size();
    bytes_ += object.name.size() + object.type.size() + object.properties.size();
    return objects_ <= kMaxMapObjects && points_ <= kMaxObjectPoints && bytes_ <= kMaxObjectBytes;
  }

 private:
  std::size_t objects_ = 1, points_ = 0, bytes_ = 0;  // one object may be the picture behind the level
};

}  // namespace

std::vector<ObjectLayer> ldtk_object_layers(const LdtkProject& project, const LdtkLevel& level,
                                            const LdtkMapping& mapping, int ground, Vec2 origin,
                                            ImportDrops& drops) {
  std::vector<ObjectLayer> made;
  ObjectRoom room;
  int place = 0;
  for (std::size_t i = level.layers.size(); i-- > 0;) {
    const LdtkLayer& source = level.layers[i];
    if (is_taken(source, static_cast<int>(i) == ground)) ++place;
    ObjectLayer layer{.name = source.name, .visible = source.is_visible, .opacity = source.opacity};
    layer.place = place;
    if (source.def >= 0) {
      const Vec2 factors = project.layers[static_cast<std::size_t>(source.def)].parallax;
      layer.parallax = {1 - factors.x, 1 - factors.y};
    }
    const Vec2 offset = Vec2{1.0 * source.offset_x, 1.0 * source.offset_y} - origin;
    for (const LdtkEntity& entity : source.entities) {
      if (ldtk_meaning_of_entity(mapping, entity.type)) continue;
      auto object = object_of(entity, offset);
      if (object && made.size() + 1 < kMaxObjectLayers && room.takes(*object))
        layer.objects.push_back(*std::move(object));
      else
        drops.add("an entity " + quoted_name(entity.type));
    }
    if (!layer.objects.empty()) made.push_back(std::move(layer));
  }
  return made;
}

}  // namespace talus
