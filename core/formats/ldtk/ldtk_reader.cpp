// Goes over the JSON once, and keeps the first error. LDtk writes null for what there is not.
#include "ldtk_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "../import/hex_color.h"
#include "../import/json_node.h"

namespace talus {
namespace {

constexpr int kMaxUid = 1 << 30;
constexpr double kMaxLdtkParallax = kMaxParallax - 1;  // far more than LDtk has

class LdtkReader : private JsonNodeReader {
 public:
  LdtkProject project(const JsonNode& node);
  LdtkLevel level(const LdtkProject& project, const LdtkLevelHead& head, const JsonNode& node);

  using JsonNodeReader::result;

 private:
  static bool has(const JsonNode& node, const char* key) {
    const Json* value = node.find(key);
    return value != nullptr && !value->is_null();
  }
  // What there is, or else the fallback.
  std::string text_if(const JsonNode& node, const char* key) {
    return has(node, key) ? text(node, key) : std::string();
  }
  int whole_if(const JsonNode& node, const char* key, int min, int max, int fallback) {
    return has(node, key) ? whole(node, key, min, max, fallback) : fallback;
  }
  double share(const JsonNode& node, const char* key, double fallback) {
    return has(node, key) ? std::clamp(number(node, key), 0.0, 1.0) : fallback;
  }
  std::string name(const JsonNode& node, const char* key);
  Rgb color(const JsonNode& node, const char* key);
  std::pair<double, double> pair(const JsonNode& node, const char* key);
  Cell px(const JsonNode& node, const char* key);
  std::vector<int> tile_ids(const JsonNode& node, const char* key);

