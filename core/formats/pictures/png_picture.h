// PNG pictures: reads small ones together with their palette, and writes pictures.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

// A picture in which each pixel has one opaque colour, or is transparent.
struct PngPicture {
  int width = 0, height = 0;      // px
  std::vector<Rgb> pixels;        // row by row from the top left
  std::vector<bool> transparent;  // by pixel; whether it is less than half opaque; its colour is black then
  std::vector<Rgb> palette;       // of the file, in its order; empty: the file has none

  Rgb at(int x, int y) const { return pixels[index(x, y)]; }
  bool is_transparent(int x, int y) const { return transparent[index(x, y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

inline constexpr int kMaxPngSide = 1024;  // px; larger pictures are refused without being read

// A picture as it is in the file, with opacity.
struct RgbaPicture {
  int width = 0, height = 0;  // px
  std::string bytes;          // four for each pixel: red, green, blue, opacity; row by row from the top left
};

// The same pixels as layers, tilesets and objects share them.
std::shared_ptr<const SheetPicture> shared_picture(const RgbaPicture& picture);

inline constexpr std::size_t kPngStart = 8;  // bytes that is_png() needs
bool is_png(std::string_view bytes);
// Returns the content of the first chunk of this type (four letters); empty if there is none.
FormatResult<std::string_view> find_png_chunk(std::string_view bytes, std::string_view type);
// most_side: px, 1..kMaxSheetPicturePixels; a picture has at most kMaxSheetPicturePixels in all.
FormatResult<RgbaPicture> read_rgba(std::string_view bytes, int most_side = kMaxPngSide);
FormatResult<PngPicture> read_png(std::string_view bytes);
FormatResult<PngPicture> load_png(const std::string& path);

// channels: 3 for RGB, 4 with opacity. bytes: width*height*channels of them. Returns an empty text only if
// there is not enough memory.
std::string encode_png(int width, int height, int channels, const std::uint8_t* bytes);

}  // namespace talus
