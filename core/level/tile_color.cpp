// Finds the colours of tiles on the map and on the sheets.
#include "tile_color.h"

#include <algorithm>
#include <array>

namespace talus {

std::uint8_t color_at(const TileImage& image, TileSize tile, int x, int y) {
  const int column = (2 * x + 1) * kCartTileSize / (2 * tile.width);
  const int row = (2 * y + 1) * kCartTileSize / (2 * tile.height);
  return image[static_cast<std::size_t>(row * kCartTileSize + column)];
}

std::uint8_t main_color(std::span<const std::uint8_t> pixels) {
  std::array<int, kColorCount> counts{};
  for (const std::uint8_t pixel : pixels) ++counts[pixel];
  return static_cast<std::uint8_t>(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

bool is_clear(const SheetPicture& picture, const SheetLayout& layout, TileNumber tile, TileSize size) {
  const Cell place = layout.place_of(tile);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x)
      if (picture.at(place.x * size.width + x, place.y * size.height + y)[3] != 0) return false;
  return true;
}

void lay_over(std::uint8_t* under, Rgba over) {
  constexpr int kOpaque = 255;
  if (over.a == 0) return;
  if (over.a == kOpaque) {
    under[0] = over.r, under[1] = over.g, under[2] = over.b, under[3] = kOpaque;
    return;
  }
  // Shares of the pixel in 255 * 255 parts.
  const int above = over.a * kOpaque, below = under[3] * (kOpaque - over.a), both = above + below;
  const auto mixed = [&](int color, int other) {
    return static_cast<std::uint8_t>((color * above + other * below + both / 2) / both);
  };
  under[0] = mixed(over.r, under[0]);
  under[1] = mixed(over.g, under[1]);
  under[2] = mixed(over.b, under[2]);
  under[3] = static_cast<std::uint8_t>((both + kOpaque / 2) / kOpaque);
}

Rgb color_on_map(const Level& level, TileNumber tile, int x, int y) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  if (sheet.picture == nullptr) return level.palette[color_at(sheet.images[tile], size, x, y)];
  const Cell place = sheet.layout().place_of(tile);
  const std::uint8_t* over = sheet.picture->at(place.x * size.width + x, place.y * size.height + y);
  const Rgb under = level.palette[0];
  std::array<std::uint8_t, 4> pixel = {under.r, under.g, under.b, 255};
  lay_over(pixel.data(), {over[0], over[1], over[2], over[3]});
  return {pixel[0], pixel[1], pixel[2]};
}

bool is_blank(const Level& level, TileNumber tile, SheetId id) {
  const Sheet& sheet = level.sheet(id);
  if (sheet.picture != nullptr) return is_clear(*sheet.picture, sheet.layout(), tile, level.map.tile_size());
  const TileImage& image = sheet.images[tile];
  return std::all_of(image.begin(), image.end(), [](std::uint8_t color) { return color == 0; });
}

std::uint64_t drawn_pixels(const Level& level, TileNumber tile) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  const Cell place = sheet.layout().place_of(tile);
  std::uint64_t drawn = 0;
  for (int i = 0; i < kCartTileSize * kCartTileSize; ++i) {
    const int x = pixel_of_side(i % kCartTileSize, size.width);
    const int y = pixel_of_side(i / kCartTileSize, size.height);
    const bool is_drawn =
        sheet.picture != nullptr
            ? sheet.picture->at(place.x * size.width + x, place.y * size.height + y)[3] >= kHalfOpaque
            : sheet.images[tile][static_cast<std::size_t>(i)] != 0;
    drawn |= std::uint64_t{is_drawn} << i;
  }
  return drawn;
}

}  // namespace talus
