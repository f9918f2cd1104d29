#include <talus/level/picture_part.h>

#include <algorithm>
#include <tuple>

namespace talus {

bool operator==(const PicturePart& a, const PicturePart& b) {
  const auto numbers = [](const PicturePart& part) {
    return std::tie(part.x, part.y, part.width, part.height, part.shift_x, part.shift_y, part.keeps_ratio,
                    part.swaps_axes, part.mirrors_x, part.mirrors_y);
  };
  if (numbers(a) != numbers(b)) return false;
  return a.picture == b.picture || (a.picture && b.picture && *a.picture == *b.picture);
}

bool is_valid(const PicturePart& part) {
  if (part.picture == nullptr) return true;
  const auto is_shift = [](int px) { return px >= -kMaxTileGap && px <= kMaxTileGap; };
  const auto is_inside = [](int from, int length, int most) {
    return from >= 0 && length >= 1 && from <= most && length <= most - from;
  };
  return is_shift(part.shift_x) && is_shift(part.shift_y) &&
         is_inside(part.x, part.width, part.picture->width) &&
         is_inside(part.y, part.height, part.picture->height);
}

}  // namespace talus
