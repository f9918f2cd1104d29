// Makes the level, starting from Talus's own text in the map if there is one.
#include "tiled_level.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <utility>

#include <talus/level/limits.h>
#include <talus/level/tile_turns.h>
#include "../import/hex_color.h"
#include "../import/sheet_images.h"
#include "../native/native.h"
#include "../native/native_objects.h"
#include "tiled_base_objects.h"
#include "tiled_flags.h"
#include "tiled_near.h"
#include "tiled_object_layers.h"
#include "tiled_objects.h"
#include "tiled_parts.h"
#include "tiled_picture_tiles.h"
#include "tiled_properties.h"
#include "tiled_shapes.h"

namespace talus {
namespace {

const auto kXOfSpawn = [](const Spawn* base) { return base->position.x; };
const auto kXOfCurve = [](const std::pair<const LevelCurve*, TiledObject>& base) {
  return base.second.position.x;
};

class TiledLevelMaker {
 public:
  TiledLevelMaker(const TiledMap& map, const TiledPictures& pictures, ImportDrops& drops,
                  const Progress& progress)
      : map_(map), pictures_(pictures), drops_(drops), progress_(progress), parts_(map, pictures, drops) {}

  FormatResult<Level> make(const ImportChoices& choices);
  TiledSources take_sources() { return std::move(sources_); }

 private:
  FormatResult<std::vector<const TiledLayer*>> layers_of(const ImportChoices& choices) const;
  std::vector<int> numbers_of(const std::vector<const TiledLayer*>& layers) const;
  void take_layers(const std::vector<const TiledLayer*>& layers);
  bool has_other_tile_layers(const TiledLayer& layer) const {
    return std::any_of(map_.layers.begin(), map_.layers.end(),
                       [&](const TiledLayer& other) { return other.has_tiles && &other != &layer; });
  }
  TileLayer& layer_to_choose(std::vector<TileLayer>& list) const;
  FormatResult<void> read_base();
  void forget_numbers();
  void take_pixels();
  void take_background();
  void name_flags();
  void take_tile(TileNumber number);
  void take_note(TileNumber number, const TiledTile& tile);
  void take_animations();
  void fill_named_ground(const std::vector<const TiledLayer*>& layers);
  TiledObject in_cell(const TiledObject& object, const TiledSource& source) const;
  TileShape own_shape_of(TileNumber number, const TiledSource& source, const TiledTile& tile,
                         const TileShape& before);
  TileShape shape_of_objects(const std::string& tile, const std::vector<TiledObject>& objects,
                             std::optional<bool> one_way, bool is_ceiling);
  std::optional<TileShape> nearest_shape_of(const std::string& tile, const std::vector<Vec2>& outline,
                                            bool one_way);
  void tell_wrong_conveyor(const TiledProperties& properties, std::string_view name);
  std::optional<double> conveyor_of_tile(TileNumber number) const;
  void take_conveyor(TileNumber number, const TiledTile& tile, const TileShape& of_flags, TileShape& own);
  void tell_bare_conveyors();
  void tell_stale_words(const TiledTile& tile, const TileShape& shape);
  // number: of the layer among those that are not of tiles.
  void take_objects(const TiledLayer& layer, int place, int number);
  void take_other_layers(const std::vector<const TiledLayer*>& tile_layers);
  bool has_room_for(const MapObject& object);
  const std::string& type_of(const TiledObject& object) const;
  std::optional<Spawn> body_of(TiledObject object) const;
  void take_picture(const TiledObject& object, Spawn& spawn);
  void take_spawn(const TiledObject& object, Spawn spawn);
  const Spawn* base_spawn_like(const Spawn& spawn, const TiledObject& object) const;
  void take_curve(const TiledObject& object);
  bool takes(const Curve& curve, const std::string& name);

  const TiledTile* tile_of(const TiledSource& source) const {
    return source.tileset < 0 ? nullptr
                              : find_tile(map_.tilesets[static_cast<std::size_t>(source.tileset)], source.id);
  }

