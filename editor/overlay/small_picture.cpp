#include "small_picture.h"

#include "map_picture.h"

namespace talus {
namespace {

std::uint8_t blended(int under, int over, int opacity) {
  constexpr int kOpaque = 255;
  return static_cast<std::uint8_t>((under * (kOpaque - opacity) + over * opacity) / kOpaque);
}

// The tint multiplies the colours of the layer.
void lay_over(SheetPicture& picture, const std::vector<std::uint8_t>& rgba, const LayerLooks& looks) {
  const std::array<int, 3> tint = {looks.tint.r, looks.tint.g, looks.tint.b};
  for (std::size_t at = 0; at < rgba.size(); at += 4) {
    const int opacity = static_cast<int>(rgba[at + 3] * looks.opacity);
    for (std::size_t channel = 0; channel < tint.size(); ++channel)
      picture.rgba[at + channel] =
          blended(picture.rgba[at + channel], rgba[at + channel] * tint[channel] / 255, opacity);
  }
}

}  // namespace

SheetPicture small_picture(const Level& level, int most_width, int most_height) {
  const auto along = [](int cells, int block) { return (cells + block - 1) / block; };
  int block = 1;
  while (along(level.map.width(), block) > most_width || along(level.map.height(), block) > most_height)
    block *= 2;
  SheetPicture picture{along(level.map.width(), block), along(level.map.height(), block), {}};
  const Rgb back = level.palette[0];
  for (int i = 0; i < picture.width * picture.height; ++i)
    picture.rgba.insert(picture.rgba.end(), {back.r, back.g, back.b, 255});
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    const TileLayer& its = level.layers.list[static_cast<std::size_t>(layer)];
    const LayerLooks looks = shown_looks(level.layers.groups, its);
    if (!looks.visible) continue;
    const LayerLook look{.layer = layer, .is_opaque = false, .look = {}};
    lay_over(picture,
             layer_picture(level, layer, layer_paint(level, look), {}, block, picture.width, picture.height),
             looks);
  }
  return picture;
}

}  // namespace talus
