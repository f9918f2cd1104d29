// By stb, which reads both within the bytes.
#include "stb_picture.h"

#include <cstdlib>
#include <memory>
#include <string>

#include <talus/level/limits.h>

#include "picture_size.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#include <stb_image.h>

namespace talus {
namespace {

const stbi_uc* stb_bytes(std::string_view bytes) { return reinterpret_cast<const stbi_uc*>(bytes.data()); }

}  // namespace

TileSize size_by_stb(std::string_view bytes) {
  int width = 0, height = 0, channels = 0;
  const bool is_known =
      bytes.size() <= kMaxFileBytes && stbi_info_from_memory(stb_bytes(bytes), static_cast<int>(bytes.size()),
                                                             &width, &height, &channels) != 0;
  return is_known && width > 0 && height > 0 ? TileSize{width, height} : TileSize{0, 0};
}

FormatResult<RgbaPicture> read_by_stb(std::string_view bytes, int most_side) {
  const TileSize size = size_by_stb(bytes);
  if (const auto fits = check_picture_size(size, most_side); !fits) return tl::unexpected(fits.error());
  constexpr int kChannels = 4;
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> rgba(
      stbi_load_from_memory(stb_bytes(bytes), static_cast<int>(bytes.size()), &width, &height, &channels,
                            kChannels),
      stbi_image_free);
  if (!rgba)
    return tl::unexpected(FormatError{"", std::string("is a damaged picture: ") + stbi_failure_reason()});
  const std::size_t count =
      std::size_t{kChannels} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return RgbaPicture{width, height, {reinterpret_cast<const char*>(rgba.get()), count}};
}

}  // namespace talus
