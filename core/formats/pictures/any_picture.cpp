// Tells kinds of pictures apart by their first bytes. TGA has none of its own, so it comes last.
#include "any_picture.h"

#include "aseprite_picture.h"
#include "gif_picture.h"
#include "jpeg_picture.h"
#include "stb_picture.h"

namespace talus {
namespace {

TileSize size_of_png(std::string_view bytes) {
  constexpr std::size_t kSideBytes = 8;  // bytes
  const auto header = find_png_chunk(bytes, "IHDR");
  if (!header || header->size() < kSideBytes) return {0, 0};
  const auto side_at = [&](std::size_t at) {
    std::size_t side = 0;
    for (std::size_t i = at; i < at + kSideBytes / 2; ++i)
      side = side << 8 | static_cast<std::uint8_t>((*header)[i]);
    return side <= kMaxSheetPicturePixels ? static_cast<int>(side) : 0;
  };
  return {side_at(0), side_at(kSideBytes / 2)};
}

}  // namespace

TileSize size_of_picture(std::string_view bytes) {
  if (is_png(bytes)) return size_of_png(bytes);
  if (is_aseprite(bytes)) return size_of_aseprite(bytes);
  if (is_gif(bytes)) return size_of_gif(bytes);
  return is_jpeg(bytes) ? size_of_jpeg(bytes) : size_by_stb(bytes);
}

FormatResult<RgbaPicture> read_picture(std::string_view bytes, int most_side) {
  if (is_png(bytes)) return read_rgba(bytes, most_side);
  if (is_aseprite(bytes)) return read_aseprite(bytes, most_side);
  if (is_gif(bytes)) return read_gif(bytes, most_side);
  if (is_jpeg(bytes)) return read_jpeg(bytes, most_side);
  if (const TileSize size = size_by_stb(bytes); size.width > 0) return read_by_stb(bytes, most_side);
  return tl::unexpected(FormatError{"", "is no PNG, JPEG, BMP, GIF, TGA or picture of Aseprite"});
}

}  // namespace talus
