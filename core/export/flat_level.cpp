#include "flat_level.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <talus/level/tile_turns.h>
#include "../formats/import/import_drops.h"
#include "../level/ground_cells.h"
#include "../level/tile_color.h"
#include "../level/tile_renumber.h"

namespace talus {
namespace {

// What a layer has in a cell.
struct LayerTile {
  int layer = 0;
  TileNumber tile = 0;
  TileTurn turn = TileTurn::none;
  friend auto operator<=>(const LayerTile&, const LayerTile&) = default;
};
using LayerTiles = std::vector<LayerTile>;  // of one cell, from the back to the front

bool is_drawn(const TileLayer& layer) { return layer.visible && layer.opacity > 0; }
// Whether the layer shows tiles as they are.
bool is_unchanged(const TileLayer& layer) {
  return is_drawn(layer) && layer.opacity == 1 && layer.tint == Rgb{255, 255, 255};
}

class Flattener {
 public:
  Flattener(const Level& level, bool keeps_mirrors)
      : level_(level), keeps_mirrors_(keeps_mirrors), flat_(level) {
    const auto count = static_cast<std::size_t>(level.tile_count());
    for (std::size_t tile = 0; tile < count; ++tile) {
      const auto number = static_cast<TileNumber>(tile);
      is_blank_.push_back(is_blank(level_, number));
      counts_.push_back(shape_of_tile(level, number).kind != TileShape::Kind::none ||
                        is_ball_tile(level, number));
    }
  }

  FormatResult<FlatLevel> run() {
    flat_.layers = {};
    MapCells cells(level_.map.cells().size());
    LayerTiles tiles;
    for (std::size_t cell = 0; cell < cells.size(); ++cell) {
      tiles.clear();
      for (int layer = 0; layer < level_.layers.count(); ++layer) take(layer, cell, tiles);
      const std::size_t number = number_of(tiles);
      if (number >= kMaxTiles)
        return tl::unexpected(FormatError{"", "has more than " + std::to_string(kMaxTiles) +
                                                  " different tiles and stacks of tiles in its layers, but "
                                                  "this format has one layer"});
      const bool is_one = tiles.size() == 1 && is_kept(tiles.front());
      cells.set(cell, {static_cast<TileNumber>(number), is_one ? tiles.front().turn : TileTurn::none});
    }
    flat_.map.cells() = std::move(cells);
    if (auto made = add_tiles(); !made) return tl::unexpected(made.error());
    for (const TileLayer& layer : level_.layers.list) tell_drops(layer);
    tell_turns();
    return FlatLevel{std::move(flat_), std::move(dropped_)};
  }

 private:
  const TileLayer& layer(int index) const { return level_.layers.list[static_cast<std::size_t>(index)]; }

  void take(int index, std::size_t cell, LayerTiles& tiles) const {
    const auto [tile, turn] = level_.cells_of(index)[cell];
    const bool shows = is_drawn(layer(index)) && !is_blank_[tile];
    const bool is_ground = layer(index).is_ground && (counts_[tile] || level_.tile_flags(tile) != 0);
    if (shows || is_ground) tiles.push_back({index, tile, turn});
  }

  // Whether the tile stands for itself in any level with one layer.
  bool is_kept(const LayerTile& tile) const {
    const TileLayer& its = layer(tile.layer);
    const bool is_upright =
        tile.turn == TileTurn::none || (keeps_mirrors_ && !has_flip(tile.turn, TileTurn::diagonal));
    return is_upright && (is_unchanged(its) || is_blank_[tile.tile]) &&
           (its.is_ground || !counts_[tile.tile]);
  }

  std::size_t number_of(const LayerTiles& tiles) {
    if (tiles.size() == 1 && is_kept(tiles.front())) return tiles.front().tile;
    if (tiles.empty() && is_blank_[0] && !counts_[0]) return 0;
    const auto count = static_cast<std::size_t>(level_.tile_count());
    const auto [known, is_new] = numbers_.try_emplace(tiles, count + added_.size());
    if (is_new) added_.push_back(tiles);
    return known->second;
  }

  FormatResult<void> add_tiles() {
    if (added_.empty()) return {};
    Sheet& sheet = flat_.sheet(SheetId::tiles);
    const auto old = sheet.picture;
    const int old_columns = sheet.columns, count = level_.tile_count() + static_cast<int>(added_.size());
    flat_.set_tile_layout({std::max(old_columns, (count + kMaxSheetSide - 1) / kMaxSheetSide), count});
    const bool needs_picture =
        old != nullptr ||
        std::any_of(level_.layers.list.begin(), level_.layers.list.end(),
                    [](const TileLayer& its) { return is_drawn(its) && !is_unchanged(its); });
    for (std::size_t i = 0; i < added_.size(); ++i) {
      const std::size_t number = static_cast<std::size_t>(level_.tile_count()) + i;
      sheet.images[number] = image_of(added_[i]);
      set_physics(number, added_[i]);
    }
    return needs_picture ? add_picture() : FormatResult<void>();
  }

