// Draws the map when it is zoomed far out.
#include "map_picture.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "level/tile_color.h"

namespace talus {
namespace {

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
constexpr int kMaxAtOnce = 1 << (kChannelBits - 8);  // the number of colours whose sum fits
using PackedColors = std::vector<std::uint64_t>;     // by tile

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
      const int now = std::min(cells, kMaxAtOnce);
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

// The tiles of a layer.
struct LayerTiles {
  const std::vector<TileNumber>& cells;  // row by row
  int width, height;
};

// Returns, for each block in a row of blocks, the sum of its cells on the map.
std::vector<Sum> sums_of_row(const LayerTiles& map, const PackedColors& colors, Cell from, int block,
                             int blocks) {
  std::vector<Sum> sums(static_cast<std::size_t>(blocks));
  const int bottom = std::min(from.y + block, map.height);
  for (int y = from.y; y < bottom; ++y) {
    const TileNumber* row = map.cells.data() + static_cast<std::size_t>(y) * map.width;
    int x = from.x;
    for (Sum& sum : sums) {
      sum.add(row + x, std::min(block, map.width - x), colors);
      x += block;
    }
  }
  return sums;
}

Rgb times_opacity(Rgb color, std::uint8_t opacity) {
  const auto channel = [&](int value) { return static_cast<std::uint8_t>((value * opacity + 127) / 255); };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

// The colours times their opacity, so that the mean of a block weighs each tile by what it shows; and the
// opacity as a colour.
struct ClearPaint {
  explicit ClearPaint(const LayerPaint& paint) {
    TileColors weighed = paint.colors, opaque(paint.colors.size());
    for (std::size_t tile = 0; tile < opaque.size(); ++tile) {
      weighed[tile] = times_opacity(weighed[tile], paint.opacity[tile]);
      opaque[tile] = {paint.opacity[tile], 0, 0};
    }
    colors = packed(weighed);
    opacity = packed(opaque);
  }
  PackedColors colors, opacity;
};

// Draws a row of blocks. Blocks that lie off the map stay clear.
void draw_row(const LayerTiles& map, const PackedColors& colors, Cell from, int block, int blocks,
              std::uint8_t* out) {
  for (const Sum& sum : sums_of_row(map, colors, from, block, blocks)) {
    out[0] = static_cast<std::uint8_t>(sum.r / sum.count);
    out[1] = static_cast<std::uint8_t>(sum.g / sum.count);
    out[2] = static_cast<std::uint8_t>(sum.b / sum.count);
    out[3] = 255;
    out += 4;
  }
}

void draw_clear_row(const LayerTiles& map, const ClearPaint& paint, Cell from, int block, int blocks,
                    std::uint8_t* out) {
  const std::vector<Sum> colors = sums_of_row(map, paint.colors, from, block, blocks);
  const std::vector<Sum> opacity = sums_of_row(map, paint.opacity, from, block, blocks);
  for (std::size_t i = 0; i < colors.size(); ++i, out += 4) {
    const std::uint64_t shown = opacity[i].r;
    if (shown == 0) continue;
    const auto channel = [&](std::uint64_t sum) {
      return static_cast<std::uint8_t>(std::min<std::uint64_t>(255, (sum * 255 + shown / 2) / shown));
    };
    out[0] = channel(colors[i].r);
    out[1] = channel(colors[i].g);
    out[2] = channel(colors[i].b);
    out[3] = static_cast<std::uint8_t>(shown / opacity[i].count);
  }
}

// Calls draw(from, blocks, out) for each row of blocks that lies on the map.
template <class DrawRow>
std::vector<std::uint8_t> picture_of_rows(const LayerTiles& map, Cell from, int block, int width, int height,
                                          const DrawRow& draw) {
  assert(block >= 1 && block <= kMaxBlock);
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4);
  // The width is counted in blocks, so that no number overflows beyond the map.
  const int columns = std::clamp((map.width - from.x + block - 1) / block, 0, width);
  const int rows = std::min(height, (map.height - from.y + block - 1) / block);
  for (int y = 0; y < rows; ++y)
    draw(Cell{from.x, from.y + y * block}, columns,
         &rgba[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) * 4]);
  return rgba;
}

// The commonest of the colours 1..15 of an image, and how many of its pixels have such a colour.
std::pair<Rgb, int> main_clear_color(const TileImage& image, const Palette& palette) {
  std::array<int, kColorCount> counts{};
  for (const std::uint8_t pixel : image) ++counts[pixel];
  const auto most = std::max_element(counts.begin() + 1, counts.end());
  return {palette[static_cast<std::size_t>(most - counts.begin())],
          static_cast<int>(image.size()) - counts[0]};
}

// The mean of some pixels of a tile in true colour by their opacity, and the mean of that.
std::pair<Rgb, std::uint8_t> mean_clear_color(const Level& level, TileNumber tile) {
  constexpr int kAlong = 4;  // pixels along each side
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  const Cell place = sheet.layout().place_of(tile);
  std::array<int, 4> sums{};
  for (int i = 0; i < kAlong * kAlong; ++i) {
    const std::uint8_t* at =
        sheet.picture->at(place.x * size.width + (2 * (i % kAlong) + 1) * size.width / (2 * kAlong),
                          place.y * size.height + (2 * (i / kAlong) + 1) * size.height / (2 * kAlong));
    for (std::size_t channel = 0; channel < 3; ++channel) sums[channel] += at[channel] * at[3];
    sums[3] += at[3];
  }
  if (sums[3] == 0) return {};
  const auto mean = [&](int sum) { return static_cast<std::uint8_t>(sum / sums[3]); };
  return {{mean(sums[0]), mean(sums[1]), mean(sums[2])},
          static_cast<std::uint8_t>(sums[3] / (kAlong * kAlong))};
}

std::pair<Rgb, std::uint8_t> clear_color(const Level& level, TileNumber tile) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  if (sheet.picture != nullptr) return mean_clear_color(level, tile);
  const auto [color, pixels] = main_clear_color(sheet.images[tile], level.palette);
  return {color, static_cast<std::uint8_t>(255 * pixels / static_cast<int>(sheet.images[tile].size()))};
}

}  // namespace

