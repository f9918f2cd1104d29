// Parts of pictures in true colour, which a map shows besides the images of its sheet.
#pragma once

#include <cstddef>
#include <map>
#include <memory>

#include <talus/collision/shape.h>
#include <talus/level/tileset.h>

namespace talus {

// A rectangle of a picture, and how it is drawn at a place that has a size.
struct PicturePart {
  std::shared_ptr<const SheetPicture> picture = nullptr;  // null: nothing is drawn
  int x = 0;        // px of the picture, of the left side; the part lies in the picture
  int y = 0;        // px of the picture, of the upper side
  int width = 0;    // px of the picture, at least 1 unless there is none
  int height = 0;   // px of the picture, the same
  int shift_x = 0;  // px of the picture, by which it is drawn right of its place, within kMaxTileGap
  int shift_y = 0;  // px of the picture, by which it is drawn below its place, the same
  bool keeps_ratio =
      false;  // whether it is as large as fits its place, in the middle; else it fills the place
  bool swaps_axes =
      false;               // whether its rows are drawn as columns; a place keeps its bottom left corner then
  bool mirrors_x = false;  // whether it is mirrored left to right, after that
  bool mirrors_y = false;  // whether it is mirrored top to bottom, after that
};
// The same content; pictures are compared by their pixels.
bool operator==(const PicturePart& a, const PicturePart& b);

// A tile that is drawn by a picture of its own, instead of its image on the sheet, which shows as much of it
// as lies in its cell.
struct LargeTile {
  PicturePart part = {};  // has a picture
  TileSize size = {};  // px, of its place, whose bottom left corner is that of the cell; 1..kMaxLargeTileSide
  friend bool operator==(const LargeTile&, const LargeTile&) = default;
};
using LargeTiles = std::map<TileNumber, LargeTile>;  // by the tile

inline constexpr int kMaxLargeTileSide = 4096;  // px, of the place of a large tile
// Pixels of all pictures of large tiles, of objects and of layers together.
inline constexpr std::size_t kMaxPartPixels = std::size_t{1} << 25;

// Whether the numbers of a part are within their ranges, and it lies in its picture. True without a picture.
bool is_valid(const PicturePart& part);

}  // namespace talus
