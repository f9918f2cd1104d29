// Pictures, flags, shapes and bodies.
#include "ldtk_level.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <talus/level/limits.h>
#include "../import/sheet_images.h"
#include "../native/native_objects.h"
#include "ldtk_background.h"
#include "ldtk_entities.h"
#include "ldtk_keys.h"
#include "ldtk_meanings.h"
#include "ldtk_picture_tiles.h"
#include "ldtk_turns.h"

namespace talus {
namespace {

class LdtkLevelMaker {
 public:
  LdtkLevelMaker(const LdtkProject& project, const LdtkLevel& source, const LdtkPictures& pictures,
                 const ImportChoices& choices, ImportDrops& drops, const Progress& progress)
      : project_(project),
        source_(source),
        pictures_(pictures),
        choices_(choices),
        drops_(drops),
        progress_(progress) {}

  FormatResult<Level> make();

 private:
  void take_layers();
  FormatResult<void> take_pictures();
  void find_ground();
  void name_flags();
  void take_tiles();
  std::vector<const std::string*> data_of(const LdtkCell& cell) const;
  void take_notes();
  void take_bodies(const LdtkLayer& layer);
  void take_body(const LdtkEntity& entity, BodyKind kind, Vec2 offset);

  const LdtkProject& project_;
  const LdtkLevel& source_;
  const LdtkPictures& pictures_;
  const ImportChoices& choices_;
  ImportDrops& drops_;
  const Progress& progress_;
  LdtkMapping mapping_;
  LdtkTiles tiles_;
  std::vector<LdtkTileMeaning> meanings_;  // by tile
  std::map<std::string, int> flags_;       // by name
  Vec2 origin_;                            // px, of the map in the level of LDtk
  Level level_;
};

// About as wide as high.
SheetLayout layout_for(std::size_t count) {
  const auto tiles = std::max(static_cast<int>(count), kCartTiles);
  const int rows_of_cart = static_cast<int>(std::ceil(std::sqrt(tiles) / kCartColumns));
  return {kCartColumns * rows_of_cart, tiles};
}

// Puts an image into a picture of images of that size. rgba: of the image, of which some pixels are left out
// or repeated if it has another size.
void put_image(const std::vector<std::uint8_t>& rgba, TileSize size, Cell place, TileSize image,
               SheetPicture& picture) {
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const int from_x = (2 * x + 1) * size.width / (2 * image.width);
      const int from_y = (2 * y + 1) * size.height / (2 * image.height);
      const auto from = static_cast<std::ptrdiff_t>(4) * (from_y * size.width + from_x);
      const auto to = static_cast<std::ptrdiff_t>(4) *
                      ((static_cast<std::ptrdiff_t>(place.y) * image.height + y) * picture.width +
                       static_cast<std::ptrdiff_t>(place.x) * image.width + x);
      std::copy_n(rgba.begin() + from, 4, picture.rgba.begin() + to);
    }
  }
}

SheetPicture blank_picture(std::int64_t width, std::int64_t height) {
  SheetPicture picture{static_cast<int>(width), static_cast<int>(height), {}};
  picture.rgba.resize(4 * static_cast<std::size_t>(width * height));
  return picture;
}

// Layers with ground in them are ground, and so is that which is painted on.
void LdtkLevelMaker::find_ground() {
  for (TileLayer& layer : tiles_.layers) {
    layer.is_ground =
        std::any_of(layer.cells->tiles().begin(), layer.cells->tiles().end(), [&](TileNumber tile) {
          return meanings_[tile].shape.kind != TileShape::Kind::none || !meanings_[tile].roles.empty();
        });
  }
  tiles_.layers[static_cast<std::size_t>(tiles_.ground)].is_ground = true;
}

// A single layer is shown even if it is hidden.
void LdtkLevelMaker::take_layers() {
  TileLayer& chosen = tiles_.layers[static_cast<std::size_t>(tiles_.ground)];
  if (tiles_.layers.size() == 1) chosen.visible = true;
  level_.map = tiles_.map;
  level_.map.cells() = *chosen.cells;
  chosen.cells = nullptr;
  level_.layers.list = std::move(tiles_.layers);
  level_.layers.chosen = tiles_.ground;
}