  const TiledMap& map_;
  const TiledPictures& pictures_;
  ImportDrops& drops_;
  const Progress& progress_;
  bool is_own_ = false;                    // whether Talus wrote the map
  Level base_;                             // the level when it was written
  std::vector<const Spawn*> spawns_by_x_;  // of base_
  Level level_;
  TiledTiles tiles_;
  std::map<TiledSource, TileNumber> numbers_;                           // of tiles_.sources
  std::optional<TiledFlagReader> flags_;                                // there once tiles are numbered
  std::vector<std::pair<const LevelCurve*, TiledObject>> curves_by_x_;  // of base_
  TiledBaseObjects base_objects_;
  TiledParts parts_;
  std::size_t object_bytes_ = 0;      // of the level's objects
  std::size_t note_bytes_ = 0;        // of the notes of its tiles
  std::size_t curve_name_bytes_ = 0;  // of curves that are no base_'s
  TiledSources sources_;
};

std::string named(std::string_view what, const std::string& name) {
  return std::string(what) + (name.empty() ? "" : " " + quoted_name(name));
}

// The tile's number in the level and, if that differs, its number in the tileset.
std::string name_of_tile(int number, const TiledSource& source) {
  const std::string name = "tile " + std::to_string(number);
  return source.id == number ? name : name + " (" + std::to_string(source.id) + " in Tiled)";
}

bool is_one_way(const TiledObject& object) {
  const bool* const word = find_property<bool>(object.properties, "one_way");
  return word != nullptr && *word;
}

// The number in the text, from 1; else 0.
int number_in(const std::string& text) {
  int number = 0;
  const char* const end = text.data() + text.size();
  const auto [stopped, problem] = std::from_chars(text.data(), end, number);
  return problem == std::errc() && stopped == end && number > 0 ? number : 0;
}

// All tile layers, or the one that is chosen.
FormatResult<std::vector<const TiledLayer*>> TiledLevelMaker::layers_of(const ImportChoices& choices) const {
  std::vector<const TiledLayer*> layers;
  std::string names;
  for (const TiledLayer& layer : map_.layers) {
    if (!layer.has_tiles) continue;
    layers.push_back(&layer);
    names += (names.empty() ? "" : ", ") + quoted_name(layer.name);
  }
  if (choices.layer.empty() && choices.layer_number <= 0) {
    if (layers.size() <= kMaxLayers) return layers;
    return tl::unexpected(FormatError{"",
                                      "has " + std::to_string(layers.size()) +
                                          " tile layers, but a level holds at most " +
                                          std::to_string(kMaxLayers),
                                      "choose one by `--layer NAME`"});
  }
  auto chosen = layers.end();
  const int number = choices.layer_number > 0 ? choices.layer_number : number_in(choices.layer);
  if (choices.layer_number <= 0)
    chosen = std::find_if(layers.begin(), layers.end(),
                          [&](const TiledLayer* layer) { return layer->name == choices.layer; });
  if (chosen == layers.end() && number > 0 && number <= static_cast<int>(layers.size()))
    chosen = layers.begin() + (number - 1);
  if (chosen == layers.end())
    return tl::unexpected(
        FormatError{"", "has no tile layer with the name \"" + choices.layer + "\", but " + names});
  for (const TiledLayer* layer : layers) {
    if (layer != *chosen)
      drops_.add(layer->name.empty() ? "a layer without a name" : named("the layer", layer->name));
  }
  return std::vector<const TiledLayer*>{*chosen};
}

// By layer, its number among the tile layers of the map.
std::vector<int> TiledLevelMaker::numbers_of(const std::vector<const TiledLayer*>& layers) const {
  std::vector<int> numbers;
  numbers.reserve(layers.size());
  for (const TiledLayer* layer : layers) {
    numbers.push_back(static_cast<int>(
        std::count_if(map_.layers.data(), layer, [](const TiledLayer& before) { return before.has_tiles; })));
  }
  return numbers;
}

// The first layer that is ground; in maps of others, in which all layers may be, the first with shapes, if
// there is one.
TileLayer& TiledLevelMaker::layer_to_choose(std::vector<TileLayer>& list) const {
  std::vector<bool> has_shape(tiles_.sources.size());
  for (std::size_t i = 0; i < has_shape.size(); ++i) {
    const TiledTile* const tile = tile_of(tiles_.sources[i]);
    has_shape[i] = !is_own_ && tile != nullptr && !tile->objects.empty();
  }
  const auto with_shapes = std::find_if(list.begin(), list.end(), [&](const TileLayer& layer) {
    return layer.is_ground && std::any_of(layer.cells->tiles().begin(), layer.cells->tiles().end(),
                                          [&](TileNumber tile) { return has_shape[tile]; });
  });
  if (with_shapes != list.end()) return *with_shapes;
  const auto ground =
      std::find_if(list.begin(), list.end(), [](const TileLayer& layer) { return layer.is_ground; });
  return ground == list.end() ? list.front() : *ground;
}

// One that was chosen alone is shown, and is ground, whatever the map says. Of a level of Talus, the only one
// has the name that it got there.
void TiledLevelMaker::take_layers(const std::vector<const TiledLayer*>& layers) {
  std::vector<TileLayer> list;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    TileLayer& layer = list.emplace_back(layers[i]->looks);
    if (layers.size() == 1 && has_other_tile_layers(*layers[0])) layer.visible = layer.is_ground = true;
    if (layers.size() == 1 && is_own_ && layer.name == kTiledTileLayer) layer.name.clear();
    if (layer.is_ground && shown_looks(map_.groups, layer).offset != Vec2())
      drops_.add("the offset of the ground of " + named("the layer", layers[i]->name) +
                 ": only its picture is moved");
    layer.cells = std::make_shared<const MapCells>(std::move(tiles_.cells[i]));
  }
  TileLayer& chosen = layer_to_choose(list);
  level_.map = TileMap(map_.width, map_.height, map_.tile_size);
  level_.map.cells() = *chosen.cells;
  chosen.cells = nullptr;
  level_.layers.chosen = static_cast<int>(&chosen - list.data());
  level_.layers.order = map_.order;
  level_.layers.groups = map_.groups;
  level_.layers.list = std::move(list);
}

// Reads the parts of the level for which Tiled has no place.
FormatResult<void> TiledLevelMaker::read_base() {
  const auto* text = find_property<std::string>(map_.properties, kTiledLevelProperty);
  if (text != nullptr) {
    auto read = read_native(*text, {});
    if (!read) return tl::unexpected(error_within("property talus_level", read.error()));
    is_own_ = true;
    base_ = *std::move(read);
    if (base_.map.tile_size() != map_.tile_size)
      return tl::unexpected(FormatError{"property talus_level",
                                        "is of a level whose tiles have another size than those of the map"});
    for (const Spawn& spawn : base_.spawns) spawns_by_x_.push_back(&spawn);
    sort_by_x(spawns_by_x_, kXOfSpawn);
    for (const LevelCurve& curve : base_.curves) {
      if (auto object = tiled_object(curve)) curves_by_x_.emplace_back(&curve, *std::move(object));
    }
    sort_by_x(curves_by_x_, kXOfCurve);
    base_objects_.set(base_.objects);
  }
  level_ = base_;
  if (!is_own_) level_.tuning = new_tuning(map_.tile_size);
  level_.spawns.clear();
  level_.curves.clear();
  level_.objects.clear();
  level_.sheet(SheetId::tiles) = {};
  return {};
}

// The parts of the base that name tiles by number, if the numbers have changed.
void TiledLevelMaker::forget_numbers() {
  if (!level_.brushes.empty()) drops_.add("the brushes, since the numbers of tiles have changed");
  if (level_.auto_tiles != AutoTiles())
    drops_.add("the tiles of painted ground, since the numbers of tiles have changed");
  bool shows_tiles = false;
  for (Spawn& spawn : base_.spawns) {
    if (spawn.picture.empty() || spawn.picture.sheet != SheetId::tiles) continue;
    spawn.picture = {};
    shows_tiles = true;
  }
  if (shows_tiles) drops_.add("the pictures of bodies, since the numbers of tiles have changed");
  level_.brushes.clear();
  level_.auto_tiles = {};
  level_.large_tiles.clear();
}

// As pixels of 16 colours, which carts and tools take, and as a picture if these do not show all of it.
void TiledLevelMaker::take_pixels() {
  const bool has_one = map_.tilesets.size() == 1 && pictures_[0] && pictures_[0]->file && !is_own_;
  const Palette before = level_.palette;
  put_images(picture_of_tiles(tiles_, map_, pictures_, TileSize()),
             has_one ? pictures_[0]->file->palette : std::vector<Rgb>(), level_);
  const auto [width, height] = map_.tile_size;
  const SheetLayout layout{tiles_.columns, static_cast<int>(tiles_.sources.size())};
  const std::int64_t wide = std::int64_t{layout.columns} * width, high = std::int64_t{layout.rows()} * height;
  if (wide > kMaxSheetPictureSide || high > kMaxSheetPictureSide || wide * high > kMaxSheetPicturePixels) {
    drops_.add(
        "the picture of the tiles in true colour, which would be too large: each tile has 8x8 px in 16 "
        "colours");
    return;
  }
  auto picture = std::make_shared<SheetPicture>(picture_of_tiles(tiles_, map_, pictures_, map_.tile_size));
  const bool is_fitted = !is_own_ || level_.palette != before;  // to the pictures
  const bool is_needed =
      !images_show(*picture, level_) || (is_fitted && has_opaque_color_0(*picture, level_));
  if (is_needed) level_.sheet(SheetId::tiles).picture = std::move(picture);
}

// A map without a colour of its own is clear where nothing is drawn. Talus's own maps say which colour that
// is of a level that does not.
void TiledLevelMaker::take_background() {
  if (is_own_ && map_.background == tiled_background(level_)) return;
  level_.background = rgba_of_hex(map_.background).value_or(Rgba{});
}

void TiledLevelMaker::name_flags() {
  std::vector<const TiledTile*> tiles;
  for (const TiledSource& source : tiles_.sources) tiles.push_back(tile_of(source));
  flags_.emplace(level_).name_flags(tiles, !is_own_);
}

// With the properties that are neither Talus's nor flags.
void TiledLevelMaker::take_note(TileNumber number, const TiledTile& tile) {
  TiledProperties others;
  for (const TiledProperty& property : tile.properties)
    if (!flags_->knows(property)) others.push_back(property);
  TileNote note{tile.type, tile.probability, json_of_properties(others)};
  const std::size_t bytes = note.type.size() + note.properties.size();
  if (note_bytes_ + bytes > kMaxNoteBytes) return drops_.add("the class and the properties of a tile");
  note_bytes_ += bytes;
  put_note(level_.tile_notes, number, std::move(note));
}

// Called for a speed that could not be read.
void TiledLevelMaker::tell_wrong_conveyor(const TiledProperties& properties, std::string_view name) {
  const auto has_name = [&](const TiledProperty& property) { return property.name == name; };
  if (std::any_of(properties.begin(), properties.end(), has_name))
    drops_.add("the speed of a conveyor, which is no number of at most 64 px a frame");
}

// The speed that a property of a tile says; nothing if there is none that can be read.
std::optional<double> TiledLevelMaker::conveyor_of_tile(TileNumber number) const {
  const TiledSource& source = tiles_.sources[number];
  const TiledTile* const tile = tile_of(source);
  const auto speed = tile == nullptr ? std::nullopt : conveyor_of(tile->properties, kTiledConveyor);
  if (!speed || !is_mirror(static_cast<TileTurn>(source.turn >> kTiledTurnShift))) return speed;
  return 0 - *speed;
}

// Gives a tile's own shape the speed that a property says.
void TiledLevelMaker::take_conveyor(TileNumber number, const TiledTile& tile, const TileShape& of_flags,
                                    TileShape& own) {
  own.conveyor = 0;
  const auto speed = conveyor_of_tile(number);
  if (!speed) return tell_wrong_conveyor(tile.properties, kTiledConveyor);
  if (*speed != 0 && own.kind == TileShape::Kind::none) own = of_flags;
  if (own.kind != TileShape::Kind::none) own.conveyor = *speed;
}

// Called when all tiles have their shapes.
void TiledLevelMaker::tell_bare_conveyors() {
  for (std::size_t i = 0; i < tiles_.sources.size(); ++i) {
    const auto tile = static_cast<TileNumber>(i);
    if (shape_of_tile(level_, tile).kind == TileShape::Kind::none && conveyor_of_tile(tile).value_or(0) != 0)
      drops_.add("the speed of a conveyor on a tile that is no ground");
  }
}

void TiledLevelMaker::take_tile(TileNumber number) {
  const TiledSource& source = tiles_.sources[number];
  const TileShape before = std::exchange(level_.tile_shapes[number], {});
  const TiledTile* const tile = tile_of(source);
  if (tile == nullptr) return;
  take_note(number, *tile);
  level_.sheet(SheetId::tiles).flags[number] = flags_->flags_of(*tile, drops_);
  const TileShape of_flags = shape_of_flags(level_, level_.tile_flags(number));
  TileShape own = own_shape_of(number, source, *tile, before);
  take_conveyor(number, *tile, of_flags, own);
  if (own == before || own != of_flags) level_.tile_shapes[number] = std::move(own);
  const TileShape shape = shape_of_tile(level_, number);
  if (is_own_ && tile->objects.empty() && !tiled_objects(shape, map_.tile_size).empty() && source.turn == 0)
    drops_.add("that a tile has no outline: its flags give it one");
  tell_stale_words(*tile, shape);
}

// Where the tiles of layers whose names say that they are ground have no shapes, all tiles of their tilesets
// are solid, so that what is painted there is ground as well. It does not matter whether a property says that
// the layer is none: switching that changes no shape. Of several names the clearest counts: beside walls, a
// layer that is called ground is what one walks over.
void TiledLevelMaker::fill_named_ground(const std::vector<const TiledLayer*>& layers) {
  std::optional<int> clearest;
  std::map<std::uint32_t, TileNumber> shown;  // by what a cell of the file has
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const auto rank = rank_of_ground(*layers[i]);
    if (!rank || (clearest && *rank > *clearest)) continue;
    if (rank != clearest) shown.clear();
    clearest = rank;
    const std::vector<TileNumber>& tiles = level_.cells_of(static_cast<int>(i)).tiles();
    assert(tiles.size() == layers[i]->cells.size());
    for (std::size_t k = 0; k < tiles.size(); ++k) shown.try_emplace(layers[i]->cells[k], tiles[k]);
  }
  const auto has_shape = [&](TileNumber tile) {
    return shape_of_tile(level_, tile).kind != TileShape::Kind::none;
  };
  const std::size_t first = tiles_.is_0_empty ? 1 : 0;  // empty cells, which may have tile 0, are no ground
  std::set<int> tilesets;
  for (const auto& [cell, tile] : shown) {
    if (tile >= first && has_shape(tile)) return;
    tilesets.insert(source_of_gid(map_, cell).tileset);
  }
  tilesets.erase(-1);  // of empty cells
  for (std::size_t i = first; i < tiles_.sources.size(); ++i) {
    const auto tile = static_cast<TileNumber>(i);
    if (tilesets.contains(tiles_.sources[i].tileset) && !has_shape(tile) && !is_ball_tile(level_, tile))
      level_.tile_shapes[tile] = {.kind = TileShape::Kind::solid,
                                  .conveyor = conveyor_of_tile(tile).value_or(0)};
  }
}

