// Matches the colours of pictures and levels.
#include "png_sheet.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr std::size_t kColors = kColorCount;

int squared_distance(Rgb a, Rgb b) {
  const int r = a.r - b.r, g = a.g - b.g, blue = a.b - b.b;
  return r * r + g * g + blue * blue;
}

void append(std::vector<std::uint8_t>& bytes, Rgb color) {
  bytes.insert(bytes.end(), {color.r, color.g, color.b});
}

// clear_zero: adds a fourth byte for each pixel, 0 if its colour is colour 0.
std::vector<std::uint8_t> bytes_of_sheet(const Sheet& sheet, const Palette& palette, TileSize tile,
                                         bool clear_zero) {
  std::vector<std::uint8_t> bytes;
  for (int y = 0; y < kSheetColumns * tile.height; ++y) {
    for (int x = 0; x < kSheetColumns * tile.width; ++x) {
      const TileImage& image = sheet.images[y / tile.height * kSheetColumns + x / tile.width];
      const std::uint8_t color = color_at(image, tile, x % tile.width, y % tile.height);
      append(bytes, palette[color]);
      if (clear_zero) bytes.push_back(color == 0 ? 0 : 255);
    }
  }
  return bytes;
}

// The opaque colours in the order of their first pixels; at most `most` + 1.
std::vector<Rgb> colors_of(const PngPicture& picture, std::size_t most) {
  std::vector<Rgb> colors;
  for (std::size_t i = 0; i < picture.pixels.size() && colors.size() <= most; ++i) {
    if (picture.transparent[i]) continue;
    if (std::find(colors.begin(), colors.end(), picture.pixels[i]) == colors.end())
      colors.push_back(picture.pixels[i]);
  }
  return colors;
}

// Colours that the palette has keep their places, as other images may use them.
Palette with_colors(const std::vector<Rgb>& colors, Palette palette) {
  std::array<bool, kColors> used{};
  std::vector<Rgb> added;
  for (const Rgb& color : colors) {
    const auto found = std::find(palette.begin(), palette.end(), color);
    if (found == palette.end())
      added.push_back(color);
    else
      used[static_cast<std::size_t>(found - palette.begin())] = true;
  }
  std::size_t index = 0;
  for (const Rgb& color : added) {
    while (used[index]) ++index;
    palette[index] = color;
    used[index] = true;
  }
  return palette;
}

}  // namespace

std::string write_png_part(const Level& level, PngPart part) {
  if (part == PngPart::palette) {
    std::vector<std::uint8_t> bytes;
    for (const Rgb& color : level.palette) append(bytes, color);
    return encode_png(kColorCount, 1, 3, bytes.data());
  }
  const SheetId id = part == PngPart::tiles ? SheetId::tiles : SheetId::sprites;
  return encode_png(kSheetSide, kSheetSide, 3,
                    bytes_of_sheet(level.sheet(id), level.palette, TileSize(), false).data());
}

std::string write_map_tiles(const Level& level) {
  const TileSize tile = level.map.tile_size();
  const auto bytes = bytes_of_sheet(level.sheet(SheetId::tiles), level.palette, tile, false);
  return encode_png(kSheetColumns * tile.width, kSheetColumns * tile.height, 3, bytes.data());
}

std::string write_clear_tiles(const Level& level) {
  const TileSize tile = level.map.tile_size();
  const auto bytes = bytes_of_sheet(level.sheet(SheetId::tiles), level.palette, tile, true);
  return encode_png(kSheetColumns * tile.width, kSheetColumns * tile.height, 4, bytes.data());
}

std::uint8_t color_at(const TileImage& image, TileSize tile, int x, int y) {
  const int column = (2 * x + 1) * kCartTileSize / (2 * tile.width);
  const int row = (2 * y + 1) * kCartTileSize / (2 * tile.height);
  return image[static_cast<std::size_t>(row * kCartTileSize + column)];
}

MatchedPicture match_colors(const PngPicture& picture, const Palette& palette) {
  MatchedPicture matched;
  int largest = 0;
  for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
    if (picture.transparent[i]) {
      matched.indices.push_back(0);
      continue;
    }
    const auto distance = [&](Rgb color) { return squared_distance(color, picture.pixels[i]); };
    const auto nearest = std::min_element(palette.begin(), palette.end(), [&](const Rgb& a, const Rgb& b) {
      return distance(a) < distance(b);
    });
    matched.indices.push_back(static_cast<std::uint8_t>(nearest - palette.begin()));
    if (distance(*nearest) > 0) ++matched.approximated;
    if (distance(*nearest) <= largest) continue;
    largest = distance(*nearest);
    const int at = static_cast<int>(i);
    matched.farthest = {at % picture.width, at / picture.width};
  }
  matched.largest_distance = std::sqrt(largest);
  return matched;
}

FormatResult<Palette> palette_for(const PngPicture& picture, const Palette& palette) {
  if (!picture.palette.empty() && picture.palette.size() <= kColors) {
    Palette taken = palette;
    std::copy(picture.palette.begin(), picture.palette.end(), taken.begin());
    return taken;
  }
  const std::vector<Rgb> colors = colors_of(picture, kColors);
  if (colors.size() > kColors)
    return tl::unexpected(FormatError{"", "has more than 16 colours, too many for the palette of a level"});
  return with_colors(colors, palette);
}

FormatResult<Palette> palette_in(const PngPicture& picture, const Palette& palette) {
  if (picture.height != 1 || picture.width > kColorCount) {
    return tl::unexpected(FormatError{"", "is " + std::to_string(picture.width) + "x" +
                                              std::to_string(picture.height) +
                                              " px, but a palette must be 1 to 16 px side by side"});
  }
  Palette taken = palette;
  std::copy(picture.pixels.begin(), picture.pixels.end(), taken.begin());
  return taken;
}

}  // namespace talus
