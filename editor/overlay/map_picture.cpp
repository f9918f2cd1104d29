// Drawing of the map from afar.
#include "map_picture.h"

#include <algorithm>
#include <cassert>

namespace talus {
namespace {

constexpr int kSamples = 4;  // cells along each side of a block that are looked at

Rgb main_color(const TileImage& image, const Palette& palette) {
  std::array<int, kColorCount> counts{};
  for (const std::uint8_t pixel : image) ++counts[pixel];
  return palette[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

Rgb mixed(Rgb color, Rgb tint) {
  const auto channel = [](int a, int b) {
    return static_cast<std::uint8_t>((a * (100 - kTintPercent) + b * kTintPercent) / 100);
  };
  return {channel(color.r, tint.r), channel(color.g, tint.g), channel(color.b, tint.b)};
}

struct Sum {
  int r = 0, g = 0, b = 0, count = 0;
  void add(Rgb color) {
    r += color.r;
    g += color.g;
    b += color.b;
    ++count;
  }
};

// Of the cells of a block that are on the map.
Sum sum_of_block(const TileMap& map, const TileColors& colors, Cell from, int block) {
  Sum sum;
  const int step = std::max(1, block / kSamples);
  const int right = std::min(from.x + block, map.width()), bottom = std::min(from.y + block, map.height());
  for (Cell cell{from.x, from.y}; cell.y < bottom; cell.y += step) {
    for (cell.x = from.x; cell.x < right; cell.x += step) sum.add(colors[map.at(cell)]);
  }
  return sum;
}

}  // namespace

TileColors tile_colors(const Level& level, const MapLook& look) {
  TileColors colors;
  const Sheet& sheet = level.sheet(SheetId::tiles);
  for (std::size_t tile = 0; tile < kTileCount; ++tile) {
    const bool hidden = look.hide_balls && role_of(sheet.flags[tile], level.roles) == TileRole::ball;
    colors[tile] = main_color(sheet.images[hidden ? 0 : tile], level.palette);
    if (look.tinted && look.tinted->matches(sheet.flags[tile])) colors[tile] = mixed(colors[tile], look.tint);
  }
  return colors;
}

std::vector<std::uint8_t> map_picture(const TileMap& map, const TileColors& colors, Cell from, int block,
                                      int width, int height) {
  assert(block >= 1 && block <= kMaxBlock);
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  // In blocks, so that no number overflows beyond the map.
  const int columns = std::min(width, (map.width() - from.x + block - 1) / block);
  const int rows = std::min(height, (map.height() - from.y + block - 1) / block);
  for (int y = 0; y < rows; ++y) {
    std::uint8_t* out = &rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * 4];
    for (int x = 0; x < columns; ++x, out += 4) {
      const Sum sum = sum_of_block(map, colors, {from.x + x * block, from.y + y * block}, block);
      out[0] = static_cast<std::uint8_t>(sum.r / sum.count);
      out[1] = static_cast<std::uint8_t>(sum.g / sum.count);
      out[2] = static_cast<std::uint8_t>(sum.b / sum.count);
      out[3] = 255;
    }
  }
  return rgba;
}

}  // namespace talus