void TiledLevelMaker::take_animations() {
  level_.animations.clear();
  for (std::size_t n = 0; n < tiles_.sources.size(); ++n) {
    const TiledSource& source = tiles_.sources[n];
    const TiledTile* const tile = tile_of(source);
    if (tile == nullptr || tile->animation.empty()) continue;
    TileAnimation animation;
    for (const TiledTile::Frame& frame : tile->animation) {
      const auto shown = numbers_.find({source.tileset, frame.id, source.turn});
      if (shown == numbers_.end()) break;
      animation.push_back({shown->second, std::clamp(frame.duration, 1, kMaxFrameDuration)});
    }
    if (animation.size() == tile->animation.size())
      level_.animations[static_cast<TileNumber>(n)] = std::move(animation);
    else
      drops_.add("the animation of a tile with a frame that the level lacks");
  }
}

// An object of a tile in the px of a cell that shows the tile.
TiledObject TiledLevelMaker::in_cell(const TiledObject& object, const TiledSource& source) const {
  const TiledPlace place = place_of_tile(map_, pictures_, source);
  TiledObject result = turned(object, source.turn, place.size);
  const bool is_quarter = (source.turn & kTiledFlipXY) != 0;
  if (place.scale != Vec2{1, 1})
    result = stretched(result, is_quarter ? Vec2{place.scale.y, place.scale.x} : place.scale);
  result.position = result.position + Vec2{place.x, place.y};
  return result;
}

