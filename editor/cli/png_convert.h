// Imports a picture into a level, for `talus import`.
#pragma once

#include "command.h"
#include "session/files/png_import.h"

namespace talus {

struct PngIntoLevel {
  std::string picture;         // PNG
  std::string level;           // file of the level that gets the picture
  std::string part = "tiles";  // one of png_part_names()
  int tile = 0;                // 0..255
  bool take_palette = false;
  std::string output;  // written in the format of its name; "-": native, to standard output
};

// The names of PngPart, in order.
std::vector<std::string> png_part_names();

// Reports what has changed, unless the level goes to standard output.
void import_png(CommandContext& context, const PngIntoLevel& import);

// A new level with the tiles of a PNG.
struct LevelFromTiles {
  std::string picture, output;
  std::optional<TileSize> tile = {};  // px; nothing: guessed, with spacing and margin
  int spacing = 0, margin = 0;        // px, 0..kMaxTileGap
  TileSize size = {60, 34};           // of the map, in cells
  bool is_linked = false;             // whether the level shows the PNG instead of a copy
};
void make_level_from_tiles(CommandContext& context, const LevelFromTiles& order);

}  // namespace talus
