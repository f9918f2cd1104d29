#include "new_tileset.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <talus/level/tuning.h>
#include "../../level/tile_color.h"
#include "../../level/tile_renumber.h"
#include "../files/atomic_file.h"
#include "../import/linked_files.h"
#include "../import/sheet_images.h"
#include "../pictures/any_picture.h"
#include "../text/utf8_text.h"
#include "tile_cut.h"
#include "tileset_pixels.h"

namespace talus {
namespace {

tl::unexpected<FormatError> too_many_tiles(const SheetLayout& layout) {
  return tl::unexpected(FormatError{
      "", "would have a sheet of " + std::to_string(layout.columns) + "x" + std::to_string(layout.rows()) +
              " tiles, but a level has only 65536, in up to 2048 columns and rows"});
}

bool is_possible(const SheetLayout& layout) {
  return layout.columns <= kMaxSheetSide && layout.rows() <= kMaxSheetSide && layout.count <= kMaxTiles;
}

Tileset tileset_of(const TilePicture& tiles, const CutGrid& grid, int first, int columns) {
  Tileset set;
  set.name = printable(tiles.name);
  set.first = first;
  set.count = (grid.rows - 1) * columns + grid.columns;
  set.columns = grid.columns;
  if (!tiles.link.empty()) set.link = TilesetLink{tiles.link, tiles.cut};
  return set;
}

// Of the images of 8x8 px that stand for the tiles of a picture in true colour.
SheetPicture small_pictures(const Level& level) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize tile = level.map.tile_size();
  SheetPicture small{sheet.columns * kCartTileSize, sheet.layout().rows() * kCartTileSize, {}};
  small.rgba.reserve(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const std::uint8_t* pixel =
          sheet.picture->at(pixel_of_side(x, tile.width), pixel_of_side(y, tile.height));
      small.rgba.insert(small.rgba.end(), pixel, pixel + 4);
    }
  }
  return small;
}

}  // namespace

FormatResult<TileFile> read_tile_picture(const std::string& path) {
  const auto bytes = read_file(path);
  if (!bytes) return tl::unexpected(bytes.error());
  auto picture = read_picture(*bytes, kMaxLinkedPictureSide);
  if (!picture) return tl::unexpected(picture.error());
  TileFile file{*std::move(picture), {}};
  const auto chunk = find_png_chunk(*bytes, "PLTE");
  for (std::size_t i = 0; chunk && i + 3 <= chunk->size(); i += 3)
    file.palette.push_back({static_cast<std::uint8_t>((*chunk)[i]),
                            static_cast<std::uint8_t>((*chunk)[i + 1]),
                            static_cast<std::uint8_t>((*chunk)[i + 2])});
  return file;
}

FormatResult<Level> level_of_tiles(const TilePicture& tiles, int width, int height) {
  const CutGrid grid = grid_of(tiles.cut, tiles.picture.width, tiles.picture.height);
  const bool has_blank = is_clear_tile(tiles.picture, tiles.cut, {0, 0});
  const int first = has_blank ? 0 : grid.columns;
  const SheetLayout layout{grid.columns, first + grid.count()};
  if (!is_possible(layout)) return too_many_tiles(layout);
  Level level;
  level.map = TileMap(width, height, tiles.cut.tile);
  level.tuning = new_tuning(tiles.cut.tile);
  level.set_tile_layout(layout);
  level.tilesets = {tileset_of(tiles, grid, first, grid.columns)};
  const ShownTileset shown{0, tiles.cut, &tiles.picture};
  if (const auto drawn = draw_tilesets({&shown, 1}, level); !drawn) return tl::unexpected(drawn.error());
  put_images(small_pictures(level), tiles.palette, level);
  const bool is_in_16_colours = images_show(*level.sheet(SheetId::tiles).picture, level);
  if (tiles.link.empty() && is_in_16_colours) level.sheet(SheetId::tiles).picture = nullptr;
  return level;
}

FormatResult<Level> with_tileset(Level level, const TilePicture& tiles) {
  const CutGrid grid = grid_of(tiles.cut, tiles.picture.width, tiles.picture.height);
  const SheetLayout before = level.sheet(SheetId::tiles).layout();
  const int columns = std::max(before.columns, grid.columns);
  const int first = before.rows() * columns;
  const SheetLayout after{columns, first + (grid.rows - 1) * columns + grid.columns};
  if (!is_possible(after)) return too_many_tiles(after);
  std::vector<int> numbers;
  numbers.reserve(static_cast<std::size_t>(before.count));
  for (int tile = 0; tile < before.count; ++tile) numbers.push_back(after.tile_at(before.place_of(tile)));
  std::vector<Tileset> sets = std::exchange(level.tilesets, {});
  for (Tileset& set : sets) {
    const int last = after.tile_at(before.place_of(set.first + set.count - 1));
    set.first = after.tile_at(before.place_of(set.first));
    set.count = last - set.first + 1;
  }
  renumber_tiles(level, after, numbers);
  sets.push_back(tileset_of(tiles, grid, first, columns));
  level.tilesets = std::move(sets);
  const ShownTileset shown{static_cast<int>(level.tilesets.size()) - 1, tiles.cut, &tiles.picture};
  if (const auto drawn = draw_tilesets({&shown, 1}, level); !drawn) return tl::unexpected(drawn.error());
  return level;
}

Level without_tileset(Level level, std::size_t index) {
  std::vector<Tileset> sets = std::exchange(level.tilesets, {});
  const Tileset gone = sets[index];
  const SheetLayout before = level.sheet(SheetId::tiles).layout();
  sets.erase(sets.begin() + static_cast<std::ptrdiff_t>(index));
  // Whole rows close up; a part of a row stays blank. Tile 0 stays in any case, as the empty one.
  const int first_row = before.place_of(gone.first).y, last = gone.first + gone.count - 1;
  const int next = index < sets.size() ? sets[index].first : before.count;
  const bool fills_rows = before.place_of(gone.first).x == 0 && first_row > 0 &&
                          before.place_of(std::min(next, before.count - 1)).y > before.place_of(last).y;
  const bool is_last = last == before.count - 1 && before.place_of(gone.first).x == 0 && first_row > 0;
  const int rows = before.place_of(last).y - first_row + 1;
  const int shift = fills_rows || is_last ? rows * before.columns : 0;
  std::vector<int> numbers;
  for (int tile = 0; tile < before.count; ++tile) {
    const bool goes = tile >= gone.first && tile <= last;
    const bool is_cut = shift > 0 && tile >= gone.first && tile < gone.first + shift;
    numbers.push_back(goes || is_cut ? -1 : tile > last ? tile - shift : tile);
  }
  const int count = is_last ? gone.first : before.count - shift;
  renumber_tiles(level, {before.columns, count}, numbers);
  for (Tileset& set : sets)
    if (set.first > last) set.first -= shift;
  level.tilesets = std::move(sets);
  return level;
}

}  // namespace talus
