// Matches colours.
#include "sheet_images.h"

#include "../../level/tile_color.h"
#include "../pictures/png_sheet.h"

namespace talus {

void put_images(const SheetPicture& images, const std::vector<Rgb>& palette, Level& level) {
  constexpr int kHalfOpaque = 128;
  PngPicture picture{images.width, images.height, {}, {}, palette};
  for (std::size_t i = 0; i < images.rgba.size(); i += 4) {
    const bool is_clear = images.rgba[i + 3] < kHalfOpaque;
    picture.transparent.push_back(is_clear);
    picture.pixels.push_back(is_clear ? Rgb{} : Rgb{images.rgba[i], images.rgba[i + 1], images.rgba[i + 2]});
  }
  if (const auto fitting = palette_for(picture, level.palette)) level.palette = *fitting;
  const MatchedPicture matched = match_colors(picture, level.palette);
  Sheet& sheet = level.sheet(SheetId::tiles);
  for (int i = 0; i < picture.width * picture.height; ++i) {
    const int x = i % picture.width, y = i / picture.width;
    const Cell place{x / kCartTileSize, y / kCartTileSize};
    if (!sheet.layout().contains(place)) continue;
    sheet.images[static_cast<std::size_t>(sheet.layout().tile_at(place))]
                [static_cast<std::size_t>(y % kCartTileSize * kCartTileSize + x % kCartTileSize)] =
        matched.indices[static_cast<std::size_t>(i)];
  }
}

bool images_show(const SheetPicture& picture, const Level& level) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Cell place{x / size.width, y / size.height};
      if (!sheet.layout().contains(place)) continue;
      const TileImage& image = sheet.images[static_cast<std::size_t>(sheet.layout().tile_at(place))];
      const std::uint8_t color = color_at(image, size, x % size.width, y % size.height);
      const std::uint8_t* pixel = picture.at(x, y);
      constexpr int kOpaque = 255;
      const bool is_clear = pixel[3] == 0 && color == 0;
      const bool is_same = pixel[3] == kOpaque && level.palette[color] == Rgb{pixel[0], pixel[1], pixel[2]};
      if (!is_clear && !is_same) return false;
    }
  }
  return true;
}

}  // namespace talus
