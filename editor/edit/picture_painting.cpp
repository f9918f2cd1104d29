// Fits edits to parts of pictures.
#include "picture_painting.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace talus {
namespace {

constexpr std::size_t kBytes = 4;  // of a pixel

// The tile of the map that a change paints; -1: it paints none.
int painted_tile(const Change& change) {
  if (const auto* pixel = std::get_if<PixelChange>(&change))
    return pixel->sheet == SheetId::tiles ? pixel->tile : -1;
  if (const auto* look = std::get_if<TileLookChange>(&change))
    return look->sheet == SheetId::tiles ? look->tile : -1;
  return -1;
}

std::size_t byte_at(TileSize size, int x, int y) {
  return kBytes * static_cast<std::size_t>(y * size.width + x);
}

// What lies beside the part stays as it was.
void keep_outside(const TileSource& source, const PictureFile& file, TileSize size, TileLookChange& change) {
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::size_t at = byte_at(size, x, y);
      std::uint8_t* const pixel = &change.after.rgba[at];
      const std::uint8_t* const before = &change.before.rgba[at];
      if (std::equal(pixel, pixel + kBytes, before)) continue;
      if (!source.pixel_at(x, y)) std::copy_n(before, kBytes, pixel);
      if (file.transparent == Rgb{pixel[0], pixel[1], pixel[2]} && pixel[3] != 0) pixel[2] ^= 1;
    }
  }
}

// The pixel of a tile that shows this one of the picture.
std::optional<Cell> shown_at(const TileSource& source, Cell pixel, TileSize size) {
  const CellRect& part = source.part;
  const int in_x = pixel.x - part.x, in_y = pixel.y - part.y;
  const Cell at{source.corner.x + (source.flips_x ? part.w - 1 - in_x : in_x),
                source.corner.y + (source.flips_y ? part.h - 1 - in_y : in_y)};
  const bool is_inside = at.x >= 0 && at.y >= 0 && at.x < size.width && at.y < size.height;
  return is_inside ? std::optional(at) : std::nullopt;
}

// The change of a tile in an edit, which is added if there is none.
TileLookChange& change_of(const Level& level, int tile, Edit& edit) {
  for (Change& change : edit.changes) {
    auto* const look = std::get_if<TileLookChange>(&change);
    if (look != nullptr && look->sheet == SheetId::tiles && look->tile == tile) return *look;
  }
  TileLook now = look_of(level.sheet(SheetId::tiles), level.map.tile_size(), tile);
  edit.changes.emplace_back(TileLookChange{SheetId::tiles, tile, now, now});
  return std::get<TileLookChange>(edit.changes.back());
}

// Paints what is painted on a tile also on another one that shows the same part.
void paint_other(const Level& level, int tile, const TileSource& source, const TileLookChange& painted,
                 const TileSource& painted_source, Edit& edit) {
  const TileSize size = level.map.tile_size();
  TileLookChange& change = change_of(level, tile, edit);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto pixel = source.pixel_at(x, y);
      const auto from = pixel ? shown_at(painted_source, *pixel, size) : std::nullopt;
      if (!from) continue;
      const std::size_t at = byte_at(size, from->x, from->y);
      const std::uint8_t* const after = &painted.after.rgba[at];
      if (!std::equal(after, after + kBytes, &painted.before.rgba[at]))
        std::copy_n(after, kBytes, &change.after.rgba[byte_at(size, x, y)]);
    }
  }
  change.after.image = image_of(change.after.rgba, size, level.palette);
}

void paint_others(const Level& level, const PictureTiles& pictures, const TileLookChange& painted,
                  Edit& edit) {
  const TileSource source = pictures.of(painted.tile);
  const int count = std::min(static_cast<int>(pictures.tiles.size()), level.tile_count());
  for (int tile = 0; tile < count; ++tile) {
    const TileSource& other = pictures.tiles[static_cast<std::size_t>(tile)];
    if (tile != painted.tile && other.file == source.file && other.part == source.part)
      paint_other(level, tile, other, painted, source, edit);
  }
}

}  // namespace

bool paints_tiles(const Edit& edit) {
  return std::any_of(edit.changes.begin(), edit.changes.end(),
                     [](const Change& change) { return painted_tile(change) >= 0; });
}

tl::expected<std::vector<std::string>, std::string> files_painted(const PictureTiles& pictures,
                                                                  const Edit& edit) {
  std::vector<std::string> paths;
  for (const Change& change : edit.changes) {
    const int tile = painted_tile(change);
    const TileSource source = tile < 0 ? TileSource() : pictures.of(tile);
    if (source.problem != nullptr)
      return tl::unexpected("Tile " + std::to_string(tile) + " cannot be painted: " + source.problem + ".");
    if (source.file < 0) continue;
    const std::string& path = pictures.files[static_cast<std::size_t>(source.file)].path;
    if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
  }
  return paths;
}

Edit fitted_to_pictures(const Level& level, const PictureTiles& pictures, const Edit& edit) {
  Edit fitted = edit;
  const TileSize size = level.map.tile_size();
  for (Change& change : fitted.changes) {
    auto* const look = std::get_if<TileLookChange>(&change);
    const TileSource source = look == nullptr ? TileSource() : pictures.of(look->tile);
    if (look == nullptr || look->sheet != SheetId::tiles || source.file < 0) continue;
    keep_outside(source, pictures.files[static_cast<std::size_t>(source.file)], size, *look);
    look->after.image = image_of(look->after.rgba, size, level.palette);
  }
  const std::vector<Change> changes = fitted.changes;
  for (const Change& change : changes) {
    const auto* const look = std::get_if<TileLookChange>(&change);
    if (look != nullptr && look->sheet == SheetId::tiles && pictures.of(look->tile).file >= 0)
      paint_others(level, pictures, *look, fitted);
  }
  return fitted;
}

}  // namespace talus
