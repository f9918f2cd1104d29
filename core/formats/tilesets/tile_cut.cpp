#include "tile_cut.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

namespace talus {
namespace {

using Pixel = std::array<std::uint8_t, 4>;

Pixel pixel_of(const RgbaPicture& picture, int x, int y) {
  const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                              static_cast<std::size_t>(x));
  Pixel pixel;
  std::memcpy(pixel.data(), picture.bytes.data() + at, pixel.size());
  return pixel[3] == 0 ? Pixel{} : pixel;
}

bool is_gap_in_range(int gap) { return gap >= 0 && gap <= kMaxTileGap; }
bool is_offset_in_range(int offset) { return offset >= -kMaxTileGap && offset <= kMaxTileGap; }

bool fits_exactly(const TileCut& cut, int width, int height) {
  const CutGrid grid = grid_of(cut, width, height);
  return grid.columns > 0 && grid.rows > 0 && grid.rest_x == cut.margin && grid.rest_y == cut.margin;
}

// By x or y: whether it lies between two tiles or around them.
std::vector<bool> gaps_along(int length, int side, const TileCut& cut) {
  std::vector<bool> gaps;
  for (int i = 0; i < length; ++i) {
    const int in_tiles = i - cut.margin;
    gaps.push_back(in_tiles < 0 || i >= length - cut.margin || in_tiles % (side + cut.spacing) >= side);
  }
  return gaps;
}

// Whether all pixels between the tiles are alike, and some within them are not.
bool has_visible_gaps(const RgbaPicture& picture, const TileCut& cut) {
  const std::vector<bool> columns = gaps_along(picture.width, cut.tile.width, cut);
  const std::vector<bool> rows = gaps_along(picture.height, cut.tile.height, cut);
  std::optional<Pixel> gap;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      if (!columns[static_cast<std::size_t>(x)] && !rows[static_cast<std::size_t>(y)]) continue;
      const Pixel pixel = pixel_of(picture, x, y);
      if (gap && *gap != pixel) return false;
      gap = pixel;
    }
  }
  // Tiles that all have a border of that colour would look the same without gaps.
  const auto is_tile_side = [&](int i, const std::vector<bool>& gaps) {
    const auto at = static_cast<std::size_t>(i);
    return !gaps[at] && ((i > 0 && gaps[at - 1]) || (at + 1 < gaps.size() && gaps[at + 1]));
  };
  for (int x = 0; gap && x < picture.width; ++x) {
    if (!is_tile_side(x, columns)) continue;
    for (int y = 0; y < picture.height; ++y)
      if (!rows[static_cast<std::size_t>(y)] && pixel_of(picture, x, y) != *gap) return true;
  }
  return false;
}

}  // namespace

CutGrid grid_of(const TileCut& cut, int width, int height) {
  const auto along = [&](int length, int side) {
    if (side < 1 || cut.spacing < 0) return 0;
    return std::max(0, (length - cut.margin + cut.spacing) / (side + cut.spacing));
  };
  const auto rest = [&](int length, int side, int count) {
    return count == 0 ? length : length - cut.margin - count * side - (count - 1) * cut.spacing;
  };
  CutGrid grid{along(width, cut.tile.width), along(height, cut.tile.height)};
  grid.rest_x = rest(width, cut.tile.width, grid.columns);
  grid.rest_y = rest(height, cut.tile.height, grid.rows);
  return grid;
}

std::string problem_of(const TileCut& cut, int width, int height) {
  if (!is_tile_size(cut.tile))
    return "A tile must be 1 to " + std::to_string(kMaxTileSide) + " px wide and high.";
  if (!is_gap_in_range(cut.spacing) || !is_gap_in_range(cut.margin))
    return "Spacing and margin must be 0 to " + std::to_string(kMaxTileGap) + " px.";
  if (!is_offset_in_range(cut.offset_x) || !is_offset_in_range(cut.offset_y))
    return "The offset must be at most " + std::to_string(kMaxTileGap) + " px to either side.";
  const CutGrid grid = grid_of(cut, width, height);
  if (grid.columns == 0 || grid.rows == 0)
    return "No tile of this size fits into the picture of " + std::to_string(width) + "x" +
           std::to_string(height) + " px.";
  if (grid.columns > kMaxSheetSide || grid.rows > kMaxSheetSide)
    return "The picture has " + std::to_string(grid.columns) + "x" + std::to_string(grid.rows) +
           " tiles, but a level has at most " + std::to_string(kMaxSheetSide) + " columns and rows of them.";
  if (grid.count() > kMaxTiles)
    return "The picture has " + std::to_string(grid.count()) + " tiles, but a level has at most " +
           std::to_string(kMaxTiles) + ".";
  return "";
}

TileCut guess_cut(const RgbaPicture& picture, TileSize wanted) {
  std::vector<TileSize> sizes = {wanted};
  for (const int side : {16, 32, 8, 24, 18, 48, 64, 12, 20, 40, 70, 128}) sizes.push_back({side, side});
  for (const TileSize size : sizes) {
    for (const int spacing : {1, 2, 4}) {
      for (const int margin : {0, 1, 2, 4}) {
        const TileCut cut{size, spacing, margin};
        if (fits_exactly(cut, picture.width, picture.height) && has_visible_gaps(picture, cut)) return cut;
      }
    }
  }
  for (const TileSize size : sizes)
    if (fits_exactly({size}, picture.width, picture.height)) return {size};
  return {{std::min(wanted.width, picture.width), std::min(wanted.height, picture.height)}};
}

bool is_clear_tile(const RgbaPicture& picture, const TileCut& cut, Cell place) {
  const int left = cut.margin + place.x * (cut.tile.width + cut.spacing);
  const int top = cut.margin + place.y * (cut.tile.height + cut.spacing);
  for (int y = top; y < top + cut.tile.height; ++y)
    for (int x = left; x < left + cut.tile.width; ++x)
      if (pixel_of(picture, x, y)[3] != 0) return false;
  return true;
}

}  // namespace talus
