// Images, flags and palette, as TIC-80 has them: two sheets of 256 images of 8x8 pixels in 16 colours.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace talus {

inline constexpr int kCartTileSize = 8;                           // px, side of an image of a sheet
inline constexpr int kTileCount = 256;                            // images in a sheet
inline constexpr int kSheetColumns = 16;                          // images in a row of a sheet
inline constexpr int kSheetSide = kSheetColumns * kCartTileSize;  // px, of the square that a sheet fills
inline constexpr int kColorCount = 16;                            // of a palette
inline constexpr int kFlagCount = 8;                              // of an image

// A colour.
struct Rgb {
  std::uint8_t r = 0;  // red, 0..255
  std::uint8_t g = 0;  // green, 0..255
  std::uint8_t b = 0;  // blue, 0..255
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

using Palette = std::array<Rgb, kColorCount>;  // by index

// Palette indices 0..15, row by row from the top left.
using TileImage = std::array<std::uint8_t, kCartTileSize * kCartTileSize>;

// The two sheets of a level.
enum class SheetId : std::uint8_t { tiles, sprites };  // the map shows tiles

// Images with their flags.
struct Sheet {
  std::array<TileImage, kTileCount> images{};    // by number, row by row on the sheet
  std::array<std::uint8_t, kTileCount> flags{};  // bit n is flag n
  friend bool operator==(const Sheet&, const Sheet&) = default;
};

// TIC-80's default palette, Sweetie 16 by GrafxKid.
Palette default_palette();

}  // namespace talus