// before: the tile's own shape in the base. It stays if the outline is still that of the tile.
TileShape TiledLevelMaker::own_shape_of(TileNumber number, const TiledSource& source, const TiledTile& tile,
                                        const TileShape& before) {
  const TileShape of_flags = shape_of_flags(level_, level_.tile_flags(number));
  const TileShape expected = before.kind != TileShape::Kind::none ? before : of_flags;
  const bool* const word = find_property<bool>(tile.properties, "shape_one_way");
  std::vector<TiledObject> objects = tile.objects;
  std::erase_if(objects, is_point);
  const bool one_way = word != nullptr ? *word : !objects.empty() && is_one_way(objects.front());
  if (objects.empty() && source.turn != 0) {
    objects = tiled_objects(of_flags, map_.tile_size);
    for (TiledObject& object : objects) object = turned(object, source.turn, map_.tile_size);
  } else {
    for (TiledObject& object : objects) object = in_cell(object, source);
  }
  const std::vector<TiledObject> old = tiled_objects(expected, map_.tile_size);
  const bool is_unchanged =
      is_own_ && tiles_.keeps_numbers && (one_way == expected.one_way || old.size() > 1) &&
      std::equal(old.begin(), old.end(), objects.begin(), objects.end(),
                 [&](const TiledObject& a, const TiledObject& b) {
                   return is_same_outline(a, b) && (old.size() == 1 || is_one_way(a) == is_one_way(b));
                 });
  if (is_unchanged) return before;
  const bool is_solid = is_solid_by_word(tile.properties) && of_flags.kind == TileShape::Kind::none;
  const bool by_flags = !is_own_ && of_flags.one_way;
  if (is_solid && objects.empty()) return {.kind = TileShape::Kind::solid, .one_way = one_way || by_flags};
  std::optional<bool> all_one_way;  // empty: each outline says it
  if (word != nullptr || by_flags) all_one_way = one_way || by_flags;
  const auto* const side = find_property<std::string>(tile.properties, "shape_side");
  const bool is_ceiling = side != nullptr && *side == "ceiling";
  const TileShape shape = shape_of_objects(name_of_tile(number, source), objects, all_one_way, is_ceiling);
  return source.turn == 0 ? as_in_words(shape, tile, map_.tile_size) : shape;
}

