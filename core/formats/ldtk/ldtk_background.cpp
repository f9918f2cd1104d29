#include "ldtk_background.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "ldtk_tiles.h"

namespace talus {
namespace {

// Whole px of a picture of that length: where they begin, and how many they are.
std::pair<int, int> whole_px(double from, double length, int most) {
  const int first = static_cast<int>(std::clamp(std::floor(from + 0.5), 0.0, most - 1.0));
  const int count = static_cast<int>(std::clamp(std::floor(length + 0.5), 1.0, 1.0 * (most - first)));
  return {first, count};
}

PicturePart part_of(const LdtkBackground& background) {
  const RgbaPicture& rgba = background.picture->rgba;
  PicturePart part;
  part.picture = shared_picture(rgba);
  const Rect shown = background.part.value_or(Rect{0, 0, 1.0 * rgba.width, 1.0 * rgba.height});
  std::tie(part.x, part.width) = whole_px(shown.x, shown.w, rgba.width);
  std::tie(part.y, part.height) = whole_px(shown.y, shown.h, rgba.height);
  return part;
}

bool is_well_sized(Vec2 corner, Vec2 size) {
  return std::max({std::abs(corner.x), std::abs(corner.y) + size.y, size.x}) <= kMaxLayerOffset;
}

}  // namespace

std::optional<ObjectLayer> ldtk_background_layer(const LdtkBackground& background, Vec2 origin,
                                                 ImportDrops& drops) {
  const auto& picture = background.picture;
  if (picture == nullptr || picture->is_missing) return {};
  const std::size_t pixels = picture->rgba.bytes.size() / 4;
  if (pixels == 0 || pixels > kMaxPartPixels) {
    drops.add("the picture behind the level, which has more than " + std::to_string(kMaxPartPixels) + " px");
    return {};
  }
  ObjectLayer layer{.name = kLdtkBackground, .locked = true, .place = 0};
  layer.extra = Json{{kLdtkLayerKey, kLdtkBackground}}.dump();
  const PicturePart part = part_of(background);
  const Vec2 corner = background.corner - origin;
  const Vec2 size{part.width * background.scale.x, part.height * background.scale.y};
  if (!is_well_sized(corner, size)) {
    drops.add("the picture behind the level, which is too far away or too large");
    return {};
  }
  if (background.repeats || background.scale == Vec2{1, 1}) {
    layer.offset = corner;
    layer.image = LayerImage{background.path, part, background.repeats, background.repeats};
    return layer;
  }
  MapObject object{.form = MapObject::Form::tile, .position = corner + Vec2{0, size.y}, .size = size};
  object.picture = part;
  layer.objects.push_back(std::move(object));
  return layer;
}

bool is_ldtk_background(const ObjectLayer& layer) {
  const Json extra = json_part(layer.extra);
  return extra.is_object() && extra.value(kLdtkLayerKey, Json()) == kLdtkBackground;
}

}  // namespace talus