TileColors tile_colors(const Level& level, const MapLook& look) {
  TileColors colors(static_cast<std::size_t>(level.tile_count()));
  const Sheet& sheet = level.sheet(SheetId::tiles);
  for (std::size_t tile = 0; tile < colors.size(); ++tile) {
    const bool hidden = look.hide_balls && is_ball_tile(level, static_cast<TileNumber>(tile));
    const auto shown = static_cast<TileNumber>(hidden ? 0 : tile);
    colors[tile] =
        sheet.picture != nullptr ? mean_color(level, shown) : level.palette[main_color(sheet.images[shown])];
    if (look.tinted && look.tinted->matches(sheet.flags[tile])) colors[tile] = mixed(colors[tile], look.tint);
  }
  return colors;
}

LayerPaint layer_paint(const Level& level, const LayerLook& look) {
  const bool is_ground = level.layers.list[static_cast<std::size_t>(look.layer)].is_ground;
  const MapLook of_tiles = is_ground ? look.look : MapLook{};
  if (look.is_opaque) return {tile_colors(level, of_tiles), {}};
  LayerPaint paint{TileColors(static_cast<std::size_t>(level.tile_count())),
                   TileOpacity(static_cast<std::size_t>(level.tile_count()))};
  const auto& flags = level.sheet(SheetId::tiles).flags;
  for (std::size_t tile = 0; tile < paint.colors.size(); ++tile) {
    const bool hidden = of_tiles.hide_balls && is_ball_tile(level, static_cast<TileNumber>(tile));
    const auto shown = static_cast<TileNumber>(hidden ? 0 : tile);
    if (shown == 0 && look.layer > 0) continue;
    std::tie(paint.colors[tile], paint.opacity[tile]) = clear_color(level, shown);
    if (of_tiles.tinted && of_tiles.tinted->matches(flags[tile]))
      paint.colors[tile] = mixed(paint.colors[tile], of_tiles.tint);
  }
  return paint;
}

std::vector<std::uint8_t> map_picture(const TileMap& map, const TileColors& colors, Cell from, int block,
                                      int width, int height) {
  const LayerTiles tiles{map.cells().tiles(), map.width(), map.height()};
  const PackedColors all = packed(colors);
  return picture_of_rows(tiles, from, block, width, height, [&](Cell at, int blocks, std::uint8_t* out) {
    draw_row(tiles, all, at, block, blocks, out);
  });
}

std::vector<std::uint8_t> layer_picture(const Level& level, int layer, const LayerPaint& paint, Cell from,
                                        int block, int width, int height) {
  const LayerTiles tiles{level.cells_of(layer).tiles(), level.map.width(), level.map.height()};
  if (paint.opacity.empty()) {
    const PackedColors all = packed(paint.colors);
    return picture_of_rows(tiles, from, block, width, height, [&](Cell at, int blocks, std::uint8_t* out) {
      draw_row(tiles, all, at, block, blocks, out);
    });
  }
  const ClearPaint clear(paint);
  return picture_of_rows(tiles, from, block, width, height, [&](Cell at, int blocks, std::uint8_t* out) {
    draw_clear_row(tiles, clear, at, block, blocks, out);
  });
}

}  // namespace talus
