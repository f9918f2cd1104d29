// Finds the sources of tiles.
#include "picture_tiles.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "tile_color.h"
#include "tile_look.h"

namespace talus {
namespace {

// The tiles of a tileset whose picture is a file.
void add_linked_tiles(const Level& level, const Tileset& set, PictureTiles& found) {
  const SheetLayout layout = level.sheet(SheetId::tiles).layout();
  const TileCut& cut = set.link->cut;
  const int file = found.file_at(set.link->path, std::nullopt);
  for (int tile = set.first; tile < set.first + set.count; ++tile) {
    const Cell place{(tile - set.first) % layout.columns, (tile - set.first) / layout.columns};
    if (place.x >= set.columns) continue;
    TileSource& source = found.tiles[static_cast<std::size_t>(tile)];
    source.file = file;
    source.part = {cut.margin + place.x * (cut.tile.width + cut.spacing),
                   cut.margin + place.y * (cut.tile.height + cut.spacing), cut.tile.width, cut.tile.height};
    source.corner = {cut.offset_x, cut.offset_y};
    if (set.link->is_missing)
      source.problem = "its picture is missing";
    else if (cut.tile != level.map.tile_size())
      source.problem = "its tileset has tiles of another size than the map";
    if (source.problem != nullptr) source.file = -1;
  }
}

}  // namespace

std::optional<Cell> TileSource::pixel_at(int x, int y) const {
  const int in_x = x - corner.x, in_y = y - corner.y;
  if (file < 0 || in_x < 0 || in_y < 0 || in_x >= part.w || in_y >= part.h) return std::nullopt;
  return Cell{part.x + (flips_x ? part.w - 1 - in_x : in_x), part.y + (flips_y ? part.h - 1 - in_y : in_y)};
}

TileSource PictureTiles::of(int tile) const {
  return tile < static_cast<int>(tiles.size()) ? tiles[static_cast<std::size_t>(tile)] : TileSource();
}

int PictureTiles::file_at(const std::string& path, const std::optional<Rgb>& transparent) {
  const auto found = std::find_if(files.begin(), files.end(), [&](const PictureFile& file) {
    return file.path == path && file.transparent == transparent;
  });
  if (found != files.end()) return static_cast<int>(found - files.begin());
  files.push_back({path, transparent});
  return static_cast<int>(files.size()) - 1;
}

std::shared_ptr<const PictureTiles> picture_tiles_of(const Level& level) {
  if (level.tiled && level.tiled->pictures) return level.tiled->pictures;
  if (level.ldtk && level.ldtk->pictures) return level.ldtk->pictures;
  PictureTiles found;
  for (const Tileset& set : level.tilesets) {
    if (!set.link) continue;
    found.tiles.resize(static_cast<std::size_t>(level.tile_count()));
    add_linked_tiles(level, set, found);
  }
  return std::make_shared<const PictureTiles>(std::move(found));
}

std::vector<std::uint8_t> shown_rgba(const Level& level, int tile) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  TileLook look = look_of(sheet, size, tile);
  if (sheet.picture != nullptr) return std::move(look.rgba);
  std::vector<std::uint8_t> rgba;
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      constexpr std::uint8_t kOpaque = 255;
      const std::uint8_t color = color_at(look.image, size, x, y);
      const Rgb rgb = color == 0 ? Rgb() : level.palette[color];
      rgba.insert(rgba.end(), {rgb.r, rgb.g, rgb.b, color == 0 ? std::uint8_t{0} : kOpaque});
    }
  }
  return rgba;
}

}  // namespace talus