// As pixels of 16 colours, which carts and tools take, and in true colour if these do not show all of it.
FormatResult<void> LdtkLevelMaker::take_pictures() {
  const TileSize size = tiles_.map.tile_size(), small;
  const SheetLayout layout = layout_for(tiles_.cells.size());
  level_.set_tile_layout(layout);
  const std::int64_t width = std::int64_t{layout.columns} * size.width;
  const std::int64_t height = std::int64_t{layout.rows()} * size.height;
  const bool fits = width <= kMaxSheetPictureSide && height <= kMaxSheetPictureSide &&
                    width * height <= kMaxSheetPicturePixels;
  if (!fits) {
    drops_.add(
        "the picture of the tiles in true colour, which would be too large: each tile has 8x8 px in 16 "
        "colours");
  }
  SheetPicture picture = fits ? blank_picture(width, height) : SheetPicture();
  const auto [r, g, b] = source_.head.color;
  level_.background = Rgba{r, g, b, 255};
  SheetPicture images = blank_picture(layout.columns * small.width, layout.rows() * small.height);
  for (std::size_t tile = 1; tile < tiles_.cells.size(); ++tile) {
    if (!progress_.at(tile, tiles_.cells.size())) return was_cancelled();
    const auto rgba = picture_of_ldtk_cell(tiles_, tiles_.cells[tile], pictures_);
    const Cell place = layout.place_of(static_cast<int>(tile));
    put_image(rgba, size, place, small, images);
    if (fits) put_image(rgba, size, place, size, picture);
  }
  put_images(images, {}, level_);
  if (!fits) return {};
  const bool is_needed = !images_show(picture, level_) || has_opaque_color_0(picture, level_);
  if (is_needed)
    level_.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(picture));
  return {};
}

// Names of values and tags become flags, as many as there are. Those of a cart come first, and among them
// those without a role. Those that lose their role are none that the level has a use for. Roles that were
// chosen keep or get a flag.
void LdtkLevelMaker::name_flags() {
  std::vector<int> order = {4, 5, 6, 7, 3, 2, 1, 0};
  for (int flag = kCartFlags; flag < kMaxFlags; ++flag) order.push_back(flag);
  std::set<std::string> names;
  std::vector<int FlagRoles::*> roles;
  for (const LdtkTileMeaning& meaning : meanings_) {
    names.insert(meaning.flags.begin(), meaning.flags.end());
    for (int FlagRoles::*const role : meaning.roles) {
      if (std::find(roles.begin(), roles.end(), role) == roles.end()) roles.push_back(role);
    }
  }
  for (int FlagRoles::*const role : roles) {
    int& flag = level_.roles.*role;
    if (flag == FlagRoles::kUnused) flag = order.front();
    std::erase(order, flag);
  }
  std::size_t next = 0;
  for (const std::string& name : names) {
    if (next == order.size()) {
      drops_.add("the name " + quoted_name(name) +
                 " of a value or tag of tiles, as tiles have only 32 flags");
      continue;
    }
    const int flag = order[next++];
    flags_[name] = flag;
    level_.flag_names[static_cast<std::size_t>(flag)] = name;
    for (const FlagRoleInfo& role : flag_role_infos()) {
      if (level_.roles.*role.flag == flag) level_.roles.*role.flag = FlagRoles::kUnused;
    }
  }
}

void LdtkLevelMaker::take_tiles() {
  for (std::size_t tile = 0; tile < tiles_.cells.size(); ++tile) {
    const LdtkTileMeaning& meaning = meanings_[tile];
    FlagSet& flags = level_.sheet(SheetId::tiles).flags[tile];
    for (const std::string& name : meaning.flags) {
      const auto flag = flags_.find(name);
      if (flag != flags_.end()) flags |= flag_bit(flag->second);
    }
    for (int FlagRoles::*const role : meaning.roles) flags |= flag_bit(level_.roles.*role);
    const TileShape& shape = meaning.shape;
    const bool is_full = shape == TileShape{.kind = TileShape::Kind::solid};
    if (is_full && level_.roles.solid != FlagRoles::kUnused)
      flags |= flag_bit(level_.roles.solid);
    else
      level_.tile_shapes[tile] = shape;
  }
}

// The custom data of the tiles that a cell shows in their places, from the lowest; of a tile that it shows
// several times, the uppermost counts.
std::vector<const std::string*> LdtkLevelMaker::data_of(const LdtkCell& cell) const {
  std::vector<const std::string*> all;
  std::set<const std::string*> seen;
  for (auto part = cell.parts.rbegin(); part != cell.parts.rend(); ++part) {
    const LdtkSource& source = tiles_.sources[part->source];
    if (source.tileset < 0 || !is_in_place(*part, source, tiles_.map.tile_size())) continue;
    const auto& data = project_.tilesets[static_cast<std::size_t>(source.tileset)].data;
    const auto found = data.find(source.id);
    if (found != data.end() && seen.insert(&found->second).second) all.push_back(&found->second);
  }
  std::reverse(all.begin(), all.end());
  return all;
}

