// A tile's picture as a cell shows it: the corners on the screen, and which places of the picture they show.
#pragma once

#include <imgui.h>
#include <array>

#include <talus/level/tile_turns.h>
#include "panels/ui/ui.h"

namespace talus {

// From the top left clockwise.
struct TurnedTile {
  std::array<ImVec2, 4> corners;
  std::array<ImVec2, 4> uvs;
};
// from, to: the corners of the cell on the screen. tile: the size of the map's tiles.
TurnedTile turned_tile(TileTurn turn, TileSize tile, ImVec2 from, ImVec2 to, const UvRect& uv);

// Draws what a cell holds, from the sheet of tiles.
void draw_map_cell(ImDrawList& list, MapCell cell, TileSize tile, ImVec2 from, ImVec2 to, const Ui& ui,
                   ImU32 color = IM_COL32_WHITE);

}  // namespace talus
