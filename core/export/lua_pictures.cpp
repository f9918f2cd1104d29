#include "lua_pictures.h"

#include <algorithm>

#include <talus/level/placed_picture.h>
#include "../formats/native/native_pictures.h"

namespace talus {
namespace {

std::size_t shown_parts(const Level& level) {
  std::size_t count = level.large_tiles.size() + turned_large_tiles(level).size();
  for (const ObjectLayer& layer : level.objects)
    count += drawn_pictures(layer).size() + (layer.image && layer.image->part.picture ? 1 : 0);
  return count;
}

void copy_into(const SheetPicture& from, Cell corner, SheetPicture& to) {
  const auto row = 4 * static_cast<std::size_t>(from.width);
  for (int y = 0; y < from.height; ++y) {
    const auto at = static_cast<std::size_t>(corner.y + y) * static_cast<std::size_t>(to.width) +
                    static_cast<std::size_t>(corner.x);
    std::copy_n(&from.rgba[row * static_cast<std::size_t>(y)], row, &to.rgba[4 * at]);
  }
}

}  // namespace

std::set<std::pair<TileNumber, TileTurn>> turned_large_tiles(const Level& level) {
  std::set<std::pair<TileNumber, TileTurn>> turned;
  for (int layer = 0; layer < level.layers.count() && !level.large_tiles.empty(); ++layer) {
    const MapCells& cells = level.cells_of(layer);
    for (std::size_t i = 0; cells.has_turned() && i < cells.size(); ++i) {
      const auto [tile, turn] = cells[i];
      if (turn != TileTurn::none && level.large_tiles.contains(tile)) turned.emplace(tile, turn);
    }
  }
  return turned;
}

bool has_pictures(const Level& level) { return shown_parts(level) > 0; }

std::optional<LuaPictures> lua_pictures(const Level& level) {
  constexpr int kUsualWidth = 2048;  // px
  if (const std::size_t count = shown_parts(level); count == 0 || count > kMaxLuaPictures) return {};
  const NativePictures all = pictures_of(level);
  LuaPictures made;
  int width = 0;
  for (const auto& picture : all) width = std::max(width, picture->width);
  made.picture.width = std::max(width, kUsualWidth);
  Cell corner;  // of the next one; each row is as high as the highest in it
  int bottom = 0;
  for (const auto& picture : all) {
    if (corner.x + picture->width > made.picture.width) corner = {0, bottom};
    made.corners[picture.get()] = corner;
    corner.x += picture->width;
    bottom = std::max(bottom, corner.y + picture->height);
    if (bottom > kMaxSheetPictureSide || std::int64_t{bottom} * made.picture.width > kMaxSheetPicturePixels)
      return {};
  }
  made.picture.height = bottom;
  made.picture.rgba.resize(4 * static_cast<std::size_t>(made.picture.width) *
                           static_cast<std::size_t>(bottom));
  for (const auto& picture : all) copy_into(*picture, made.corners[picture.get()], made.picture);
  return made;
}

}  // namespace talus
