// Images, flags and palette, as TIC-80 has them: two sheets of 256 images of 8x8 pixels in 16 colours.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace talus {

inline constexpr int kTileSize = 8;     // px, side of a tile
inline constexpr int kTileCount = 256;  // images in a sheet
inline constexpr int kSheetColumns = 16;
inline constexpr int kSheetSide = kSheetColumns * kTileSize;  // px, of the square that a sheet fills
inline constexpr int kColorCount = 16;
inline constexpr int kFlagCount = 8;

// The column or the row of the cell that holds a coordinate of px.
inline int cell_of(double px) { return static_cast<int>(std::floor(px / kTileSize)); }

struct Rgb {
  std::uint8_t r = 0, g = 0, b = 0;
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

using Palette = std::array<Rgb, kColorCount>;

// Palette indices 0..15, row by row from the top left.
using TileImage = std::array<std::uint8_t, kTileSize * kTileSize>;

enum class SheetId : std::uint8_t { tiles, sprites };  // the map shows tiles

struct Sheet {
  std::array<TileImage, kTileCount> images{};
  std::array<std::uint8_t, kTileCount> flags{};  // bit n is flag n
  friend bool operator==(const Sheet&, const Sheet&) = default;
};

// TIC-80's default palette, Sweetie 16 by GrafxKid.
Palette default_palette();

}  // namespace talus