  void definitions(const JsonNode& node, LdtkProject& project);
  LdtkTileset tileset(const JsonNode& node);
  LdtkLayerDef layer_def(const JsonNode& node);
  void levels(const JsonNode& node, const std::string& world, LdtkProject& project);
  LdtkLayer layer(const LdtkProject& project, const JsonNode& node);
  void read_values(const JsonNode& node, LdtkLayer& layer);
  LdtkBackground background(const JsonNode& node);
  std::vector<double> list_of(const JsonNode& node, const char* key, std::size_t count);
  LdtkTile tile(const JsonNode& node);
  LdtkEntity entity(const JsonNode& node);
};

std::string too_many(std::string_view thing, std::size_t most) {
  return "is one " + std::string(thing) + " too many: a project may have at most " + std::to_string(most);
}

// The name of something that must have one.
std::string LdtkReader::name(const JsonNode& node, const char* key) {
  if (!has(node, key)) fail(node, key, std::string("must have a string as ") + key);
  return text_if(node, key);
}

Rgb LdtkReader::color(const JsonNode& node, const char* key) {
  return color_of_hex(text_if(node, key)).value_or(Rgb{});
}

std::pair<double, double> LdtkReader::pair(const JsonNode& node, const char* key) {
  const Json* list = node.find(key);
  const bool is_pair = list != nullptr && list->is_array() && list->size() == 2 && (*list)[0].is_number() &&
                       (*list)[1].is_number();
  if (is_pair) return {(*list)[0].get<double>(), (*list)[1].get<double>()};
  fail(node, key, std::string("must have a list of two numbers as ") + key);
  return {};
}

Cell LdtkReader::px(const JsonNode& node, const char* key) {
  const auto [x, y] = pair(node, key);
  const auto is_place = [](double at) { return at >= -kMaxLdtkPlace && at <= kMaxLdtkPlace; };
  if (is_place(x) && is_place(y)) return {static_cast<int>(x), static_cast<int>(y)};
  fail(node, key,
       std::string("must have two numbers of at most ") + std::to_string(kMaxLdtkPlace) + " px as " + key);
  return {};
}

std::vector<int> LdtkReader::tile_ids(const JsonNode& node, const char* key) {
  std::vector<int> ids;
  const Json* list = node.find(key);
  if (list == nullptr || !list->is_array()) {
    fail(node, key, std::string("must have a list as ") + key);
    return ids;
  }
  for (const Json& id : *list) {
    if (is_whole(id, 0, kMaxUid)) ids.push_back(id.get<int>());
  }
  std::sort(ids.begin(), ids.end());
  return ids;
}

LdtkProject LdtkReader::project(const JsonNode& node) {
  LdtkProject project;
  const Json* defs = node.json.is_object() ? node.find("defs") : nullptr;
  if (defs == nullptr || !defs->is_object() || !node.find("levels")) {
    const bool is_level = node.json.is_object() && node.find("layerInstances");
    fail(node, "",
         is_level ? "is a level of a project of LDtk: open the project, whose name ends in .ldtk"
                  : "is not a project of LDtk");
    return project;
  }
  project.iid = text_if(node, "iid");
  definitions({*defs, "defs"}, project);
  levels(node, "", project);
  for_each(node, "worlds",
           [&](const JsonNode& world) { levels(world, text_if(world, "identifier"), project); });
  if (project.levels.empty()) fail(node, "levels", "has no level");
  return project;
}

void LdtkReader::definitions(const JsonNode& node, LdtkProject& project) {
  for_each(node, "tilesets", [&](const JsonNode& entry) {
    if (project.tilesets.size() == kMaxLdtkTilesets)
      return fail(entry, "", too_many("tileset", kMaxLdtkTilesets));
    project.tilesets.push_back(tileset(entry));
  });
  for_each(node, "layers", [&](const JsonNode& entry) {
    if (project.layers.size() == kMaxLdtkLayers) return fail(entry, "", too_many("layer", kMaxLdtkLayers));
    project.layers.push_back(layer_def(entry));
  });
  for_each(node, "entities", [&](const JsonNode& entry) {
    if (project.entities.size() == kMaxLdtkEntities)
      return fail(entry, "", too_many("type of entities", kMaxLdtkEntities));
    project.entities.push_back({text_if(entry, "identifier"), color(entry, "color")});
  });
}

LdtkTileset LdtkReader::tileset(const JsonNode& node) {
  LdtkTileset tileset;
  tileset.uid = whole(node, "uid", -kMaxUid, kMaxUid, 0);
  tileset.name = name(node, "identifier");
  tileset.path = text_if(node, "relPath");
  tileset.side = whole_if(node, "tileGridSize", 1, kMaxLdtkTileSide, 1);
  for_each(node, "enumTags", [&](const JsonNode& entry) {
    tileset.tags.push_back({name(entry, "enumValueId"), tile_ids(entry, "tileIds")});
  });
  for_each(node, "customData", [&](const JsonNode& entry) {
    tileset.data[whole(entry, "tileId", 0, kMaxUid, 0)] = text_if(entry, "data");
  });
  return tileset;
}

LdtkLayerDef LdtkReader::layer_def(const JsonNode& node) {
  LdtkLayerDef def;
  def.uid = whole(node, "uid", -kMaxUid, kMaxUid, 0);
  def.name = text_if(node, "identifier");
  def.pivot = {share(node, "tilePivotX", 0), share(node, "tilePivotY", 0)};
  const auto factor = [&](const char* key) {
    return has(node, key) ? std::clamp(number(node, key), -kMaxLdtkParallax, kMaxLdtkParallax) : 0;
  };
  def.parallax = {factor("parallaxFactorX"), factor("parallaxFactorY")};
  def.scales_by_parallax = !has(node, "parallaxScaling") || truth(node, "parallaxScaling");
  for_each(node, "intGridValues", [&](const JsonNode& entry) {
    def.values.push_back(
        {whole(entry, "value", 0, kMaxUid, 0), text_if(entry, "identifier"), color(entry, "color")});
  });
  return def;
}

void LdtkReader::levels(const JsonNode& node, const std::string& world, LdtkProject& project) {
  for_each(node, "levels", [&](const JsonNode& entry) {
    if (project.levels.size() == kMaxLdtkLevels) return fail(entry, "", too_many("level", kMaxLdtkLevels));
    LdtkLevelHead head;
    head.iid = text_if(entry, "iid");
    head.name = name(entry, "identifier");
    head.world = world;
    head.x = whole_if(entry, "worldX", -kMaxLdtkPlace, kMaxLdtkPlace, 0);
    head.y = whole_if(entry, "worldY", -kMaxLdtkPlace, kMaxLdtkPlace, 0);
    head.depth = whole_if(entry, "worldDepth", -kMaxLdtkPlace, kMaxLdtkPlace, 0);
    head.width = whole(entry, "pxWid", 1, kMaxLdtkPlace, 1);
    head.height = whole(entry, "pxHei", 1, kMaxLdtkPlace, 1);
    head.color = color(entry, "__bgColor");
    head.file = has(entry, "layerInstances") ? "" : text_if(entry, "externalRelPath");
    head.path = entry.path;
    head.json = &entry.json;
    project.levels.push_back(std::move(head));
  });
}

LdtkBackground LdtkReader::background(const JsonNode& node) {
  LdtkBackground made;
  made.path = text_if(node, "bgRelPath");
  made.repeats = text_if(node, "bgPos") == "Repeat";
  const Json* const place = node.find("__bgPos");
  if (place == nullptr || !place->is_object()) return made;
  const JsonNode its{*place, node.path_of("__bgPos")};
  const auto numbers = [&](const char* key, std::size_t count) { return list_of(its, key, count); };
  const std::vector<double> corner = numbers("topLeftPx", 2), scale = numbers("scale", 2),
                            part = numbers("cropRect", 4);
  if (!corner.empty()) made.corner = {corner[0], corner[1]};
  if (!scale.empty()) made.scale = {scale[0], scale[1]};
  if (!part.empty()) made.part = Rect{part[0], part[1], part[2], part[3]};
  if (!(made.scale.x > 0 && made.scale.y > 0)) fail(its, "scale", "must have two numbers above 0 as scale");
  return made;
}

// Empty after an error.
std::vector<double> LdtkReader::list_of(const JsonNode& node, const char* key, std::size_t count) {
  const Json* const list = node.find(key);
  std::vector<double> numbers;
  const bool is_list = list != nullptr && list->is_array() && list->size() == count;
  for (std::size_t i = 0; is_list && i < count; ++i) {
    const bool is_near = (*list)[i].is_number() && std::abs((*list)[i].get<double>()) <= kMaxLdtkPlace;
    if (is_near) numbers.push_back((*list)[i].get<double>());
  }
  if (numbers.size() == count) return numbers;
  fail(node, key,
       "must have a list of " + std::to_string(count) + " numbers of at most " +
           std::to_string(kMaxLdtkPlace) + " as " + key);
  return {};
}

LdtkLevel LdtkReader::level(const LdtkProject& project, const LdtkLevelHead& head, const JsonNode& node) {
  LdtkLevel level;
  level.head = head;
  if (!node.json.is_object() || !has(node, "layerInstances")) {
    fail(node, "layerInstances", "must have a list as layerInstances");
    return level;
  }
  if (!text_if(node, "bgRelPath").empty()) level.background = background(node);
  for_each(node, "layerInstances", [&](const JsonNode& entry) {
    if (level.layers.size() == kMaxLdtkLayers) return fail(entry, "", too_many("layer", kMaxLdtkLayers));
    level.layers.push_back(layer(project, entry));
  });
  return level;
}

template <class Definition>
int index_of(const std::vector<Definition>& definitions, int uid) {
  const auto found = std::find_if(definitions.begin(), definitions.end(),
                                  [&](const Definition& definition) { return definition.uid == uid; });
  return found == definitions.end() ? -1 : static_cast<int>(found - definitions.begin());
}

LdtkLayer LdtkReader::layer(const LdtkProject& project, const JsonNode& node) {
  LdtkLayer layer;
  const std::string type = text_if(node, "__type");
  if (type == "IntGrid")
    layer.type = LdtkLayer::Type::int_grid;
  else if (type == "Entities")
    layer.type = LdtkLayer::Type::entities;
  else if (type != "Tiles" && type != "AutoLayer")
    fail(node, "__type", "must be IntGrid, Entities, Tiles or AutoLayer");
  layer.iid = text_if(node, "iid");
  layer.name = name(node, "__identifier");
  layer.columns = whole(node, "__cWid", 0, kMaxTerrainSide, 0);
  layer.rows = whole(node, "__cHei", 0, kMaxTerrainSide, 0);
  layer.side = whole(node, "__gridSize", 1, kMaxLdtkTileSide, 1);
  layer.offset_x = whole_if(node, "__pxTotalOffsetX", -kMaxLdtkPlace, kMaxLdtkPlace, 0);
  layer.offset_y = whole_if(node, "__pxTotalOffsetY", -kMaxLdtkPlace, kMaxLdtkPlace, 0);
  layer.opacity = share(node, "__opacity", 1);
  layer.is_visible = !has(node, "visible") || truth(node, "visible");
  layer.def = index_of(project.layers, whole_if(node, "layerDefUid", -kMaxUid, kMaxUid, -kMaxUid));
  layer.tileset = has(node, "__tilesetDefUid")
                      ? index_of(project.tilesets, whole(node, "__tilesetDefUid", -kMaxUid, kMaxUid, 0))
                      : -1;
  if (layer.type == LdtkLayer::Type::int_grid) read_values(node, layer);
  for (const char* const key : {"autoLayerTiles", "gridTiles"})
    for_each(node, key, [&](const JsonNode& entry) { layer.tiles.push_back(tile(entry)); });
  for_each(node, "entityInstances", [&](const JsonNode& entry) { layer.entities.push_back(entity(entry)); });
  return layer;
}

void LdtkReader::read_values(const JsonNode& node, LdtkLayer& layer) {
  const Json* list = node.find("intGridCsv");
  const auto count = static_cast<std::size_t>(layer.columns) * static_cast<std::size_t>(layer.rows);
  if (list == nullptr || !list->is_array() || list->size() != count) {
    const std::size_t size = list != nullptr && list->is_array() ? list->size() : 0;
    return fail(
        node, "intGridCsv",
        "has " + std::to_string(size) + " values, but its layer has " + std::to_string(count) + " cells");
  }
  layer.values.reserve(count);
  for (const Json& value : *list) {
    if (!is_whole(value, 0, kMaxUid)) {
      return fail(node, "intGridCsv",
                  "must have a whole number as value " + std::to_string(layer.values.size() + 1));
    }
    layer.values.push_back(value.get<int>());
  }
}

LdtkTile LdtkReader::tile(const JsonNode& node) {
  LdtkTile tile;
  const Cell place = px(node, "px"), source = px(node, "src");
  tile.x = place.x;
  tile.y = place.y;
  tile.source_x = source.x;
  tile.source_y = source.y;
  tile.id = whole_if(node, "t", 0, kMaxUid, 0);
  const int flips = whole_if(node, "f", 0, 3, 0);
  tile.flip_x = (flips & 1) != 0;
  tile.flip_y = (flips & 2) != 0;
  tile.opacity = share(node, "a", 1);
  return tile;
}

LdtkEntity LdtkReader::entity(const JsonNode& node) {
  LdtkEntity entity;
  entity.type = name(node, "__identifier");
  const Cell place = px(node, "px");
  entity.position = {1.0 * place.x, 1.0 * place.y};
  entity.size = {1.0 * whole_if(node, "width", 0, kMaxLdtkPlace, 0),
                 1.0 * whole_if(node, "height", 0, kMaxLdtkPlace, 0)};
  if (has(node, "__pivot")) {
    const auto [x, y] = pair(node, "__pivot");
    entity.pivot = {std::clamp(x, 0.0, 1.0), std::clamp(y, 0.0, 1.0)};
  }
  for_each(node, "fieldInstances", [&](const JsonNode& field) {
    const std::string key = text_if(field, "__identifier");
    const Json* value = field.find("__value");
    if (value == nullptr || value->is_null()) return;
    entity.fields[key] = *value;
    if (key == "name" && value->is_string()) entity.name = value->get<std::string>();
    if (key == "vx" && value->is_number()) entity.velocity.x = value->get<double>();
    if (key == "vy" && value->is_number()) entity.velocity.y = value->get<double>();
  });
  return entity;
}

}  // namespace

FormatResult<LdtkProject> read_ldtk_project(const Json& json) {
  LdtkReader reader;
  return reader.result(reader.project({json, ""}));
}

FormatResult<LdtkLevel> read_ldtk_level(const LdtkProject& project, const LdtkLevelHead& head,
                                        const Json& json, const std::string& path) {
  LdtkReader reader;
  return reader.result(reader.level(project, head, {json, path}));
}

}  // namespace talus
