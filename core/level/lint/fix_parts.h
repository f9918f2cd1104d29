// Helpers for the fixes of several rules.
#pragma once

#include <optional>
#include <string>

#include "../single_change.h"

namespace talus {

// "tile 12", in labels.
inline std::string tile_text(int tile) { return "tile " + std::to_string(tile); }

// Returns an edit that puts another tile into one cell.
inline Edit put_tile(const Level& level, Cell cell, std::uint8_t tile, std::string label) {
  return single_change(std::move(label), CellChange{cell, level.map.at(cell), tile});
}

// Returns an edit that sets all flags of a tile.
inline Edit change_flags(const Level& level, std::uint8_t tile, int after, std::string label) {
  return single_change(std::move(label), FlagsChange{SheetId::tiles, tile, level.tile_flags(tile),
                                                     static_cast<std::uint8_t>(after)});
}

// Returns the tile that is drawn `by` places to the right on the sheet; empty if the sheet ends there.
inline std::optional<std::uint8_t> beside(int tile, int by) {
  const int column = tile % kSheetColumns + by;
  if (column < 0 || column >= kSheetColumns) return std::nullopt;
  return static_cast<std::uint8_t>(tile + by);
}

}  // namespace talus