// Several outlines become a group. is_ceiling: whether the tile says that its one-way outline stops bodies
// from below.
TileShape TiledLevelMaker::shape_of_objects(const std::string& tile, const std::vector<TiledObject>& objects,
                                            std::optional<bool> one_way, bool is_ceiling) {
  TileShape group;
  group.kind = TileShape::Kind::group;
  for (const TiledObject& object : objects) {
    const std::vector<Vec2> outline = outline_of(object);
    const std::size_t corners = outline.size();
    if (corners == 0 || corners > kMaxCorners) {
      drops_.add("a collision shape of " + tile +
                 (corners == 0 ? std::string(", which is not a box, an ellipse or a polygon")
                               : " with " + std::to_string(corners) + " corners, of which up to " +
                                     std::to_string(kMaxCorners) + " are looked at"));
      continue;
    }
    const bool is_thin = one_way.value_or(is_one_way(object));
    auto part = shape_of_object(object, outline, is_thin, is_ceiling, map_.tile_size);
    if (!part) part = nearest_shape_of(tile, outline, is_thin);
    if (part) group.parts.push_back(*std::move(part));
  }
  if (group.parts.empty()) return {};
  if (group.parts.size() == 1) return std::move(group.parts.front());
  if (const auto problem = problem_of(group, map_.tile_size)) {
    drops_.add("all but the first of the collision shapes of " + tile + ", as their union " + *problem);
    return std::move(group.parts.front());
  }
  return group;
}

