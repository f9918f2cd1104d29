// Handmade PNG files, with palettes and mistakes that no encoder would write.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <talus/level/tileset.h>
#include "zipped.h"

namespace talus {

inline std::string png_u32(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 255);
  return bytes;
}

inline std::string png_chunk(const std::string& type, const std::string& content) {
  const std::string body = type + content;
  const auto crc = crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return png_u32(static_cast<std::uint32_t>(content.size())) + body +
         png_u32(static_cast<std::uint32_t>(crc));
}

// color_type: 2 for RGB, 3 for indices of a palette, 6 for RGB and opacity; 8 bits each.
inline std::string png_header(std::uint32_t width, std::uint32_t height, char color_type) {
  using namespace std::string_literals;
  return "\x89PNG\r\n\x1a\n"s +
         png_chunk("IHDR", png_u32(width) + png_u32(height) + '\x08' + color_type + "\0\0\0"s);
}

// rows: the bytes of each row of pixels.
inline std::string png_of(std::uint32_t width, char color_type, const std::vector<std::string>& rows,
                          const std::vector<Rgb>& palette = {}) {
  std::string bytes = png_header(width, static_cast<std::uint32_t>(rows.size()), color_type), colors, pixels;
  for (const Rgb& c : palette)
    colors += {static_cast<char>(c.r), static_cast<char>(c.g), static_cast<char>(c.b)};
  if (!palette.empty()) bytes += png_chunk("PLTE", colors);
  for (const std::string& row : rows) pixels += '\0' + row;
  return bytes + png_chunk("IDAT", zipped(pixels)) + png_chunk("IEND", "");
}

// Opaque pixels, row by row.
inline std::string rgb_png(std::uint32_t width, const std::vector<Rgb>& pixels) {
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % width == 0) rows.emplace_back();
    rows.back() +=
        {static_cast<char>(pixels[i].r), static_cast<char>(pixels[i].g), static_cast<char>(pixels[i].b)};
  }
  return png_of(width, 2, rows);
}

}  // namespace talus
