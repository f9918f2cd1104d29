// PictureTiles: where the pixels of tiles are in the pictures that they come from.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/level/level.h>
#include "cell_rect.h"

namespace talus {

// A picture in a file.
struct PictureFile {
  std::string path;                // as it was opened
  std::optional<Rgb> transparent;  // the colour of it that is not drawn
};

// The part of a picture that a tile shows.
struct TileSource {
  int file = -1;       // index in PictureTiles::files; -1: see `problem`
  CellRect part = {};  // px of the picture
  Cell corner = {};    // px of the tile, where the part's top left corner is; may be outside
  bool flips_x = false, flips_y = false;  // whether the tile shows it mirrored
  const char* problem = nullptr;          // why it cannot be painted: "its picture is missing"; null: it can
  // The pixel of the picture that the tile shows there; nothing if it shows none.
  std::optional<Cell> pixel_at(int x, int y) const;
  // Whether both show the same part in the same way, if they are of the same file.
  bool shows_alike(const TileSource& other) const {
    return part == other.part && corner == other.corner && flips_x == other.flips_x &&
           flips_y == other.flips_y;
  }
};

struct PictureTiles {
  std::vector<PictureFile> files;
  std::vector<TileSource> tiles;  // by tile of the level; others are of no file

  TileSource of(int tile) const;
  // The index of a file with that path, which is added if there is none.
  int file_at(const std::string& path, const std::optional<Rgb>& transparent);
};

// Those of a level that came from Tiled or LDtk, or of its linked tilesets; never null.
std::shared_ptr<const PictureTiles> picture_tiles_of(const Level& level);

// The colours of a tile as the map shows them, as SheetPicture::rgba: of a sheet in 16 colours the image,
// which fills the tile, with colour 0 as clear.
std::vector<std::uint8_t> shown_rgba(const Level& level, int tile);

}  // namespace talus