// The shape that stands for an outline that no level can hold.
std::optional<TileShape> TiledLevelMaker::nearest_shape_of(const std::string& tile,
                                                           const std::vector<Vec2>& outline, bool one_way) {
  auto nearest = nearest_tile_shape(outline, map_.tile_size);
  if (!nearest) {
    drops_.add("the outline of " + tile + ", of which nothing is in the tile or up and right of it");
    return {};
  }
  drops_.add("the outline of " + tile + ", " + difference_text(*nearest));
  nearest->shape.one_way = nearest->shape.one_way || one_way;
  return std::move(nearest->shape);
}

// The outline counts. Properties of Talus that contradict it do not.
void TiledLevelMaker::tell_stale_words(const TiledTile& tile, const TileShape& shape) {
  const TiledProperties words = tiled_properties(shape);
  for (const TiledProperty& property : tile.properties) {
    if (!property.name.starts_with("shape") || !flags_->knows(property) || flags_->is_flag(property.name))
      continue;
    if (property == TiledProperty{"shape_one_way", false} || property.name == kTiledConveyor) continue;
    if (std::find(words.begin(), words.end(), property) == words.end())
      drops_.add("the property " + quoted_name(property.name) + " of a tile, as its outline says otherwise");
  }
}

// Whether the layer is there for bodies or curves, by its name.
bool is_for_bodies_or_curves(const TiledLayer& layer) {
  return layer.name == kTiledSpawnLayer || layer.name == kTiledBodyLayer || layer.name == kTiledCurveLayer;
}

// place: how many layers of tiles are behind the layer. number: of the layer among the others. A layer
// without objects is kept, so that some can be drawn in it; one of nothing but bodies and curves is not.
void TiledLevelMaker::take_objects(const TiledLayer& layer, int place, int number) {
  ObjectLayer others = object_layer_of(layer);
  others.place = place;
  base_objects_.choose(layer);
  base_objects_.complete(others, static_cast<int>(level_.layers.list.size()));
  if (layer.image) others.image = parts_.image_of(*layer.image);
  const Vec2 offset = shown_looks(map_.groups, layer.looks).offset;
  TiledSources::Layer source{number, {}};
  TiledSources::Place at{number, 0};
  for (TiledObject object : layer.objects) {
    const MapObject* const base = base_objects_.like(object);
    auto spawn = base == nullptr ? body_of(object) : std::nullopt;
    if (spawn) {
      spawn->position = spawn->position + offset;
      object.position = object.position + offset;
      take_spawn(object, *std::move(spawn));
    } else if (base == nullptr && object.form == TiledObject::Form::polyline &&
               (object.type == kTiledCurveType || layer.name == kTiledCurveLayer)) {
      object.position = object.position + offset;
      take_curve(object);
    } else if (auto kept = map_object_of(object, type_of(object)); has_room_for(kept)) {
      if (base != nullptr) take_exact(*base, kept);
      parts_.show(object.gid, kept);
      others.objects.push_back(std::move(kept));
      source.objects.push_back(at.index);
    } else {
      drops_.add("an object of the layer " + quoted_name(layer.name));
    }
    sources_.spawns.resize(level_.spawns.size(), at);
    sources_.curves.resize(level_.curves.size(), at);
    ++at.index;
  }
  const bool is_kept = base_objects_.has_chosen() || others.image || !others.objects.empty() ||
                       (layer.objects.empty() && !is_for_bodies_or_curves(layer));
  if (!is_kept || level_.objects.size() >= kMaxObjectLayers) return;
  level_.objects.push_back(std::move(others));
  sources_.layers.push_back(std::move(source));
}

