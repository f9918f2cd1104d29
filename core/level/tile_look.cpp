// Takes the looks of tiles from sheets, and puts them there.
#include "tile_look.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <memory>

#include "tile_color.h"

namespace talus {
namespace {

constexpr std::ptrdiff_t kBytes = 4;  // of a pixel

// The first byte of a row of a tile in the picture. y: px from the top of the tile.
std::size_t start_of_row(const SheetPicture& picture, TileSize size, Cell place, int y) {
  const auto row =
      static_cast<std::size_t>(place.y * size.height + y) * static_cast<std::size_t>(picture.width);
  return kBytes * (row + static_cast<std::size_t>(place.x) * static_cast<std::size_t>(size.width));
}

// The picture of a sheet, to be changed.
SheetPicture& own_picture(Sheet& sheet) {
  // Giving back a share orders the changes after what other threads have read before they gave back theirs.
  { const std::shared_ptr<const SheetPicture> share = sheet.picture; }
  if (sheet.picture.use_count() > 1) sheet.picture = std::make_shared<SheetPicture>(*sheet.picture);
  return const_cast<SheetPicture&>(*sheet.picture);  // nobody else can see it
}

}  // namespace

TileLook look_of(const Sheet& sheet, TileSize size, int tile) {
  TileLook look{sheet.images[static_cast<std::size_t>(tile)], {}};
  if (sheet.picture == nullptr) return look;
  const Cell place = sheet.layout().place_of(tile);
  const std::ptrdiff_t row = kBytes * size.width;
  look.rgba.reserve(static_cast<std::size_t>(row * size.height));
  for (int y = 0; y < size.height; ++y) {
    const auto from = sheet.picture->rgba.begin() +
                      static_cast<std::ptrdiff_t>(start_of_row(*sheet.picture, size, place, y));
    look.rgba.insert(look.rgba.end(), from, from + row);
  }
  return look;
}

void put_look(const TileLook& look, TileSize size, int tile, Sheet& sheet) {
  sheet.images[static_cast<std::size_t>(tile)] = look.image;
  if (sheet.picture == nullptr) return;
  const std::ptrdiff_t row = kBytes * size.width;
  assert(std::ssize(look.rgba) == row * size.height);
  SheetPicture& picture = own_picture(sheet);
  const Cell place = sheet.layout().place_of(tile);
  for (int y = 0; y < size.height; ++y)
    std::copy_n(look.rgba.begin() + row * y, row, &picture.rgba[start_of_row(picture, size, place, y)]);
}

TileImage image_of(const std::vector<std::uint8_t>& rgba, TileSize size, const Palette& palette) {
  TileImage image{};
  for (int i = 0; i < kCartTileSize * kCartTileSize; ++i) {
    const int x = pixel_of_side(i % kCartTileSize, size.width);
    const int y = pixel_of_side(i / kCartTileSize, size.height);
    const std::uint8_t* const pixel = &rgba[static_cast<std::size_t>(kBytes * (y * size.width + x))];
    if (pixel[3] >= kHalfOpaque)
      image[static_cast<std::size_t>(i)] = nearest_color({pixel[0], pixel[1], pixel[2]}, palette);
  }
  return image;
}

std::uint8_t nearest_color(Rgb color, const Palette& palette) {
  const auto distance = [&](Rgb other) {
    const int r = color.r - other.r, g = color.g - other.g, b = color.b - other.b;
    return r * r + g * g + b * b;
  };
  const auto nearest = std::min_element(
      palette.begin(), palette.end(), [&](const Rgb& a, const Rgb& b) { return distance(a) < distance(b); });
  return static_cast<std::uint8_t>(nearest - palette.begin());
}

}  // namespace talus
