// Objects that give a part of the shape stay; others get the form of the parts that are left.
#include "tiled_tile_writer.h"

#include <algorithm>
#include <iterator>

#include "tiled_flags.h"
#include "tiled_objects.h"
#include "tiled_properties.h"
#include "tiled_shapes.h"

namespace talus {
namespace {

class TileWriter {
 public:
  TileWriter(const Level& level, const TiledContent& model, const TiledSource& source, TileNumber number,
             const std::array<std::string, kMaxFlags>& names)
      : level_(level),
        size_(level.map.tile_size()),
        names_(names),
        flags_(level.tile_flags(number)),
        place_(place_of_tile(model.map, model.pictures, source)) {
    const TiledTileset& tileset = model.map.tilesets[static_cast<std::size_t>(source.tileset)];
    if (const TiledTile* const known = find_tile(tileset, source.id)) tile_ = *known;
    shape_ = level.tile_shapes[number];
  }

  // before: the flags that the files give. shape_differs: whether the level has other flags, or another
  // shape.
  void edit_physics(FlagSet before, bool shape_differs) {
    if (flags_ != before) edit_flags(before);
    if (shape_differs && !objects_give_flags()) edit_shape();
  }
  // Properties that are true or false would be read as flags: they are left out.
  void edit_note(const TileNote& before, const TileNote& now) {
    if (now.probability != before.probability) edit_.probability = now.probability;
    if (now.type != before.type) edit_.type = now.type;
    for (TiledPropertyEdit& property : property_edits(before.properties, now.properties)) {
      const bool is_flag = property.value && std::holds_alternative<bool>(*property.value);
      if (!is_flag) edit_.properties.push_back(std::move(property));
    }
  }
  void edit_animation(std::vector<TiledTile::Frame> frames) { edit_.animation = std::move(frames); }
  TiledTileEdit take() { return std::move(edit_); }

 private:
  struct Part {
    TileShape shape;
    bool is_there = false;  // whether an object gives it
  };

  const TiledProperty* property(std::string_view name) const {
    const auto found = std::find_if(tile_.properties.begin(), tile_.properties.end(),
                                    [&](const TiledProperty& p) { return p.name == name; });
    return found == tile_.properties.end() ? nullptr : &*found;
  }
  bool is_true(std::string_view name) const {
    const bool* const value = find_property<bool>(tile_.properties, name);
    return value != nullptr && *value;
  }
  void set(std::string name, std::optional<decltype(TiledProperty::value)> value) {
    edit_.properties.push_back({std::move(name), std::move(value)});
  }

  void edit_flags(FlagSet before);
  bool objects_give_flags() const;
  void edit_shape();
  void edit_words(const std::vector<Part>& parts);
  void edit_objects(std::vector<Part>& parts);
  std::optional<TileShape> part_of(const TiledObject& object, bool one_way) const;
  TiledObject object_of(const TileShape& part) const;

