// Pictures of all kinds that maps name. Seeds: tests/fuzz/seeds/*.gif, *.jpg, *.bmp, *.tga
#include "formats/pictures/any_picture.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr int kMaxSide = 256;  // px
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto picture = talus::read_picture(bytes, kMaxSide);
  if (!picture) {
    talus::require_clear(picture.error());
    return 0;
  }
  const talus::TileSize claimed = talus::size_of_picture(bytes);
  talus::require(picture->width == claimed.width && picture->height == claimed.height);
  talus::require(picture->bytes.size() ==
                 4 * static_cast<std::size_t>(picture->width) * static_cast<std::size_t>(picture->height));
  return 0;
}
