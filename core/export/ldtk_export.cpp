// A project of LDtk with one level, and the sheet of its tiles beside it.
//
// Layers, from the top: "Bodies" has an entity for each body at its start, also for ball tiles of the map,
// with its exact numbers as fields. "Collision" is an IntGrid: 0 is empty, 1 a full tile, 2 a full one-way
// tile. Each other shape has a value of its own for each cell that it is in, with an identifier that
// describes it (ldtk_shapes.h). "Tiles" has the tiles. LDtk cannot draw shapes, so the tileset's custom data
// has one JSON object as text for each tile with flags or a shape: flags, ball, and the shape as in
// docs/export-data.md. Curves are dropped. Layers of objects have their places among these (ldtk_objects.h).
//
// All keys that LDtk's schema requires are in assets/templates/ldtk.json. LDtk's own loader does without many
// of them, other programs do not.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <talus/level/ground.h>
#include <talus/level/placed_picture.h>
#include "../formats/import/import_drops.h"
#include "../formats/pictures/png_sheet.h"
#include "../formats/text/append_number.h"
#include "../formats/text/json_text.h"
#include "../level/tile_color.h"
#include "export_targets.h"
#include "ldtk_objects.h"
#include "ldtk_shapes.h"
#include "ldtk_skeleton.h"
#include "plain_data.h"
#include "plain_text.h"

namespace talus {
namespace {

// Numbers of definitions, unique in the project.
enum LdtkUid : int {
  kTilesetUid = 1,
  kBodiesUid,
  kCollisionUid,
  kTilesUid,
  kLevelUid,
  kFirstBodyUid = 10  // of the first kind; the fields of an entity have the numbers after its own
};

std::string color_text(Rgb color) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string text = "#";
  for (const std::uint8_t part : {color.r, color.g, color.b})
    (text += kDigits[part / 16]) += kDigits[part % 16];
  return text;
}

// One text for each tile with flags or a shape. The ground may have more tiles, which are turned ones.
OrderedJson custom_data(const Level& level, const TerrainSource& ground) {
  std::vector<OrderedJson> tiles(static_cast<std::size_t>(level.tile_count()));
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    const auto number = static_cast<TileNumber>(tile);
    const FlagSet flags = level.tile_flags(number);
    if (flags != 0) tiles[tile]["flags"] = flags;
    if (is_ball_tile(level, number)) tiles[tile]["ball"] = true;
  }
  for (const PlainShape& shape : plain_shapes(ground)) {
    const auto tile = static_cast<std::size_t>(shape.tile);
    if (tile < tiles.size()) tiles[tile].update(plain_shape_json(shape));
  }
  OrderedJson all = OrderedJson::array();
  for (std::size_t tile = 0; tile < tiles.size(); ++tile) {
    if (!tiles[tile].is_null()) all.push_back({{"tileId", tile}, {"data", tiles[tile].dump()}});
  }
  return all;
}

// Whole pixels, as LDtk needs them.
// place: on the sheet. side: px, of a tile.
OrderedJson tile_rect(Cell place, int side) {
  return {{"tilesetUid", int{kTilesetUid}},
          {"x", place.x * side},
          {"y", place.y * side},
          {"w", side},
          {"h", side}};
}

// First the names, texts and numbers, then the tile of the map that the body is, or null.
OrderedJson body_fields(const PlainBody& body, const SheetLayout& sheet, int tile_side) {
  OrderedJson fields = plain_body_json(body);
  fields.erase("id");
  fields.erase("kind");  // the entity says which kind it is
  fields.erase("tile");
  fields.erase("picture");
  fields["tile"] = body.tile < 0 ? OrderedJson() : tile_rect(sheet.place_of(body.tile), tile_side);
  return fields;
}

// The name that LDtk has for a type of field.
const char* field_type(const std::string& name, const OrderedJson& value) {
  if (name == "tile") return "Tile";
  return value.is_string() ? "String" : "Float";
}

