// PNG pictures: reading small ones with the palette that they come with, and writing.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

// A picture of one opaque colour a pixel, or none.
struct PngPicture {
  int width = 0, height = 0;      // px
  std::vector<Rgb> pixels;        // row by row from the top left
  std::vector<bool> transparent;  // the same; of pixels that are less than half opaque, whose colour is black
  std::vector<Rgb> palette;       // of the file, in its order; empty: it has none

  Rgb at(int x, int y) const { return pixels[index(x, y)]; }
  bool is_transparent(int x, int y) const { return transparent[index(x, y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

inline constexpr int kMaxPngSide = 1024;  // px; larger pictures are refused unread

// A picture as it is, opacity and all.
struct RgbaPicture {
  int width = 0, height = 0;  // px
  std::string bytes;          // four a pixel: red, green, blue, opacity; row by row from the top left
};

inline constexpr std::size_t kPngStart = 8;  // bytes that is_png() looks at
bool is_png(std::string_view bytes);
// The content of the first chunk of this type, four letters; empty when there is none.
FormatResult<std::string_view> find_png_chunk(std::string_view bytes, std::string_view type);
FormatResult<RgbaPicture> read_rgba(std::string_view bytes);
FormatResult<PngPicture> read_png(std::string_view bytes);
FormatResult<PngPicture> load_png(const std::string& path);

// channels: 3 for RGB or 4 with opacity; `bytes` has width*height*channels of them. Never empty, unless the
// memory does not suffice.
std::string encode_png(int width, int height, int channels, const std::uint8_t* bytes);

}  // namespace talus