  const Level& level_;
  TileSize size_;
  const std::array<std::string, kMaxFlags>& names_;
  FlagSet flags_;
  TiledPlace place_;
  TiledTile tile_;
  TileShape shape_;
  TiledTileEdit edit_;
};

TileShape still(TileShape shape) {
  shape.conveyor = 0;
  return shape;
}

bool is_one_way_object(const TiledObject& object) {
  const bool* const word = find_property<bool>(object.properties, "one_way");
  return word != nullptr && *word;
}

// A number with all flags is kept up to date; else each flag is a property.
void TileWriter::edit_flags(FlagSet before) {
  const bool has_number = find_property<std::int64_t>(tile_.properties, "flags") != nullptr;
  if (has_number) set("flags", tiled_number_of(flags_));
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    const FlagSet bit = flag_bit(flag);
    if (((flags_ ^ before) & bit) == 0) continue;
    const std::string& name = names_[static_cast<std::size_t>(flag)];
    const bool is_there = property(name) != nullptr, is_on = (flags_ & bit) != 0;
    if (is_on && (!has_number || is_there)) set(name, true);
    if (!is_on && is_there) set(name, std::nullopt);
  }
}

// The shape that an object gives on its tile of the level, as it is read.
std::optional<TileShape> TileWriter::part_of(const TiledObject& object, bool one_way) const {
  TiledObject moved = object;
  moved.position = moved.position + Vec2{1.0 * place_.x, 1.0 * place_.y};
  const std::vector<Vec2> outline = outline_of(moved);
  if (outline.empty() || outline.size() > kMaxCorners) return {};
  const bool is_ceiling = shape_.side == TileShape::Side::ceiling;
  if (auto shape = shape_of_object(object, outline, one_way, is_ceiling, size_)) return shape;
  auto nearest = nearest_tile_shape(outline, size_);
  if (!nearest) return {};
  nearest->shape.one_way = nearest->shape.one_way || one_way;
  return std::move(nearest->shape);
}

// The object of a part that has one, with its first point as its place.
TiledObject TileWriter::object_of(const TileShape& part) const {
  TiledObject object = tiled_objects(part, size_).front();
  if (!object.points.empty()) {
    const Vec2 first = object.points.front();
    object.position = first;
    for (Vec2& point : object.points) point = point - first;
  }
  object.position = object.position - Vec2{1.0 * place_.x, 1.0 * place_.y};
  return object;
}

// Whether the tile has no shape of its own, and its objects, if there are any, are the shape of its flags.
bool TileWriter::objects_give_flags() const {
  if (shape_.kind != TileShape::Kind::none) return false;
  const TileShape of_flags = shape_of_flags(level_, flags_);
  const bool all_one_way = is_true("shape_one_way") || of_flags.one_way;
  TileShape all;
  for (const TiledObject& object : tile_.objects) {
    auto part = part_of(object, all_one_way || is_one_way_object(object));
    if (!part) continue;
    if (all.kind != TileShape::Kind::none) return false;
    all = *std::move(part);
  }
  if (all.kind == TileShape::Kind::none) return tile_.objects.empty() && !is_solid_by_word(tile_.properties);
  return all == of_flags;
}

void TileWriter::edit_shape() {
  std::vector<Part> parts;
  if (shape_.kind == TileShape::Kind::group) {
    for (const TileShape& part : shape_.parts) parts.push_back({part});
  } else if (shape_.kind != TileShape::Kind::none) {
    parts.push_back({still(shape_)});
  }
  std::erase_if(parts, [&](const Part& part) { return tiled_objects(part.shape, size_).empty(); });
  edit_words(parts);
  for (Part& part : parts) {  // as they are read again: a profile has as many heights as its line needs
    if (part.shape.kind == TileShape::Kind::polygon) continue;
    const TiledObject object = tiled_objects(part.shape, size_).front();
    if (auto read = tile_shape_of(outline_of(object), part.shape.one_way, size_))
      part.shape = *std::move(read);
  }
  edit_objects(parts);
}

// Properties about the shape that the tile has, and the heights that its outline does not tell.
void TileWriter::edit_words(const std::vector<Part>& parts) {
  const TiledProperties wanted = tiled_properties(shape_);
  for (const std::string name :
       {"shape", "shape_heights", "shape_one_way", "shape_side", kTiledConveyor.data()}) {
    const TiledProperty* const known = property(name);
    const auto word =
        std::find_if(wanted.begin(), wanted.end(), [&](const auto& p) { return p.name == name; });
    const bool has_word = word != wanted.end();
    if (known != nullptr && has_word && *known != *word) set(name, word->value);
    if (known != nullptr && !has_word && *known != TiledProperty{name, false}) set(name, std::nullopt);
    // Without this word a one-way outline at the top of a tile is one that bodies stand on.
    const bool is_needed = name == kTiledConveyor || (name == "shape_side" && shape_.one_way);
    if (known == nullptr && has_word && is_needed) set(name, word->value);
    if (known != nullptr || !has_word || name != "shape_heights" || parts.empty()) continue;
    const TiledObject object = tiled_objects(shape_, size_).front();
    if (tile_shape_of(outline_of(object), shape_.one_way, size_) != still(shape_)) set(name, word->value);
  }
  for (const std::string_view word : kTiledSolidWords)
    if (shape_.kind == TileShape::Kind::none && is_true(word)) set(std::string(word), false);
}

void TileWriter::edit_objects(std::vector<Part>& parts) {
  const bool all_one_way =
      shape_.kind != TileShape::Kind::group && shape_.one_way && property("shape_one_way") != nullptr;
  std::vector<int> others;  // objects that give none of the parts
  const auto take = [&](int index, bool with_one_way) {
    const TiledObject& object = tile_.objects[static_cast<std::size_t>(index)];
    const bool one_way = all_one_way || is_one_way_object(object);
    for (Part& part : parts) {
      if (part.is_there || (with_one_way && part.shape.one_way != one_way)) continue;
      if (part_of(object, part.shape.one_way) != part.shape) continue;
      part.is_there = true;
      if (part.shape.one_way == one_way) return true;
      const auto value =
          part.shape.one_way ? std::optional<decltype(TiledProperty::value)>(true) : std::nullopt;
      edit_.objects.push_back({index, false, {}, {{"one_way", value}}});
      return true;
    }
    return false;
  };
  for (int i = 0; i < static_cast<int>(tile_.objects.size()); ++i) {
    const bool is_part = part_of(tile_.objects[static_cast<std::size_t>(i)], false).has_value();
    if (is_part && !take(i, true)) others.push_back(i);
  }
  std::erase_if(others, [&](int i) { return take(i, false); });
  auto next = others.begin();
  for (const Part& part : parts) {
    if (part.is_there) continue;
    TiledObjectEdit change{-1, false, object_of(part.shape), {}};
    bool was_one_way = false, was_polygon = false;
    if (next != others.end()) {
      const TiledObject& old = tile_.objects[static_cast<std::size_t>(*next)];
      change.index = *next++;
      change.object->name = old.name;
      change.object->type = old.type;
      was_one_way = is_one_way_object(old);
      was_polygon = says_polygon(old);
    }
    const bool is_polygon = part.shape.kind == TileShape::Kind::polygon &&
                            part_of(*change.object, part.shape.one_way) != part.shape;
    if (is_polygon && !was_polygon) change.properties.push_back({polygon_word().name, polygon_word().value});
    if (!is_polygon && was_polygon) change.properties.push_back({polygon_word().name, std::nullopt});
    if (part.shape.one_way && !all_one_way && !was_one_way) change.properties.push_back({"one_way", true});
    if (!part.shape.one_way && was_one_way) change.properties.push_back({"one_way", std::nullopt});
    edit_.objects.push_back(std::move(change));
  }
  for (; next != others.end(); ++next) {
    TiledObjectEdit& removal = edit_.objects.emplace_back();
    removal.index = *next;
    removal.removes = true;
  }
}

// The tileset that a number in cells belongs to; -1: none.
int tileset_of(const TiledMap& map, std::uint32_t gid) {
  int found = -1;
  for (int i = 0; i < static_cast<int>(map.tilesets.size()); ++i) {
    const std::uint32_t first = map.tilesets[static_cast<std::size_t>(i)].first_gid;
    if (first <= gid && (found < 0 || first >= map.tilesets[static_cast<std::size_t>(found)].first_gid))
      found = i;
  }
  return found;
}

bool is_same_animation(const TileAnimation* a, const TileAnimation* b) {
  return a == nullptr || b == nullptr ? a == b : *a == *b;
}

// The frames as the tileset has them, none without an animation; nothing if one shows a tile that the tileset
// lacks.
std::optional<std::vector<TiledTile::Frame>> frames_in(const TiledFrame& frame, const TiledTileset& tileset,
                                                       const TileAnimation* animation) {
  std::vector<TiledTile::Frame> frames;
  if (animation == nullptr) return frames;
  const auto count = static_cast<std::uint32_t>(grid_of(tileset).count);
  for (const auto& [tile, duration] : *animation) {
    const std::uint32_t cell = tile < frame.tiles.size() ? frame.tiles[tile] : 0;
    if (cell < tileset.first_gid || cell - tileset.first_gid >= count) return std::nullopt;
    frames.push_back({static_cast<int>(cell - tileset.first_gid), duration});
  }
  return frames;
}

}  // namespace

