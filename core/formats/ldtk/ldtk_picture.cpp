// Draws tiles that are composed of several.
#include <algorithm>

#include "../import/numbered_box.h"
#include "ldtk_tiles.h"

namespace talus {
namespace {

constexpr int kOpaqueLdtk = 255;

// Rounded.
int divided(int value, int by) { return by == 0 ? 0 : (value + by / 2) / by; }

// Draws a colour over a pixel.
void draw_over(const LdtkColor& color, std::uint8_t* pixel) {
  if (color.a == 0) return;
  const int below = divided(pixel[3] * (kOpaqueLdtk - color.a), kOpaqueLdtk);
  const int all = color.a + below;
  const auto mixed = [&](int over, int under) {
    return static_cast<std::uint8_t>(divided(over * color.a + under * below, all));
  };
  pixel[0] = mixed(color.r, pixel[0]);
  pixel[1] = mixed(color.g, pixel[1]);
  pixel[2] = mixed(color.b, pixel[2]);
  pixel[3] = static_cast<std::uint8_t>(all);
}

}  // namespace

LdtkColor color_in_ldtk_source(const LdtkSource& source, const LdtkPictures& pictures, int x, int y) {
  const auto solid = [&](Rgb color) { return LdtkColor{color.r, color.g, color.b, source.opacity}; };
  if (source.tileset < 0) {
    return {static_cast<int>(source.rgb >> 16 & 0xff), static_cast<int>(source.rgb >> 8 & 0xff),
            static_cast<int>(source.rgb & 0xff), source.opacity};
  }
  const auto& picture = pictures[static_cast<std::size_t>(source.tileset)];
  const int in_x = (source.flips & 1) != 0 ? source.side - 1 - x : x;
  const int in_y = (source.flips & 2) != 0 ? source.side - 1 - y : y;
  if (picture == nullptr || picture->is_missing) {
    return solid(color_of_box(source.id, x * kCartTileSize / source.side, y * kCartTileSize / source.side));
  }
  const RgbaPicture& rgba = picture->rgba;
  const std::int64_t at_x = std::int64_t{source.x} + in_x, at_y = std::int64_t{source.y} + in_y;
  if (at_x < 0 || at_y < 0 || at_x >= rgba.width || at_y >= rgba.height) return {};
  const auto* bytes =
      reinterpret_cast<const std::uint8_t*>(rgba.bytes.data()) + 4 * (at_y * rgba.width + at_x);
  return {bytes[0], bytes[1], bytes[2], divided(bytes[3] * source.opacity, kOpaqueLdtk)};
}

std::vector<std::uint8_t> picture_of_ldtk_cell(const LdtkTiles& tiles, const LdtkCell& cell,
                                               const LdtkPictures& pictures) {
  const auto [width, height] = tiles.map.tile_size();
  std::vector<std::uint8_t> rgba(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (const LdtkPart& part : cell.parts) {
    if (part.is_hidden) continue;
    const LdtkSource& source = tiles.sources[part.source];
    for (int y = std::max(0, part.y); y < std::min(height, part.y + source.side); ++y) {
      for (int x = std::max(0, part.x); x < std::min(width, part.x + source.side); ++x) {
        draw_over(color_in_ldtk_source(source, pictures, x - part.x, y - part.y),
                  &rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(x))]);
      }
    }
  }
  return rgba;
}

}  // namespace talus
