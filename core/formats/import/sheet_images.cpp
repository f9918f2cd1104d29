// Gives the pixels of another program the nearest of the 16 colours.
#include "sheet_images.h"

#include "../../level/tile_color.h"
#include "../pictures/png_sheet.h"

namespace talus {
namespace {

// The palette with the colours of the picture, if it can have them, behind its colour 0. A palette of the
// file is taken as it is unless the picture shows the first of its colours.
Palette fitting_palette(PngPicture picture, const Palette& palette) {
  for (std::size_t i = 0; i < picture.pixels.size() && !picture.palette.empty(); ++i)
    if (!picture.transparent[i] && picture.pixels[i] == picture.palette[0]) picture.palette.clear();
  auto fitting = palette_for(picture, palette);
  const auto add_color_0 = [&] {
    picture.pixels.push_back(palette[0]);
    picture.transparent.push_back(false);
    return palette_for(picture, palette);
  };
  if (fitting && (*fitting)[0] != palette[0] && picture.palette.empty()) {
    if (auto with_color_0 = add_color_0()) fitting = with_color_0;
  }
  if (!fitting) return palette;
  (*fitting)[0] = palette[0];
  return *fitting;
}

}  // namespace

void put_images(const SheetPicture& images, const std::vector<Rgb>& palette, Level& level) {
  PngPicture picture{images.width, images.height, {}, {}, palette};
  for (std::size_t i = 0; i < images.rgba.size(); i += 4) {
    const bool is_clear = images.rgba[i + 3] < kHalfOpaque;
    picture.transparent.push_back(is_clear);
    picture.pixels.push_back(is_clear ? Rgb{} : Rgb{images.rgba[i], images.rgba[i + 1], images.rgba[i + 2]});
  }
  level.palette = fitting_palette(picture, level.palette);
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

namespace {

// Whether all pixels of a picture, with the colours of the images there, are as wanted. Pixels of no tile
// count as such.
template <class IsWanted>
bool all_pixels(const SheetPicture& picture, const Level& level, IsWanted is_wanted) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const TileSize size = level.map.tile_size();
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const Cell place{x / size.width, y / size.height};
      if (!sheet.layout().contains(place)) continue;
      const TileImage& image = sheet.images[static_cast<std::size_t>(sheet.layout().tile_at(place))];
      if (!is_wanted(picture.at(x, y), color_at(image, size, x % size.width, y % size.height))) return false;
    }
  }
  return true;
}

constexpr int kFullOpacity = 255;

}  // namespace

bool images_show(const SheetPicture& picture, const Level& level) {
  return all_pixels(picture, level, [&](const std::uint8_t* pixel, std::uint8_t color) {
    const bool is_clear = pixel[3] == 0 && color == 0;
    return is_clear ||
           (pixel[3] == kFullOpacity && level.palette[color] == Rgb{pixel[0], pixel[1], pixel[2]});
  });
}

bool has_opaque_color_0(const SheetPicture& picture, const Level& level) {
  return !all_pixels(picture, level, [](const std::uint8_t* pixel, std::uint8_t color) {
    return pixel[3] != kFullOpacity || color != 0;
  });
}

}  // namespace talus