// Of the entity of a kind.
int uid_of(BodyKind kind) {
  constexpr int kMaxFields = 19;
  return kFirstBodyUid + static_cast<int>(kind) * (kMaxFields + 1);
}

OrderedJson entity_def(const LdtkSkeleton& skeleton, BodyKind kind, int tile_side) {
  int uid = uid_of(kind);
  const std::string identifier(traits_of(kind).ldtk_identifier), color(traits_of(kind).ldtk_color);
  OrderedJson entity = skeleton.filled("entity_definition", {{"identifier", identifier},
                                                             {"uid", uid},
                                                             {"width", tile_side},
                                                             {"height", tile_side},
                                                             {"color", color}});
  const OrderedJson fields = body_fields({}, {}, tile_side);
  for (const auto& [name, value] : fields.items()) {
    const std::string type = field_type(name, value);
    OrderedJson& field = entity["fieldDefs"].emplace_back(skeleton.field_definition(name, type, ++uid));
    if (type == "Tile")
      field.update(
          {{"canBeNull", true}, {"tilesetUid", int{kTilesetUid}}, {"editorDisplayMode", "EntityTile"}});
  }
  return entity;
}

OrderedJson entity(const PlainBody& body, const SheetLayout& sheet, int tile_side) {
  const Spawn& start = body.start;
  const BodyTraits& traits = traits_of(start.kind);
  int uid = uid_of(start.kind);
  const OrderedJson fields = body_fields(body, sheet, tile_side);
  OrderedJson instance = ldtk_entity({std::string(traits.ldtk_identifier),
                                      std::string(traits.ldtk_color),
                                      uid,
                                      99 + body.id,
                                      {start.position.x, start.position.y, start.size.x, start.size.y}},
                                     tile_side);
  instance["__tile"] = fields["tile"];
  for (const auto& [name, value] : fields.items())
    instance["fieldInstances"].push_back(ldtk_field(name, field_type(name, value), value, ++uid));
  return instance;
}

// Names may hold bytes that are not UTF-8, which are replaced.
std::string dumped(const OrderedJson& json) {
  return json.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

// An object that is not closed yet. Large parts follow as text: the cells of a large map would take a
// kilobyte each as JSON values.
std::string opened(const OrderedJson& object) {
  std::string text = dumped(object);
  text.pop_back();
  return text;
}
std::string& begin_member(std::string& object, const char* key) {
  return object.append(",\n\"").append(key).append("\":");
}

void put_int_grid(const Level& level, const LdtkShapes::Grid& grid, std::string& text) {
  text += '[';
  const auto width = static_cast<std::size_t>(level.map.width());
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (i > 0) text += ',';
    if (i % width == 0) text += '\n';
    append_number(text, grid.cells[i]);
  }
  text += ']';
}

constexpr std::size_t kMaxOfTile = 96;  // bytes of a tile's object

// LDtk's number of flip bits: 1 mirrors left and right, 2 up and down.
int flip_bits(TileTurn turn) {
  return (has_flip(turn, TileTurn::left_right) ? 1 : 0) + (has_flip(turn, TileTurn::up_down) ? 2 : 0);
}

