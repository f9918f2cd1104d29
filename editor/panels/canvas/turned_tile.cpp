#include "turned_tile.h"

#include <utility>

namespace talus {

TurnedTile turned_tile(TileTurn turn, TileSize tile, ImVec2 from, ImVec2 to, const UvRect& uv) {
  // A quarter turn of a tile whose sides differ reaches out of the cell, whose bottom left corner it keeps.
  if (has_flip(turn, TileTurn::diagonal)) {
    const float width = (to.x - from.x) * static_cast<float>(tile.height) / static_cast<float>(tile.width);
    const float height = (to.y - from.y) * static_cast<float>(tile.width) / static_cast<float>(tile.height);
    to.x = from.x + width;
    from.y = to.y - height;
  }
  const auto uv_at = [&](bool right, bool low) {
    if (has_flip(turn, TileTurn::up_down)) low = !low;
    if (has_flip(turn, TileTurn::left_right)) right = !right;
    if (has_flip(turn, TileTurn::diagonal)) std::swap(right, low);
    return ImVec2{right ? uv.to.x : uv.from.x, low ? uv.to.y : uv.from.y};
  };
  return {{from, {to.x, from.y}, to, {from.x, to.y}},
          {uv_at(false, false), uv_at(true, false), uv_at(true, true), uv_at(false, true)}};
}

void draw_map_cell(ImDrawList& list, MapCell cell, TileSize tile, ImVec2 from, ImVec2 to, const Ui& ui,
                   ImU32 color) {
  const TurnedTile shown = turned_tile(cell.turn, tile, from, to, ui.uv_of(cell.tile));
  const auto& [a, b, c, d] = shown.corners;
  const auto& [uv_a, uv_b, uv_c, uv_d] = shown.uvs;
  list.AddImageQuad(ui.sheet(SheetId::tiles), a, b, c, d, uv_a, uv_b, uv_c, uv_d, color);
}

}  // namespace talus