  // In 16 colours; colour 0 shows what is behind.
  TileImage image_of(const LayerTiles& tiles) const {
    TileImage image{};
    for (const LayerTile& tile : tiles) {
      if (!is_drawn(layer(tile.layer))) continue;
      const TileImage& its = level_.sheet(SheetId::tiles).images[tile.tile];
      for (int p = 0; p < kCartTileSize * kCartTileSize; ++p) {
        const Cell from = pixel_before_turn({p % kCartTileSize, p / kCartTileSize}, tile.turn, TileSize());
        const std::uint8_t color = its[static_cast<std::size_t>(from.y * kCartTileSize + from.x)];
        if (color != 0) image[static_cast<std::size_t>(p)] = color;
      }
    }
    return image;
  }

  // Flags of all, as far as they do not make ground of what is only drawn, and the shapes together.
  void set_physics(std::size_t number, const LayerTiles& tiles) {
    TileStack ground;
    FlagSet flags = 0;
    for (const LayerTile& tile : tiles) {
      const bool is_ground = layer(tile.layer).is_ground;
      if (is_ground || !counts_[tile.tile]) flags |= level_.tile_flags(tile.tile);
      if (is_ground && counts_[tile.tile]) ground.push_back({tile.tile, tile.turn});
    }
    flat_.sheet(SheetId::tiles).flags[number] = flags;
    const TileStack stacks[] = {ground};
    const auto stack = static_cast<TileNumber>(level_.tile_count());
    TileShape shape = ground.empty() ? TileShape() : shape_of_number(level_, stacks, stack);
    if (problem_of(shape, level_.map.tile_size())) {  // its flags would make other ground
      shape = {};
      flat_.sheet(SheetId::tiles).flags[number] = flags = 0;
    }
    if (shape != shape_of_flags(flat_, flags)) flat_.tile_shapes[number] = std::move(shape);
  }

  FormatResult<void> add_picture() {
    const TileSize size = level_.map.tile_size();
    Sheet& sheet = flat_.sheet(SheetId::tiles);
    const SheetLayout layout = sheet.layout();
    const std::int64_t width = std::int64_t{layout.columns} * size.width;
    const std::int64_t height = std::int64_t{layout.rows()} * size.height;
    if (width > kMaxSheetPictureSide || height > kMaxSheetPictureSide ||
        width * height > kMaxSheetPicturePixels)
      return tl::unexpected(FormatError{
          "",
          "has so many different stacks of tiles in its layers that their picture would be too large, "
          "but this format has one layer"});
    SheetPicture picture{static_cast<int>(width), static_cast<int>(height), {}};
    picture.rgba.resize(static_cast<std::size_t>(4 * width * height));
    for (int tile = 0; tile < layout.count; ++tile) {
      LayerTiles tiles{{-1, static_cast<TileNumber>(tile), TileTurn::none}};
      if (tile >= level_.tile_count()) tiles = added_[static_cast<std::size_t>(tile - level_.tile_count())];
      draw(tiles, layout.place_of(tile), picture);
    }
    sheet.picture = std::make_shared<const SheetPicture>(std::move(picture));
    return {};
  }

  // layer -1: as it is.
  void draw(const LayerTiles& tiles, Cell place, SheetPicture& picture) const {
    const TileSize size = level_.map.tile_size();
    for (const LayerTile& tile : tiles) {
      const TileLayer looks = tile.layer < 0 ? TileLayer() : layer(tile.layer);
      if (!is_drawn(looks)) continue;
      const TileSize turned_size = turned(size, tile.turn);
      const int top = top_of_turned(size, tile.turn);  // what is outside of the cell is cut off
      for (int y = std::max(0, top); y < size.height; ++y) {
        for (int x = 0; x < std::min(size.width, turned_size.width); ++x) {
          const auto at =
              (static_cast<std::size_t>(place.y * size.height + y) * static_cast<std::size_t>(picture.width) +
               static_cast<std::size_t>(place.x * size.width + x)) *
              4;
          const Cell from = pixel_before_turn({x, y - top}, tile.turn, size);
          put_over(pixel_of(tile.tile, from.x, from.y), looks, &picture.rgba[at]);
        }
      }
    }
  }

