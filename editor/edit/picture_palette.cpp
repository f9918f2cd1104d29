// Counts the colours of a picture, and sorts them.
#include "picture_palette.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace talus {
namespace {

using ColorCounts = std::unordered_map<PixelColor, std::size_t>;

// Counts the pixels of a rectangle of tiles; of a large one only each n-th.
void count_colors(const Level& level, const SpriteArea& area, std::size_t weight, ColorCounts& counts) {
  constexpr std::int64_t kMaxLookedAt = 1 << 17;
  const SheetPicture& picture = *level.sheet(area.sheet).picture;
  const int left = area.tiles.x * area.tile.width, top = area.tiles.y * area.tile.height;
  const std::int64_t all = std::int64_t{area.width()} * area.height();
  // Odd, so that it falls on all columns of pictures whose width is a power of two.
  const std::int64_t step = all / kMaxLookedAt | 1;
  for (std::int64_t i = 0; i < all; i += step) {
    const int x = left + static_cast<int>(i % area.width()), y = top + static_cast<int>(i / area.width());
    if (x >= picture.width || y >= picture.height) continue;
    const std::uint8_t* const pixel = picture.at(x, y);
    if (pixel[3] != 0) counts[pixel_color({pixel[0], pixel[1], pixel[2], pixel[3]})] += weight;
  }
}

// The tileset of an area, as columns and rows of the sheet; the whole sheet if it belongs to none.
CellRect tileset_of(const Level& level, const SpriteArea& area) {
  const SheetLayout sheet = level.sheet(area.sheet).layout();
  const int index = area.sheet == SheetId::tiles
                        ? tileset_with(level.tilesets, sheet, sheet.tile_at({area.tiles.x, area.tiles.y}))
                        : -1;
  if (index < 0) return {0, 0, sheet.columns, sheet.rows()};
  const Tileset& set = level.tilesets[static_cast<std::size_t>(index)];
  const Cell from = sheet.place_of(set.first), to = sheet.place_of(set.first + set.count - 1);
  return {from.x, from.y, set.columns, to.y - from.y + 1};
}

// The largest difference of a channel.
int color_distance(Rgba a, Rgba b) {
  return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b), std::abs(a.a - b.a)});
}

// The colours, the most used ones first. Of very many, those that are nearly the same count as the most used
// one of them.
std::vector<Rgba> by_use(const ColorCounts& counts) {
  constexpr std::size_t kMany = 1024;
  const int shift = counts.size() > kMany ? 4 : 0;
  struct Group {
    PixelColor color = 0;
    std::size_t most = 0, all = 0;  // pixels of that colour, and of all colours
  };
  std::map<PixelColor, Group> groups;
  for (const auto& [color, count] : counts) {
    const auto rough = [&](std::uint8_t part) { return static_cast<std::uint8_t>(part >> shift); };
    const Rgba c = rgba_of(color);
    Group& group = groups[std::bit_cast<PixelColor>(Rgba{rough(c.r), rough(c.g), rough(c.b), rough(c.a)})];
    group.all += count;
    if (count < group.most || (count == group.most && color > group.color)) continue;
    group.color = color;
    group.most = count;
  }
  std::vector<Group> sorted;
  sorted.reserve(groups.size());
  for (const auto& [rough, group] : groups) sorted.push_back(group);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Group& a, const Group& b) { return a.all > b.all; });
  std::vector<Rgba> colors;
  colors.reserve(sorted.size());
  for (const Group& group : sorted) colors.push_back(rgba_of(group.color));
  return colors;
}

// The first ones, of which no two are nearer than `least`; at most one more than kMaxPictureColors.
std::vector<Rgba> distinct(const std::vector<Rgba>& colors, int least) {
  std::vector<Rgba> chosen;
  for (const Rgba color : colors) {
    const auto is_near = [&](Rgba other) { return color_distance(color, other) < least; };
    if (chosen.size() > kMaxPictureColors) break;
    if (std::none_of(chosen.begin(), chosen.end(), is_near)) chosen.push_back(color);
  }
  return chosen;
}

// Greys, then twelve hues; in each from dark to light.
std::tuple<int, int, PixelColor> order_of(Rgba c) {
  constexpr int kHues = 12;
  const int most = std::max({c.r, c.g, c.b}), least = std::min({c.r, c.g, c.b}), range = most - least;
  const int light = 3 * c.r + 6 * c.g + c.b;
  if (range * 6 <= most) return {0, light, pixel_color(c)};
  double hue = 0;  // in sixths of the circle
  if (most == c.r)
    hue = 1.0 * (c.g - c.b) / range;
  else if (most == c.g)
    hue = 2 + 1.0 * (c.b - c.r) / range;
  else
    hue = 4 + 1.0 * (c.r - c.g) / range;
  const int sector = static_cast<int>((hue + 6.5) * kHues / 6) % kHues;
  return {1 + sector, light, pixel_color(c)};
}

}  // namespace

std::vector<Rgba> picture_palette(const Level& level, const SpriteArea& area) {
  if (!is_in_rgba(level, area.sheet) || !area.lies_in_sheet(level)) return {};
  constexpr std::size_t kWeightOfArea = 64;
  ColorCounts counts;
  count_colors(level, area, kWeightOfArea, counts);
  count_colors(level, {area.sheet, tileset_of(level, area), area.tile}, 1, counts);
  const std::vector<Rgba> colors = by_use(counts);
  std::vector<Rgba> chosen;
  for (const int least : {96, 64, 48, 40, 32, 24, 16, 12, 8, 4, 2, 1}) {  // as many as there is room for
    std::vector<Rgba> more = distinct(colors, least);
    if (more.size() > kMaxPictureColors) break;
    chosen = std::move(more);
  }
  std::sort(chosen.begin(), chosen.end(), [](Rgba a, Rgba b) { return order_of(a) < order_of(b); });
  return chosen;
}

std::string hex_text(Rgba color) {
  std::array<char, 10> hex{};
  std::snprintf(hex.data(), hex.size(), "#%02x%02x%02x%02x", color.r, color.g, color.b, color.a);
  const std::string text = hex.data();
  return color.a == 255 ? text.substr(0, text.size() - 2) : text;
}

}  // namespace talus
