#include "tile_renumber.h"

#include <algorithm>
#include <cassert>
#include <memory>
#include <utility>

namespace talus {
namespace {

// The pictures of the tiles at their new places.
std::shared_ptr<const SheetPicture> moved_picture(const SheetPicture& before, TileSize tile,
                                                  const SheetLayout& from, const SheetLayout& to,
                                                  const std::vector<int>& numbers) {
  auto after = std::make_shared<SheetPicture>();
  after->width = to.columns * tile.width;
  after->height = to.rows() * tile.height;
  after->rgba.resize(4 * static_cast<std::size_t>(after->width) * static_cast<std::size_t>(after->height));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (numbers[i] < 0) continue;
    const Cell source = from.place_of(static_cast<int>(i)), place = to.place_of(numbers[i]);
    for (int y = 0; y < tile.height; ++y) {
      const std::size_t row =
          static_cast<std::size_t>(place.y * tile.height + y) * static_cast<std::size_t>(after->width);
      std::copy_n(before.at(source.x * tile.width, source.y * tile.height + y), 4 * tile.width,
                  &after->rgba[4 * (row + static_cast<std::size_t>(place.x * tile.width))]);
    }
  }
  return after;
}

// Frames whose first tile goes, go with it.
BodyFrames renumbered(BodyFrames frames, const std::vector<int>& numbers) {
  if (frames.first >= numbers.size() || numbers[frames.first] < 0) return {};
  return {static_cast<TileNumber>(numbers[frames.first]), frames.count};
}

template <class Values>
Values moved(const Values& before, int count, const std::vector<int>& numbers) {
  Values after(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (numbers[i] >= 0) after[static_cast<std::size_t>(numbers[i])] = before[i];
  return after;
}

}  // namespace

void renumber_tiles(Level& level, const SheetLayout& layout, const std::vector<int>& numbers) {
  assert(static_cast<int>(numbers.size()) == level.tile_count());
  Sheet& sheet = level.sheet(SheetId::tiles);
  const auto picture = std::exchange(sheet.picture, nullptr);
  if (picture != nullptr)
    sheet.picture = moved_picture(*picture, level.map.tile_size(), sheet.layout(), layout, numbers);
  sheet.images = moved(sheet.images, layout.count, numbers);
  sheet.flags = moved(sheet.flags, layout.count, numbers);
  sheet.columns = layout.columns;
  level.tile_shapes = moved(level.tile_shapes, layout.count, numbers);
  level.tilesets.clear();
  TileAnimations animations;
  for (auto& [tile, animation] : level.animations) {
    for (AnimationFrame& frame : animation)
      frame.tile = static_cast<TileNumber>(std::max(0, numbers[frame.tile]));
    if (numbers[tile] >= 0) animations[static_cast<TileNumber>(numbers[tile])] = std::move(animation);
  }
  level.animations = std::move(animations);
  LargeTiles large_tiles;
  for (auto& [tile, large] : level.large_tiles)
    if (numbers[tile] >= 0) large_tiles[static_cast<TileNumber>(numbers[tile])] = std::move(large);
  level.large_tiles = std::move(large_tiles);
  TileNotes notes;
  for (auto& [tile, note] : level.tile_notes)
    if (numbers[tile] >= 0) notes[static_cast<TileNumber>(numbers[tile])] = std::move(note);
  level.tile_notes = std::move(notes);
  const auto renumber_one = [&](TileNumber& tile) {
    tile = static_cast<TileNumber>(std::max(0, numbers[tile]));
  };
  const auto renumber = [&](auto& tiles) { std::for_each(tiles.begin(), tiles.end(), renumber_one); };
  renumber(level.map.cells().tiles());
  for (TileLayer& layer : level.layers.list) {
    if (layer.cells == nullptr) continue;
    MapCells cells = *layer.cells;
    renumber(cells.tiles());
    layer.cells = std::make_shared<const MapCells>(std::move(cells));
  }
  for (Brush& brush : level.brushes)
    for (MapCell& cell : brush.tiles) renumber_one(cell.tile);
  for (Spawn& spawn : level.spawns)
    for (BodyFrames& frames : spawn.picture.acts)
      if (spawn.picture.sheet == SheetId::tiles && frames.count > 0) frames = renumbered(frames, numbers);
  renumber(level.auto_tiles.tiles);
}

}  // namespace talus