void put_grid_tiles(const Level& level, const Progress& progress, std::string& text) {
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  std::vector<bool> blank(static_cast<std::size_t>(sheet.count));
  for (int i = 0; i < sheet.count; ++i) {  // an empty tile without flags, such as tile 0, is invisible
    const auto tile = static_cast<TileNumber>(i);
    blank[tile] = (level.tile_flags(tile) == 0 && is_blank(level, tile)) || is_ball_tile(level, tile);
  }
  const int side = level.map.tile_size().width;
  const auto put_place = [&text, side](Cell place) {
    append_number(text += '[', place.x * side);
    append_number(text += ',', place.y * side);
    text += ']';
  };
  const std::span<const TileNumber> cells = level.map.cells().tiles();
  const auto shown = std::count_if(cells.begin(), cells.end(), [&](TileNumber tile) { return !blank[tile]; });
  // Growing by doubling would take three times the memory of a text that can be a GB.
  text.reserve(text.size() + static_cast<std::size_t>(shown) * kMaxOfTile);
  text += '[';
  bool first = true;
  for (Cell c; c.y < level.map.height() && progress.at(c.y, level.map.height()); ++c.y) {
    for (c.x = 0; c.x < level.map.width(); ++c.x) {
      const auto place = static_cast<std::size_t>(c.y * level.map.width() + c.x);
      const auto [tile, turn] = level.map.cells()[place];
      if (blank[tile]) continue;
      text += first ? "\n" : ",\n";
      first = false;
      text += R"({"px":)";
      put_place(c);
      text += R"(,"src":)";
      put_place(sheet.place_of(tile));
      append_number(text += R"(,"f":)", flip_bits(turn));
      append_number(text += R"(,"t":)", tile);
      append_number(text += R"(,"d":[)", place);
      text += R"(],"a":1})";
    }
  }
  text += ']';
}

class LdtkProject {
 public:
  // level: that is drawn. whole: that has its objects. ground: of the level that has its ground.
  LdtkProject(const LdtkSkeleton& skeleton, const Level& level, const Level& whole, TerrainSource ground,
              std::string stem, std::string sheet, Progress progress)
      : skeleton_(skeleton),
        level_(level),
        ground_(std::move(ground)),
        progress_(std::move(progress)),
        stem_(std::move(stem)),
        sheet_(std::move(sheet)),
        shapes_(ground_),
        grid_(shapes_.grid_of(ground_, progress_.part(0, 0.1))),
        whole_(whole),
        objects_(whole, uid_of(static_cast<BodyKind>(body_kinds().size()))) {}

  std::size_t overlaps() const { return grid_.overlaps; }

  std::string text() const {
    const std::string background = background_text();
    OrderedJson project = skeleton_.filled("project", {{"iid", ldtk_iid(1)},
                                                       {"nextUid", objects_.next_uid()},
                                                       {"defaultGridSize", side_},
                                                       {"defaultLevelBgColor", background},
                                                       {"dummyWorldIid", ldtk_iid(2)}});
    OrderedJson& defs = project["defs"];
    defs["layers"] = layer_definitions();
    for (std::size_t kind = 0; kind < body_kinds().size(); ++kind)
      defs["entities"].push_back(entity_def(skeleton_, static_cast<BodyKind>(kind), side_));
    for (OrderedJson& definition : objects_.definitions(skeleton_, side_))
      defs["entities"].push_back(std::move(definition));
    const SheetLayout sheet = level_.sheet(SheetId::tiles).layout();
    defs["tilesets"] = OrderedJson::array(
        {skeleton_.filled("tileset_definition", {{"uid", kTilesetUid},
                                                 {"relPath", sheet_},
                                                 {"pxWid", sheet.columns * side_},
                                                 {"pxHei", sheet.rows() * side_},
                                                 {"tileGridSize", side_},
                                                 {"customData", custom_data(level_, ground_)}})});
    OrderedJson level = skeleton_.filled("level", {{"identifier", ldtk_identifier(stem_)},
                                                   {"iid", ldtk_iid(3)},
                                                   {"uid", kLevelUid},
                                                   {"pxWid", level_.map.width() * side_},
                                                   {"pxHei", level_.map.height() * side_},
                                                   {"__bgColor", background},
                                                   {"__smartColor", background}});
    std::string text = opened(project);
    begin_member(text, "levels").append("[\n").append(opened(level));
    begin_member(text, "layerInstances") += "[\n";
    put_bodies(text);
    put_objects(false, text);
    text += ",\n";
    put_tiles(text);
    text += ",\n";
    put_collision(text);
    put_objects(true, text);
    text += "]}]}\n";
    return text;
  }