// The upper ones go before the lower.
void LdtkLevelMaker::take_notes() {
  constexpr std::size_t kMaxRead = 16 * kMaxNoteBytes;
  std::size_t bytes = 0, read = 0;
  for (std::size_t tile = 0; tile < tiles_.cells.size(); ++tile) {
    Json properties = Json::object();
    for (const std::string* data : data_of(tiles_.cells[tile])) {
      constexpr int kDeepest = 16;  // far below what a level may nest
      read += data->size();
      if (read > kMaxRead) break;
      const auto json = parse_json(*data);
      if (json && json->is_object() && depth_of(*json) <= kDeepest)
        properties.update(*json);
      else
        properties["data"] = *data;
    }
    if (properties.empty() && read <= kMaxRead) continue;
    TileNote note;
    note.properties = properties.dump(-1, ' ', false, Json::error_handler_t::replace);
    bytes += note.properties.size();
    if (bytes > kMaxNoteBytes || read > kMaxRead) return drops_.add("the custom data of tiles beyond 16 MiB");
    put_note(level_.tile_notes, static_cast<TileNumber>(tile), std::move(note));
  }
}

void LdtkLevelMaker::take_bodies(const LdtkLayer& layer) {
  for (const LdtkEntity& entity : layer.entities) {
    if (const auto kind = ldtk_meaning_of_entity(mapping_, entity.type))
      take_body(entity, *kind, Vec2{1.0 * layer.offset_x, 1.0 * layer.offset_y} - origin_);
  }
}

// offset: px, of the entity's layer on the map.
void LdtkLevelMaker::take_body(const LdtkEntity& entity, BodyKind kind, Vec2 offset) {
  if (level_.spawns.size() == kMaxSpawns) return drops_.add("a body, since a level holds at most 65536");
  Spawn spawn;
  spawn.name = entity.name;
  spawn.kind = kind;
  spawn.velocity = entity.velocity;
  const auto side = [](double length) { return std::clamp(length, 1.0, kMaxBodySize); };
  const bool has_size = entity.size.x > 0 && entity.size.y > 0;
  spawn.size =
      has_size ? Vec2{side(entity.size.x), side(entity.size.y)} : new_body_size(kind, level_.map.tile_size());
  spawn.position =
      entity.position + offset - Vec2{entity.pivot.x * spawn.size.x, entity.pivot.y * spawn.size.y};
  if (const auto written = json_of(std::vector<Spawn>{spawn}, ""); !written)
    drops_.add("the body " + quoted_name(entity.type) + ", as a number of it " + written.error().message);
  else
    level_.spawns.push_back(std::move(spawn));
}

FormatResult<Level> LdtkLevelMaker::make() {
  mapping_ = choices_.mapping.value_or(LdtkMapping());
  const auto ground = ldtk_ground_layer(source_, choices_);
  if (!ground) return tl::unexpected(ground.error());
  if (*ground >= 0) {
    const LdtkLayer& layer = source_.layers[static_cast<std::size_t>(*ground)];
    origin_ = {1.0 * layer.offset_x, 1.0 * layer.offset_y};
  }
  auto tiles = ldtk_tiles_of(project_, source_, *ground, choices_.ldtk_tiles, pictures_, drops_,
                             progress_.part(0, 0.6));
  if (!tiles) return tl::unexpected(tiles.error());
  tiles_ = *std::move(tiles);
  turn_mirrored_tiles(project_, mapping_, choices_.ldtk_tiles.size(), tiles_);
  meanings_ = ldtk_tile_meanings(project_, mapping_, tiles_, drops_);
  find_ground();
  level_.tuning = new_tuning(tiles_.map.tile_size());
  take_layers();
  if (const auto taken = take_pictures(); !taken) return tl::unexpected(taken.error());
  name_flags();
  take_tiles();
  take_notes();
  for (const LdtkLayer& layer : source_.layers) take_bodies(layer);
  if (source_.background) {
    if (auto layer = ldtk_background_layer(*source_.background, origin_, drops_))
      level_.objects.push_back(*std::move(layer));
  }
  for (ObjectLayer& layer : ldtk_object_layers(project_, source_, mapping_, *ground, origin_, drops_))
    level_.objects.push_back(std::move(layer));
  if (auto problem = problem_of_amounts(level_)) return tl::unexpected(FormatError{"", *std::move(problem)});
  const LdtkLevelHead& head = source_.head;
  LdtkOrigin origin{project_.iid,
                    head.iid.empty() ? head.name : head.iid,
                    head.world.empty() ? head.name : head.world + "/" + head.name,
                    choices_.layer_number,
                    std::move(mapping_),
                    ldtk_things_of(project_, source_),
                    ldtk_keys_of(tiles_, project_),
                    nullptr,
                    std::make_shared<const PictureTiles>(picture_tiles_of(tiles_, pictures_))};
  origin.opened = std::make_shared<const Level>(level_);
  level_.ldtk = std::make_shared<const LdtkOrigin>(std::move(origin));
  return std::move(level_);
}

}  // namespace

FormatResult<Level> level_of_ldtk(const LdtkProject& project, const LdtkLevel& source,
                                  const LdtkPictures& pictures, const ImportChoices& choices,
                                  ImportDrops& drops, const Progress& progress) {
  return LdtkLevelMaker(project, source, pictures, choices, drops, progress).make();
}

}  // namespace talus
