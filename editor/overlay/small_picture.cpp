#include "small_picture.h"

#include "level/tile_color.h"
#include "map_picture.h"

namespace talus {
namespace {

// The tint multiplies the colours of the layer.
void lay_layer_over(SheetPicture& picture, const std::vector<std::uint8_t>& rgba, const LayerLooks& looks) {
  const auto tinted = [](int color, int tint) { return static_cast<std::uint8_t>(color * tint / 255); };
  for (std::size_t at = 0; at < rgba.size(); at += 4) {
    lay_over(&picture.rgba[at],
             {tinted(rgba[at], looks.tint.r), tinted(rgba[at + 1], looks.tint.g),
              tinted(rgba[at + 2], looks.tint.b), static_cast<std::uint8_t>(rgba[at + 3] * looks.opacity)});
  }
}

}  // namespace

SheetPicture small_picture(const Level& level, int most_width, int most_height) {
  const auto along = [](int cells, int block) { return (cells + block - 1) / block; };
  int block = 1;
  while (along(level.map.width(), block) > most_width || along(level.map.height(), block) > most_height)
    block *= 2;
  SheetPicture picture{along(level.map.width(), block), along(level.map.height(), block), {}};
  const auto [r, g, b, a] = background_of(level);
  for (int i = 0; i < picture.width * picture.height; ++i)
    picture.rgba.insert(picture.rgba.end(), {r, g, b, a});
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const TileLayer& its = level.layers.list[static_cast<std::size_t>(layer)];
    const LayerLooks looks = shown_looks(level.layers.groups, its);
    if (!looks.visible) continue;
    const LayerLook look{.layer = layer, .is_opaque = false, .look = {}};
    lay_layer_over(
        picture,
        layer_picture(level, layer, layer_paint(level, look), {}, block, picture.width, picture.height),
        looks);
  }
  return picture;
}

}  // namespace talus
