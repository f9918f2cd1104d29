// Matches the colours of pictures and levels.
#include "png_sheet.h"

#include <algorithm>
#include <cmath>

#include "../../level/tile_color.h"

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

// clear_zero: pixels of colour 0 are transparent.
std::string png_of_sheet(const Sheet& sheet, const Palette& palette, TileSize tile, bool clear_zero) {
  if (sheet.picture != nullptr)
    return encode_png(sheet.picture->width, sheet.picture->height, 4, sheet.picture->rgba.data());
  std::vector<std::uint8_t> bytes;
  const SheetLayout layout = sheet.layout();
  for (int y = 0; y < layout.rows() * tile.height; ++y) {
    for (int x = 0; x < layout.columns * tile.width; ++x) {
      const Cell place = {x / tile.width, y / tile.height};
      const bool is_image = layout.contains(place);  // the last row may be shorter
      const std::uint8_t color =
          is_image ? color_at(sheet.images[layout.tile_at(place)], tile, x % tile.width, y % tile.height)
                   : std::uint8_t{0};
      append(bytes, palette[color]);
      if (clear_zero) bytes.push_back(color == 0 ? 0 : 255);
    }
  }
  return encode_png(layout.columns * tile.width, layout.rows() * tile.height, clear_zero ? 4 : 3,
                    bytes.data());
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
  Sheet sheet = level.sheet(id);
  sheet.picture = nullptr;  // the part is as a cart has it
  return png_of_sheet(sheet, level.palette, TileSize(), false);
}

std::string write_map_tiles(const Level& level) {
  const bool clear_zero = level.background.has_value();  // else colour 0 is what is seen behind it anyway
  return png_of_sheet(level.sheet(SheetId::tiles), level.palette, level.map.tile_size(), clear_zero);
}

std::string write_clear_sheet(const Level& level, SheetId sheet) {
  return png_of_sheet(level.sheet(sheet), level.palette, level.map.tile_size(), true);
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