// All layers that are not of tiles.
void TiledLevelMaker::take_other_layers(const std::vector<const TiledLayer*>& tile_layers) {
  int place = 0, number = 0;
  for (const TiledLayer& layer : map_.layers) {
    if (layer.has_tiles)
      place += std::count(tile_layers.begin(), tile_layers.end(), &layer) > 0 ? 1 : 0;
    else
      take_objects(layer, place, number++);
  }
  // Older versions of Talus wrote no layers of objects.
  if (find_property<bool>(map_.properties, kTiledObjectsProperty) == nullptr && level_.objects.empty())
    level_.objects = base_.objects;
}

// Whether the level can hold the object, too. Counts those that it can.
bool TiledLevelMaker::has_room_for(const MapObject& object) {
  const std::size_t bytes = object.name.size() + object.type.size() + object.properties.size();
  if (!is_well_placed(object) || object_bytes_ + bytes > kMaxObjectBytes) return false;
  object_bytes_ += bytes;
  return true;
}

// A tile that has no type gets that of the tile in its tileset.
const std::string& TiledLevelMaker::type_of(const TiledObject& object) const {
  if (!object.type.empty() || object.gid == 0) return object.type;
  const TiledTile* const tile = tile_of(source_of_gid(map_, object.gid));
  return tile == nullptr ? object.type : tile->type;
}

// A tile without a size has its own.
std::optional<Spawn> TiledLevelMaker::body_of(TiledObject object) const {
  if (object.gid != 0 && object.size == Vec2()) object.size = parts_.size_of(object.gid);
  return spawn_of(object, type_of(object), map_.tile_size, anchor_of_gid(map_, object.gid));
}

// The tile that shows a body in Tiled. A body is mirrored by its motion alone.
void TiledLevelMaker::take_picture(const TiledObject& object, Spawn& spawn) {
  const TiledSource source = source_of_gid(map_, object.gid);
  const auto shown = numbers_.find({source.tileset, source.id, 0});
  if (source.tileset < 0 || shown == numbers_.end()) return drops_.add("the picture of a body");
  if (source.turn != 0) drops_.add("the turn of a body's picture");
  spawn.picture[BodyAct::stand] = {.first = shown->second, .count = 1};
}

void TiledLevelMaker::take_spawn(const TiledObject& object, Spawn spawn) {
  constexpr std::array<std::string_view, 3> kKnown = {"vx", "vy", "foot"};
  for (const TiledProperty& property : object.properties) {
    if (std::find(kKnown.begin(), kKnown.end(), property.name) == kKnown.end())
      drops_.add("the property " + quoted_name(property.name) + " of a body");
  }
  if (object.rotation != 0) drops_.add("the rotation of a body");
  if (object.form == TiledObject::Form::tile) take_picture(object, spawn);
  if (level_.spawns.size() == kMaxSpawns) return drops_.add("a body, since a level holds at most 65536");
  if (const Spawn* const old = base_spawn_like(spawn, object)) return level_.spawns.push_back(*old);
  if (const auto written = json_of(std::vector<Spawn>{spawn}, ""); !written)
    drops_.add(named("the body", spawn.name) + ", as a number of it " + written.error().message);
  else
    level_.spawns.push_back(std::move(spawn));
}

// The curve that Talus wrote as this object; null if there is none.
const Spawn* TiledLevelMaker::base_spawn_like(const Spawn& spawn, const TiledObject& object) const {
  const double y = object.position.y;
  const auto near = near_in_x(std::span(spawns_by_x_), object.position.x, kXOfSpawn);
  const auto same = std::find_if(near.begin(), near.end(), [&](const Spawn* base) {
    if (std::abs(base->position.y - y) > 2 * tiled_slack(y)) return false;
    return is_name_of(base->name, spawn.name) && base->kind == spawn.kind &&
           base->velocity == spawn.velocity && base->used_foot() == spawn.used_foot() &&
           is_same_outline(tiled_object(*base), object);
  });
  return same == near.end() ? nullptr : *same;
}