TiledTilesetEdits tileset_edits(const Level& level, const TiledOrigin& origin, const TiledContent& model,
                                const std::array<std::string, kMaxFlags>& names,
                                const std::set<TileNumber>& left_out) {
  TiledTilesetEdits edits;
  const Level& opened = *origin.opened;
  for (std::size_t n = 0; n < origin.frame.tiles.size() && n < level.tile_shapes.size(); ++n) {
    const auto number = static_cast<TileNumber>(n);
    const bool same_physics = level.tile_shapes[n] == opened.tile_shapes[n] &&
                              level.tile_flags(number) == opened.tile_flags(number);
    const TileNote &now = note_of(level.tile_notes, number), &before = note_of(opened.tile_notes, number);
    const TileAnimation* const animation = find_animation(level.animations, number);
    const bool same_animation = is_same_animation(animation, find_animation(opened.animations, number));
    if (same_physics && now == before && same_animation) continue;
    const std::uint32_t cell = origin.frame.tiles[n];
    const int of = cell == (cell & kTiledIdBits) && cell != 0 ? tileset_of(model.map, cell) : -1;
    if (of < 0 || left_out.contains(number)) continue;
    const TiledTileset& tileset = model.map.tilesets[static_cast<std::size_t>(of)];
    if (tileset.is_missing) continue;
    const TiledSource source{of, static_cast<int>(cell - tileset.first_gid), 0};
    TileWriter writer(level, model, source, number, names);
    writer.edit_physics(opened.tile_flags(number), !same_physics);
    writer.edit_note(before, now);
    if (auto frames = same_animation ? std::nullopt : frames_in(origin.frame, tileset, animation))
      writer.edit_animation(*std::move(frames));
    const TiledTilesetPlace place{tileset.file, tileset.file.empty() ? of : 0};
    if (edits.of[place].try_emplace(source.id, writer.take()).second) edits.tiles.insert(number);
  }
  return edits;
}

std::array<std::string, kMaxFlags> names_for_tiled(const Level& level, const Level& opened, bool takes_new) {
  auto names = tiled_flag_names(opened);
  const auto new_names = tiled_flag_names(level);
  for (std::size_t flag = 0; takes_new && flag < names.size(); ++flag) {
    const bool is_free = names[flag] == "flag" + std::to_string(flag);
    if (is_free && std::find(names.begin(), names.end(), new_names[flag]) == names.end())
      names[flag] = new_names[flag];
  }
  return names;
}

}  // namespace talus