  std::array<std::uint8_t, 4> pixel_of(TileNumber tile, int x, int y) const {
    constexpr std::uint8_t kOpaque = 255;
    const Sheet& sheet = level_.sheet(SheetId::tiles);
    const TileSize size = level_.map.tile_size();
    if (sheet.picture == nullptr) {
      const std::uint8_t color = color_at(sheet.images[tile], size, x, y);
      const Rgb rgb = level_.palette[color];
      return {rgb.r, rgb.g, rgb.b, color == 0 ? std::uint8_t{0} : kOpaque};
    }
    const Cell place = sheet.layout().place_of(tile);
    const std::uint8_t* pixel = sheet.picture->at(place.x * size.width + x, place.y * size.height + y);
    return {pixel[0], pixel[1], pixel[2], pixel[3]};
  }

  // Porter and Duff's "over", with the layer's tint and opacity.
  static void put_over(const std::array<std::uint8_t, 4>& pixel, const TileLayer& looks,
                       std::uint8_t* under) {
    constexpr double kMax = 255;
    const double above = pixel[3] / kMax * looks.opacity, below = under[3] / kMax * (1 - above);
    const double both = above + below;
    const std::array<std::uint8_t, 3> tint = {looks.tint.r, looks.tint.g, looks.tint.b};
    if (both <= 0) return;
    for (std::size_t c = 0; c < tint.size(); ++c)
      under[c] = static_cast<std::uint8_t>(
          std::lround((pixel[c] * (tint[c] / kMax) * above + under[c] * below) / both));
    under[3] = static_cast<std::uint8_t>(std::lround(both * kMax));
  }

  void tell_turns() {
    const auto turned = std::count_if(added_.begin(), added_.end(), [](const LayerTiles& tiles) {
      return std::any_of(tiles.begin(), tiles.end(),
                         [](const LayerTile& tile) { return tile.turn != TileTurn::none; });
    });
    if (turned > 0)
      dropped_.push_back(
          "that cells turn their tiles: " + std::to_string(turned) +
          (turned == 1 ? " turned tile is a tile of its own" : " turned tiles are tiles of their own"));
  }

  void tell_drops(const TileLayer& its) {
    const std::string of = " of the layer " + quoted_name(its.name);
    if (!is_drawn(its)) return;
    if (its.offset != Vec2()) dropped_.push_back("the offset" + of);
    if (its.parallax != Vec2{1, 1}) dropped_.push_back("the parallax" + of);
  }

  const Level& level_;
  bool keeps_mirrors_;
  Level flat_;
  std::vector<bool> is_blank_, counts_;  // by tile
  std::map<LayerTiles, std::size_t> numbers_;
  std::vector<LayerTiles> added_;  // the tiles behind those of the level
  std::vector<std::string> dropped_;
};

}  // namespace

FormatResult<FlatLevel> flat_level(const Level& level, bool keeps_mirrors) {
  return Flattener(level, keeps_mirrors).run();
}

Level with_cart_tiles(Level level) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  if (level.tile_count() <= kCartTiles || sheet.columns != kCartColumns) return level;
  std::vector<bool> is_used(static_cast<std::size_t>(level.tile_count()));
  is_used[0] = true;
  for (const TileNumber tile : level.map.cells().tiles()) is_used[tile] = true;
  for (const TileNumber tile : level.auto_tiles.tiles) is_used[tile] = true;
  for (const Brush& brush : level.brushes)
    for (const MapCell cell : brush.tiles) is_used[cell.tile] = true;
  for (const auto& [tile, animation] : level.animations) {
    is_used[tile] = true;
    for (const AnimationFrame& frame : animation) is_used[frame.tile] = true;
  }
  for (const Spawn& spawn : level.spawns) {
    if (spawn.picture.sheet != SheetId::tiles) continue;
    for (const int tile : images_of(spawn.picture, sheet.layout()))
      is_used[static_cast<std::size_t>(tile)] = true;
  }
  std::vector<int> numbers(is_used.size());
  int free = 0;
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    const auto at = static_cast<std::size_t>(tile);
    numbers[at] = tile;
    if (tile < kCartTiles) continue;
    const auto is_free = [&](int number) {
      const auto i = static_cast<std::size_t>(number);
      return !is_used[i] && sheet.images[i] == TileImage{} && sheet.flags[i] == 0 &&
             level.tile_shapes[i].kind == TileShape::Kind::none;
    };
    while (free < kCartTiles && !is_free(free)) ++free;
    if (free == kCartTiles) return level;
    numbers[static_cast<std::size_t>(free)] = -1;
    numbers[at] = free++;
  }
  renumber_tiles(level, {}, numbers);
  return level;
}

}  // namespace talus
