// What tiles of a level stand for in a project of LDtk, as texts that companions keep (see ldtk_companion.h):
// whole numbers with spaces between.
//
//   uid of the IntGrid's layer, or 0; value, or 0; and for each part, from the lowest: uid of its tileset, 0
//   for a colour; x and y in the tileset's picture; id; side; flips; opacity; colour; x and y in the cell; 1
//   if it is hidden, else 0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ldtk_tiles.h"

namespace talus {

struct LdtkKey {
  struct Part {
    LdtkSource source;
    int x = 0, y = 0;  // px, in the cell
    bool is_hidden = false;
  };
  LdtkCellValue value;
  std::vector<Part> parts;  // from the lowest
};

// By tile. Empty for those that stand for no cell.
std::vector<std::string> ldtk_keys_of(const LdtkTiles& tiles, const LdtkProject& project);
// Nothing if it is no such text, names what the project does not have, or lies off a tile of that size.
std::optional<LdtkKey> read_ldtk_key(const std::string& text, const LdtkProject& project, TileSize tile);

}  // namespace talus
