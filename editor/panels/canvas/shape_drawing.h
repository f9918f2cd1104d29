// The shapes of tiles as the overlay "shapes" shows them, on the map and on the sheet.
#pragma once

#include <span>
#include <vector>

#include <talus/level/level.h>
#include "camera.h"
#include "panels/ui/ui.h"

namespace talus {

// The area between a line, px of the screen from left to right, and a level base.
void fill_to_base(ImDrawList& list, const std::vector<ImVec2>& line, float base, ImU32 color);
// One shape whose own tile has its top-left corner at `corner`. tile: px, the tile's size in the level. cell:
// px of the screen, the size that it is drawn with. A shape that stops bodies only from one side is a line;
// other ground is tinted, too; a conveyor has an arrow. color: 0xRRGGBB, of the overlay.
void draw_tile_shape(ImDrawList& list, const TileShape& shape, TileSize tile, ImVec2 corner, ImVec2 cell,
                     std::uint32_t color, const Ui& ui);
// The shapes of all visible cells, of all layers that are ground; nothing if tiles are too small to show a
// shape.
void draw_shapes(ImDrawList& list, const Level& level, const CanvasView& view, std::uint32_t color,
                 const Ui& ui);
// The same for these cells, which must be on the map, however small they are.
void draw_shapes_of(std::span<const Cell> cells, ImDrawList& list, const Level& level, const CanvasView& view,
                    std::uint32_t color, const Ui& ui);
// The shapes of the tiles of the sheet, whose tile 0 is at `corner`.
void draw_sheet_shapes(ImDrawList& list, const Level& level, ImVec2 corner, float cell, std::uint32_t color,
                       const Ui& ui);

}  // namespace talus
