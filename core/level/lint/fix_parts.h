// Helpers for the fixes of several rules.
#pragma once

#include <optional>
#include <string>

#include "../single_change.h"

namespace talus {

// "tile 12", in labels.
inline std::string tile_text(int tile) { return "tile " + std::to_string(tile); }

// Returns an edit that puts another tile into one cell.
inline Edit put_tile(const Level& level, Cell cell, TileNumber tile, std::string label) {
  return single_change(std::move(label), CellChange{cell, level.map.tile_at(cell), tile});
}

// Returns an edit that sets all flags of a tile.
inline Edit change_flags(const Level& level, TileNumber tile, FlagSet after, std::string label) {
  return single_change(std::move(label), FlagsChange{SheetId::tiles, tile, level.tile_flags(tile),
                                                     static_cast<std::uint8_t>(after)});
}

// Returns the tile that is drawn so many columns to the right and rows further down on the sheet; empty if
// the sheet ends there.
inline std::optional<TileNumber> beside(const Level& level, int tile, int columns, int rows = 0) {
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  const Cell place = sheet.place_of(tile), there = {place.x + columns, place.y + rows};
  if (!sheet.contains(there)) return std::nullopt;
  return static_cast<TileNumber>(sheet.tile_at(there));
}

}  // namespace talus
