#include "picture_size.h"

#include <cstdint>
#include <string>

namespace talus {

FormatResult<void> check_picture_size(TileSize size, int most_side) {
  const std::string is_large =
      "is " + std::to_string(size.width) + "x" + std::to_string(size.height) + " px, but may have at most ";
  if (size.width < 1 || size.height < 1) return tl::unexpected(FormatError{"", "is an empty picture"});
  if (size.width > most_side || size.height > most_side)
    return tl::unexpected(
        FormatError{"", is_large + std::to_string(most_side) + "x" + std::to_string(most_side) + " px"});
  if (std::int64_t{size.width} * size.height > kMaxSheetPicturePixels)
    return tl::unexpected(FormatError{"", is_large + std::to_string(kMaxSheetPicturePixels) + " px in all"});
  return {};
}

}  // namespace talus
