// Images, flags, palette and tilesets. As TIC-80 has them: images of 8x8 pixels in 16 colours, and two
// sheets, of 256 images in a cart.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/collision/shape.h>
#include <talus/level/flag_set.h>

namespace talus {

inline constexpr int kCartTileSize = 8;     // px, side of an image of a sheet
inline constexpr int kCartTiles = 256;      // images in a sheet of a cart
inline constexpr int kCartColumns = 16;     // images in a row of a cart's sheet
inline constexpr int kMaxSheetSide = 2048;  // images in a row or a column of a sheet
inline constexpr int kColorCount = 16;      // of a palette

// A colour.
struct Rgb {
  std::uint8_t r = 0;  // red, 0..255
  std::uint8_t g = 0;  // green, 0..255
  std::uint8_t b = 0;  // blue, 0..255
  friend bool operator==(const Rgb&, const Rgb&) = default;
};

// A colour with opacity.
struct Rgba {
  std::uint8_t r = 0;  // red, 0..255
  std::uint8_t g = 0;  // green, 0..255
  std::uint8_t b = 0;  // blue, 0..255
  std::uint8_t a = 0;  // opacity, 0..255; 0: clear
  friend bool operator==(const Rgba&, const Rgba&) = default;
};

using Palette = std::array<Rgb, kColorCount>;  // by index

// Palette indices 0..15, row by row from the top left.
using TileImage = std::array<std::uint8_t, kCartTileSize * kCartTileSize>;

// The two sheets of a level.
enum class SheetId : std::uint8_t { tiles, sprites };  // the map shows tiles

// How the images of a sheet lie on it: row by row, by their numbers.
struct SheetLayout {
  int columns = kCartColumns;  // images in a row, 1..kMaxSheetSide
  int count = kCartTiles;  // images, 1..kMaxTiles, in at most kMaxSheetSide rows; the last row may be shorter
  // How many rows there are, 1 to kMaxSheetSide.
  int rows() const { return (count + columns - 1) / columns; }
  // The place of an image, in columns and rows. tile: 0..count - 1.
  Cell place_of(int tile) const { return {tile % columns, tile / columns}; }
  // The number of the image there; that of no image for a place off the sheet.
  int tile_at(Cell place) const { return place.y * columns + place.x; }
  // Whether there is an image.
  bool contains(Cell place) const {
    return place.x >= 0 && place.y >= 0 && place.x < columns && tile_at(place) < count;
  }
  // The image that is nearest to a place, which may be off the sheet.
  Cell nearest(Cell place) const {
    const Cell last = place_of(count - 1);
    const Cell inside{std::clamp(place.x, 0, columns - 1), std::clamp(place.y, 0, last.y)};
    if (contains(inside)) return inside;
    return last.y > 0 ? Cell{inside.x, last.y - 1} : last;  // the last row is shorter
  }
  friend bool operator==(const SheetLayout&, const SheetLayout&) = default;
};

// 0..255: what is at least so opaque is drawn in 16 colours, too; the rest is colour 0.
inline constexpr int kHalfOpaque = 128;
inline constexpr int kMaxSheetPictureSide = 16'384;        // px, of a picture of a sheet
inline constexpr int kMaxSheetPicturePixels = 16'777'216;  // of a picture of a sheet

// A picture in true colour: of a sheet, or of a layer, an object or a large tile, whose sides may be longer.
struct SheetPicture {
  int width = 0;                   // px, 1..kMaxSheetPictureSide; of others 1..kMaxSheetPicturePixels
  int height = 0;                  // px, the same; at most kMaxSheetPicturePixels together
  std::vector<std::uint8_t> rgba;  // for each pixel red, green, blue, opacity; row by row from the top left
  // The four bytes of a pixel, which must be inside (not checked).
  const std::uint8_t* at(int x, int y) const { return &rgba[4 * (static_cast<std::size_t>(y) * width + x)]; }
  friend bool operator==(const SheetPicture&, const SheetPicture&) = default;
};

// Images with their flags, at first as many as a cart has.
struct Sheet {
  int columns = kCartColumns;                                          // images in a row, 1..kMaxSheetSide
  std::vector<TileImage> images = std::vector<TileImage>(kCartTiles);  // by number; 1 to kMaxTiles
  std::vector<FlagSet> flags = std::vector<FlagSet>(kCartTiles);       // of each image
  // How the images look in true colour, each as large as the map's tiles, at their places on the sheet. Null:
  // as `images` says, which is what carts and 16-colour tools take in any case.
  std::shared_ptr<const SheetPicture> picture;
  int count() const { return static_cast<int>(images.size()); }  // images
  // How the images lie.
  SheetLayout layout() const { return {columns, count()}; }
  friend bool operator==(const Sheet& a, const Sheet& b);  // pictures by their pixels
};

// How a picture is cut into tiles: rows of tiles of one size.
struct TileCut {
  TileSize tile = {};  // px, of a tile in the picture
  int spacing = 0;     // px, between two tiles, 0..kMaxTileGap
  int margin = 0;      // px, around all tiles, 0..kMaxTileGap
  int offset_x = 0;    // px, by which a tile is shown right of its place, within kMaxTileGap
  int offset_y = 0;    // px, by which a tile is shown below its place, the same
  friend bool operator==(const TileCut&, const TileCut&) = default;
};
inline constexpr int kMaxTileGap = 1024;  // px

// The picture on disk that a tileset shows. It is read when the level is opened; its pixels are not stored.
struct TilesetLink {
  std::string path = {};    // absolute, or relative to the folder of the level's file; not empty
  TileCut cut = {};         // where its tiles are
  bool is_missing = false;  // whether it could not be read: numbered boxes stand for its tiles; not stored
  friend bool operator==(const TilesetLink&, const TilesetLink&) = default;
};

// A part of the tiles of a level that belongs together: a rectangle of the sheet of tiles.
struct Tileset {
  std::string name = {};  // for people; may be empty or repeated
  int first = 0;          // the tile in its top left corner
  int count = 1;          // numbers from the first tile to the last one, with those beside the rectangle
  int columns = 1;        // tiles in a row of it, which must end where a row of the sheet ends, or before
  std::optional<TilesetLink> link = {};  // none: the level stores its pixels
  std::string extra = {};                // JSON object of keys that this version does not know, or empty
  friend bool operator==(const Tileset&, const Tileset&) = default;
};
inline constexpr std::size_t kMaxTilesets = 1024;  // of a level

// Why these cannot be the tilesets of a sheet: "[2] reaches beyond the last tile"; nothing if they can. They
// must stand in the order of their tiles, and no two may share a number.
std::optional<std::string> problem_of(const std::vector<Tileset>& tilesets, const SheetLayout& sheet);
// The index of the tileset with a tile; -1 if it belongs to none. tile: of the sheet.
int tileset_with(const std::vector<Tileset>& tilesets, const SheetLayout& sheet, int tile);

// TIC-80's default palette, Sweetie 16 by GrafxKid.
Palette default_palette();

}  // namespace talus