 private:
  // LDtk has opaque backgrounds alone: what is not lies over that of a new project.
  std::string background_text() const {
    std::array<std::uint8_t, 4> pixel = {0x40, 0x46, 0x5b, 255};
    lay_over(pixel.data(), background_of(level_));
    return color_text({pixel[0], pixel[1], pixel[2]});
  }
  OrderedJson layer_def(const std::string& name, const char* type, int uid) const {
    return skeleton_.filled(
        "layer_definition",
        {{"__type", type}, {"identifier", name}, {"type", type}, {"uid", uid}, {"gridSize", side_}});
  }

  // Those in front of the tiles, or behind all.
  void add_object_layers(bool are_behind, OrderedJson& list) const {
    for (const LdtkObjects::Layer& layer : objects_.layers()) {
      if (layer.is_behind != are_behind) continue;
      const LayerLooks looks = looks_of(layer);
      OrderedJson& made = list.emplace_back(layer_def(layer.identifier, "Entities", layer.uid));
      made["displayOpacity"] = looks.opacity;
      if (layer.identifier != layer.source->name) made["doc"] = layer.source->name;
    }
  }
  // From the top: the colours of the ground lie below the tiles.
  OrderedJson layer_definitions() const {
    OrderedJson list = OrderedJson::array({layer_def("Bodies", "Entities", kBodiesUid)});
    add_object_layers(false, list);
    list.push_back(layer_def("Tiles", "Tiles", kTilesUid));
    list.back()["tilesetDefUid"] = int{kTilesetUid};
    OrderedJson& values =
        list.emplace_back(layer_def("Collision", "IntGrid", kCollisionUid))["intGridValues"];
    for (const LdtkShapes::Value& value : shapes_.values()) {
      values.push_back({{"value", values.size() + 1},
                        {"identifier", value.name},
                        {"color", value.color},
                        {"tile", nullptr},
                        {"groupUid", 0}});
    }
    add_object_layers(true, list);
    return list;
  }

  LayerLooks looks_of(const LdtkObjects::Layer& layer) const {
    return shown_looks(whole_.layers.groups, *layer.source);
  }

  struct Head {
    std::string name;
    const char* type;
    int uid, iid;
    double opacity = 1;
    bool visible = true;
  };
  static Head head_of(const char* name, const char* type, int uid) { return {name, type, uid, 3 + uid}; }

  // An open object, without the members that differ between types of layers.
  std::string layer(const Head& head) const {
    const bool has_tileset = head.uid == kTilesUid;
    return opened({{"__identifier", head.name},
                   {"__type", head.type},
                   {"__cWid", level_.map.width()},
                   {"__cHei", level_.map.height()},
                   {"__gridSize", side_},
                   {"__opacity", head.opacity},
                   {"__pxTotalOffsetX", 0},
                   {"__pxTotalOffsetY", 0},
                   {"__tilesetDefUid", has_tileset ? OrderedJson(int{kTilesetUid}) : OrderedJson()},
                   {"__tilesetRelPath", has_tileset ? OrderedJson(sheet_) : OrderedJson()},
                   {"iid", ldtk_iid(head.iid)},
                   {"levelId", kLevelUid},
                   {"layerDefUid", head.uid},
                   {"pxOffsetX", 0},
                   {"pxOffsetY", 0},
                   {"visible", head.visible},
                   {"optionalRules", OrderedJson::array()},
                   {"autoLayerTiles", OrderedJson::array()},
                   {"seed", 1},
                   {"overrideTilesetUid", nullptr}});
  }

