// TileImport: a picture of tiles, until the user has said how it is cut, or cancels.
#pragma once

#include <memory>
#include <string>

#include "file_actions.h"
#include "formats/tilesets/new_tileset.h"

namespace talus {

struct TileImport {
  std::string path;
  bool adds = false;                     // to the open level; else it becomes a new level
  std::shared_ptr<const TileFile> file;  // never null
  Sheet shown;                           // the picture as that of a sheet, for a texture
  TileCut guess;
  int width() const { return file->picture.width; }    // px
  int height() const { return file->picture.height; }  // px
};

// Reads a PNG. wanted: the size of tiles that is likely.
FormatResult<TileImport> read_tile_import(const std::string& path, bool adds, TileSize wanted);
// Why the picture cannot be taken so, as a sentence; empty if it can. map: of the open level.
std::string problem_of(const TileImport& import, const action::ApplyTiles& order);
// A new level with the tiles, or the open level with a tileset more.
FormatResult<Level> level_with(const TileImport& import, const action::ApplyTiles& order, const Level& open);

}  // namespace talus
