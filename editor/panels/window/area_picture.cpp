#include "area_picture.h"

#include <algorithm>
#include <cmath>

#include "export/map_png.h"
#include "formats/pictures/png_picture.h"
#include "level/resize.h"
#include "panels/canvas/opening_area.h"

namespace talus {
namespace {

// The level without its bodies, and nothing but an area of whole cells.
Level cut_to_area(const Level& level, const Rect& area) {
  const TileSize tile = level.map.tile_size();
  const auto cells = [](double length, int side) { return static_cast<int>(std::lround(length / side)); };
  ResizedMap part = resized(level, {.width = cells(area.w, tile.width),
                                    .height = cells(area.h, tile.height),
                                    .shift = {-cells(area.x, tile.width), -cells(area.y, tile.height)}});
  Level cut = level;
  cut.map = std::move(part.map);
  cut.layers = std::move(part.layers);
  cut.objects = std::move(part.objects);
  cut.spawns.clear();
  cut.curves.clear();
  Sheet& sheet = cut.sheet(SheetId::tiles);
  for (int number = 0; number < sheet.count(); ++number)
    if (is_ball_tile(level, static_cast<TileNumber>(number)))
      sheet.images[static_cast<std::size_t>(number)].fill(0);
  return cut;
}

}  // namespace

Rect area_of_cells(const Rect& area, const TileMap& map) {
  const Cell from = map.cell_at({area.x, area.y});
  const TileSize tile = map.tile_size();
  const double left = std::max(0, from.x) * tile.width, top = std::max(0, from.y) * tile.height;
  const auto up = [](double length, int side) { return std::ceil(length / side) * side; };
  return {left, top, std::min(up(area.right() - left, tile.width), map.px_width() - left),
          std::min(up(area.bottom() - top, tile.height), map.px_height() - top)};
}

std::shared_ptr<const SheetPicture> picture_of_area(const Level& level, const Rect& area) {
  const auto png = map_png(cut_to_area(level, area), {}, kMaxPictureInside);
  if (!png) return nullptr;
  const auto picture = read_rgba(*png, kMaxSheetPictureSide);
  return picture ? shared_picture(*picture) : nullptr;
}

std::shared_ptr<const SheetPicture> picture_of_start(const Level& level, const State& state, int most_width,
                                                     int most_height) {
  const TileSize tile = level.map.tile_size();
  const Vec2 middle = opening_area(level, state).area.center();
  const auto along = [](double at, int most, int side, double whole) {
    const double length = std::min(whole, static_cast<double>(std::max(most / side, 1) * side));
    const double from = std::clamp(at - length / 2, 0.0, whole - length);
    return std::pair(std::floor(from / side) * side, length);
  };
  const auto [x, w] = along(middle.x, most_width, tile.width, level.map.px_width());
  const auto [y, h] = along(middle.y, most_height, tile.height, level.map.px_height());
  return picture_of_area(level, {x, y, w, h});
}

}  // namespace talus