  // entity_at: by index.
  template <class EntityAt>
  void put_entities(const Head& head, std::size_t count, const EntityAt& entity_at, std::string& text) const {
    text += layer(head);
    begin_member(text, "intGridCsv") += "[]";
    begin_member(text, "gridTiles") += "[]";
    begin_member(text, "entityInstances") += '[';
    for (std::size_t i = 0; i < count; ++i) text.append(i == 0 ? "\n" : ",\n").append(dumped(entity_at(i)));
    text += "]}";
  }
  void put_bodies(std::string& text) const {
    const PlainBodies bodies(level_);
    const SheetLayout sheet = level_.sheet(SheetId::tiles).layout();
    put_entities(
        head_of("Bodies", "Entities", kBodiesUid), bodies.size(),
        [&](std::size_t i) { return entity(bodies.at(i), sheet, side_); }, text);
  }
  // Those in front of the tiles, or behind all, each with a comma before it.
  void put_objects(bool are_behind, std::string& text) const {
    for (const LdtkObjects::Layer& layer : objects_.layers()) {
      if (layer.is_behind != are_behind) continue;
      const LayerLooks looks = looks_of(layer);
      text += ",\n";
      put_entities(
          {layer.identifier, "Entities", layer.uid, layer.iid, looks.opacity, looks.visible},
          layer.source->objects.size(), [&](std::size_t i) { return objects_.entity(layer, i, side_); },
          text);
    }
  }
  void put_collision(std::string& text) const {
    text += layer(head_of("Collision", "IntGrid", kCollisionUid));
    put_int_grid(level_, grid_, begin_member(text, "intGridCsv"));
    begin_member(text, "gridTiles") += "[]";
    begin_member(text, "entityInstances") += "[]}";
  }
  void put_tiles(std::string& text) const {
    text += layer(head_of("Tiles", "Tiles", kTilesUid));
    begin_member(text, "intGridCsv") += "[]";
    put_grid_tiles(level_, progress_.part(0.1, 1), begin_member(text, "gridTiles"));
    begin_member(text, "entityInstances") += "[]}";
  }

  const LdtkSkeleton& skeleton_;
  const Level& level_;
  TerrainSource ground_;
  int side_ = level_.map.tile_size().width;  // px, of a cell
  Progress progress_;
  std::string stem_, sheet_;
  LdtkShapes shapes_;
  LdtkShapes::Grid grid_;
  const Level& whole_;
  LdtkObjects objects_;
};

// What layers of entities do not have.
void tell_object_looks(const Level& level, std::vector<std::string>& dropped) {
  std::size_t pictures = 0;
  for (const ObjectLayer& layer : level.objects) {
    if (layer.image) continue;
    pictures += drawn_pictures(layer).size();
    const LayerLooks looks = shown_looks(level.layers.groups, layer);
    if (looks.parallax != Vec2{1, 1})
      dropped.push_back("the parallax of the layer " + quoted_name(layer.name));
  }
  if (pictures > 0)
    dropped.push_back("the pictures of " + std::to_string(pictures) +
                      (pictures == 1 ? " object" : " objects"));
}

}  // namespace

FormatResult<Exported> export_ldtk(const ExportRequest& request) {
  const TileSize tile = request.level.map.tile_size();
  if (tile.width != tile.height) {
    return tl::unexpected(FormatError{"", "the level's tiles have " + std::to_string(tile.width) + "x" +
                                              std::to_string(tile.height) +
                                              " px, but those of LDtk must be square"});
  }
  const FormatResult<LdtkSkeleton> skeleton = read_ldtk_skeleton(request.read_asset);
  if (!skeleton) return tl::unexpected(skeleton.error());
  const Level& drawn = request.drawn();
  const LdtkProject project(*skeleton, drawn, request.whole(), ground_of(request.level), request.stem(),
                            request.sheet_name(), request.progress);
  std::vector<std::string> dropped = dropped_curves(request.level);
  tell_body_pictures(request.level, dropped);
  tell_conveyors(request.level, false, dropped);
  tell_object_looks(request.whole(), dropped);
  if (const std::size_t cells = project.overlaps(); cells > 0)
    dropped.push_back("a second shape in " + std::to_string(cells) + (cells == 1 ? " cell" : " cells") +
                      " that two shapes reach into");
  std::string text = project.text();
  if (const auto problem = problem_of_size(text))
    return tl::unexpected(FormatError{"", "the project of LDtk " + *problem + ": tmx holds larger maps"});
  Exported exported = exported_file(std::move(text), std::move(dropped));
  exported.files.push_back({request.sheet_name(), write_map_tiles(drawn)});
  return exported;
}

}  // namespace talus
