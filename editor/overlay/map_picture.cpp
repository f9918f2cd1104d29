// Draws the map when it is zoomed far out.
#include "map_picture.h"

#include <algorithm>
#include <cassert>

#include "level/tile_color.h"

namespace talus {
namespace {

Rgb main_color(const TileImage& image, const Palette& palette) {
  std::array<int, kColorCount> counts{};
  for (const std::uint8_t pixel : image) ++counts[pixel];
  return palette[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

// The mean of some pixels of a tile in true colour: there may be 16 million in all.
Rgb mean_color(const Level& level, TileNumber tile) {
  constexpr int kAlong = 4;  // pixels along each side
  const TileSize size = level.map.tile_size();
  int r = 0, g = 0, b = 0;
  for (int i = 0; i < kAlong * kAlong; ++i) {
    const Rgb color = color_on_map(level, tile, (2 * (i % kAlong) + 1) * size.width / (2 * kAlong),
                                   (2 * (i / kAlong) + 1) * size.height / (2 * kAlong));
    r += color.r, g += color.g, b += color.b;
  }
  const auto mean = [](int sum) { return static_cast<std::uint8_t>(sum / (kAlong * kAlong)); };
  return {mean(r), mean(g), mean(b)};
}

Rgb mixed(Rgb color, Rgb tint) {
  const auto channel = [](int a, int b) {
    return static_cast<std::uint8_t>((a * (100 - kTintPercent) + b * kTintPercent) / 100);
  };
  return {channel(color.r, tint.r), channel(color.g, tint.g), channel(color.b, tint.b)};
}

// The three channels of a colour in one number, so that they are added at once: a picture of the largest map
// adds 16 million cells.
constexpr int kChannelBits = 21;
constexpr std::uint64_t kChannelMask = (1 << kChannelBits) - 1;
constexpr int kMostAtOnce = 1 << (kChannelBits - 8);  // the number of colours whose sum fits
using PackedColors = std::vector<std::uint64_t>;      // by tile

PackedColors packed(const TileColors& colors) {
  PackedColors all(colors.size());
  for (std::size_t tile = 0; tile < all.size(); ++tile) {
    const Rgb color = colors[tile];
    all[tile] = color.r | std::uint64_t{color.g} << kChannelBits | std::uint64_t{color.b} << 2 * kChannelBits;
  }
  return all;
}

struct Sum {
  std::uint64_t r = 0, g = 0, b = 0, count = 0;

  // Adds the cells of a row of the map from `tiles` on.
  void add(const TileNumber* tiles, int cells, const PackedColors& colors) {
    count += static_cast<std::uint64_t>(cells);
    while (cells > 0) {
      const int now = std::min(cells, kMostAtOnce);
      std::uint64_t sum = 0;
      for (int i = 0; i < now; ++i) sum += colors[tiles[i]];
      r += sum & kChannelMask;
      g += sum >> kChannelBits & kChannelMask;
      b += sum >> 2 * kChannelBits;
      tiles += now;
      cells -= now;
    }
  }
};

// Returns, for each block in a row of blocks, the sum of its cells on the map.
std::vector<Sum> sums_of_row(const TileMap& map, const PackedColors& colors, Cell from, int block,
                             int blocks) {
  std::vector<Sum> sums(static_cast<std::size_t>(blocks));
  const int bottom = std::min(from.y + block, map.height());
  for (int y = from.y; y < bottom; ++y) {
    const TileNumber* row = map.cells().data() + static_cast<std::size_t>(y) * map.width();
    int x = from.x;
    for (Sum& sum : sums) {
      sum.add(row + x, std::min(block, map.width() - x), colors);
      x += block;
    }
  }
  return sums;
}

}  // namespace

TileColors tile_colors(const Level& level, const MapLook& look) {
  TileColors colors(static_cast<std::size_t>(level.tile_count()));
  const Sheet& sheet = level.sheet(SheetId::tiles);
  for (std::size_t tile = 0; tile < colors.size(); ++tile) {
    const bool hidden = look.hide_balls && is_ball_tile(level, static_cast<TileNumber>(tile));
    const auto shown = static_cast<TileNumber>(hidden ? 0 : tile);
    colors[tile] =
        sheet.picture != nullptr ? mean_color(level, shown) : main_color(sheet.images[shown], level.palette);
    if (look.tinted && look.tinted->matches(sheet.flags[tile])) colors[tile] = mixed(colors[tile], look.tint);
  }
  return colors;
}

std::vector<std::uint8_t> map_picture(const TileMap& map, const TileColors& colors, Cell from, int block,
                                      int width, int height) {
  assert(block >= 1 && block <= kMaxBlock);
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  const PackedColors all = packed(colors);
  // The width is counted in blocks, so that no number overflows beyond the map.
  const int columns = std::clamp((map.width() - from.x + block - 1) / block, 0, width);
  const int rows = std::min(height, (map.height() - from.y + block - 1) / block);
  for (int y = 0; y < rows; ++y) {
    std::uint8_t* out = &rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * 4];
    for (const Sum& sum : sums_of_row(map, all, {from.x, from.y + y * block}, block, columns)) {
      out[0] = static_cast<std::uint8_t>(sum.r / sum.count);
      out[1] = static_cast<std::uint8_t>(sum.g / sum.count);
      out[2] = static_cast<std::uint8_t>(sum.b / sum.count);
      out[3] = 255;
      out += 4;
    }
  }
  return rgba;
}

}  // namespace talus