void TiledLevelMaker::take_curve(const TiledObject& object) {
  const std::vector<Curve> curves = curves_of(object);
  if (curves.empty()) return drops_.add(named("the curve", object.name));
  if (!conveyor_of(object.properties, "conveyor")) tell_wrong_conveyor(object.properties, "conveyor");
  const auto near = near_in_x(std::span(std::as_const(curves_by_x_)), object.position.x, kXOfCurve);
  const auto same = std::find_if(near.begin(), near.end(), [&](const auto& old) {
    const Curve &was = old.first->curve, &now = curves.front();
    return is_name_of(old.first->name, object.name) && was.faces == now.faces &&
           was.conveyor == now.conveyor && is_same_outline(old.second, object);
  });
  if (same != near.end()) {
    const LevelCurve& old = *same->first;
    if (takes(old.curve, old.name)) level_.curves.push_back(old);
    return;
  }
  if (const auto exact = curve_of_numbers(object)) {
    if (takes(*exact, object.name)) level_.curves.push_back({object.name, *exact, ""});
    return;
  }
  const auto* const kind = find_property<std::string>(object.properties, "kind");
  if (kind != nullptr && *kind != "segment" && *kind != "polyline")
    drops_.add("the exact form of a curve that was changed in Tiled: it has lines now");
  for (const Curve& curve : curves) {
    // Each line of the object has its name. Beyond the limit of names, which is reported at the end, none is
    // copied.
    if (curve_name_bytes_ > kMaxNameBytes) return;
    if (!takes(curve, object.name)) continue;
    curve_name_bytes_ += object.name.size();
    level_.curves.push_back({object.name, curve, ""});
  }
}

// Whether the curve can be in the level; if not, says why.
bool TiledLevelMaker::takes(const Curve& curve, const std::string& name) {
  if (level_.curves.size() == kMaxCurves)
    drops_.add("a curve, since a level holds at most 16384");
  else if (const auto problem = problem_of(curve, level_.map))
    drops_.add(named("the curve", name) + ", which " + *problem);
  else
    return true;
  return false;
}

FormatResult<Level> TiledLevelMaker::make(const ImportChoices& choices) {
  const auto layers = layers_of(choices);
  if (!layers) return tl::unexpected(layers.error());
  if (const auto read = read_base(); !read) return tl::unexpected(read.error());
  auto tiles = number_tiles(map_, *layers, pictures_, choices, base_.sheet(SheetId::tiles).layout(),
                            is_own_ ? std::optional(level_.palette[0]) : std::nullopt, drops_, progress_);
  if (!tiles) return tl::unexpected(tiles.error());
  tiles_ = *std::move(tiles);
  for (std::size_t n = 0; n < tiles_.sources.size(); ++n)
    numbers_.try_emplace(tiles_.sources[n], static_cast<TileNumber>(n));
  take_layers(*layers);
  TiledOrigin origin;
  origin.frame = frame_of(tiles_, map_);
  origin.layers = numbers_of(*layers);
  origin.pictures = std::make_shared<const PictureTiles>(picture_tiles_of(tiles_, map_, pictures_));
  const SheetLayout layout{tiles_.columns, static_cast<int>(tiles_.sources.size())};
  if (!tiles_.keeps_numbers || layout.count < level_.tile_count()) forget_numbers();
  level_.set_tile_layout(layout);
  if (!is_own_) level_.tilesets = tilesets_of(tiles_, map_);  // its own are in the base
  take_pixels();
  take_background();
  name_flags();
  level_.tile_notes.clear();
  for (int tile = 0; tile < layout.count; ++tile) take_tile(static_cast<TileNumber>(tile));
  if (!is_own_) fill_named_ground(*layers);
  tell_bare_conveyors();
  take_animations();
  if (!is_own_) level_.large_tiles = parts_.large_tiles(tiles_);
  take_other_layers(*layers);
  tidy_groups(level_.layers, level_.objects);
  parts_.tell_missing();
  if (auto problem = problem_of_amounts(level_)) return tl::unexpected(FormatError{"", *std::move(problem)});
  level_.tiled = std::make_shared<const TiledOrigin>(std::move(origin));
  return std::move(level_);
}

}  // namespace

FormatResult<Level> level_of_tiled(const TiledMap& map, const TiledPictures& pictures,
                                   const ImportChoices& choices, ImportDrops& drops, const Progress& progress,
                                   TiledSources* sources) {
  TiledLevelMaker maker(map, pictures, drops, progress);
  auto level = maker.make(choices);
  if (sources != nullptr) *sources = maker.take_sources();
  return level;
}

}  // namespace talus
