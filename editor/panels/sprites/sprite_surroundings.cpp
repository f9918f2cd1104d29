// Neighbours and slope lines around the pixel canvas.
#include "sprite_surroundings.h"

#include <algorithm>

namespace talus {
namespace {

constexpr int kDimmed = 110;  // opacity of the neighbours, 0 to 255

// The last place of all these tiles on the map that the mouse was on, if it still is one.
std::optional<Cell> last_place(const Level& level, CellRect tiles, const View& view) {
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  for (int y = 0; y < tiles.h; ++y) {
    for (int x = 0; x < tiles.w; ++x) {
      const auto cell = view.sprites.tile_places.find(sheet.tile_at({tiles.x + x, tiles.y + y}));
      if (cell == view.sprites.tile_places.end()) continue;
      if (const auto place = place_of_tiles(level, tiles, cell->second)) return place;
    }
  }
  return std::nullopt;
}

void draw_tile(ImDrawList& list, int tile, int x, int y, const CanvasView& view, const Ui& ui) {
  const UvRect uv = ui.uv_of(tile);
  list.AddImage(ui.sheet(SheetId::tiles), view.corner_of({x, y}), view.corner_of({x + 1, y + 1}), uv.from,
                uv.to, IM_COL32(255, 255, 255, kDimmed));
}

// The line that bodies stand on or hang from, for a slope whose tile is at (x, y), in tiles of the canvas.
void draw_slope_line(ImDrawList& list, const TileShape& shape, TileSize tile, int x, int y,
                     const CanvasView& view, float scale) {
  if (shape.kind != TileShape::Kind::slope && shape.kind != TileShape::Kind::profile) return;
  const bool floor = shape.side == TileShape::Side::floor;
  const TileSize image = view.tile;  // px of the canvas
  const double left = x * image.width, foot = (y + (floor ? 1 : 0)) * image.height;
  const double step =
      shape.tiles * static_cast<double>(image.width) / static_cast<double>(shape.heights.size() - 1);
  const auto stroke = [&](ImU32 color, float width) {
    for (std::size_t i = 0; i < shape.heights.size(); ++i) {
      const double rise = shape.heights[i] * image.height / tile.height, height = floor ? -rise : rise;
      list.PathLineTo(view.to_screen({left + static_cast<double>(i) * step, foot + height}));
    }
    list.PathStroke(color, ImDrawFlags_None, width);
  };
  const float width = std::max(1.0f, scale * 2);
  stroke(theme::color(theme::kDark, 200), width + 2);
  stroke(theme::color(theme::kAccent), width);
}

void draw_centred(ImDrawList& list, const char* text, ImVec2 middle) {
  const ImVec2 size = size_of_text(text);
  add_text(list, {middle.x - size.x / 2, middle.y - size.y / 2}, theme::color(theme::kMuted), text);
}

}  // namespace

void SpriteSurroundings::draw(ImDrawList& list, const Session& session, const CanvasView& view,
                              const Ui& ui) {
  const Level& level = session.level();
  const SpriteArea& area = session.choices().area;
  const TileNeighbours& around = neighbours(session, ui);
  list.PushClipRect(view.to_screen({-kSurroundings, -kSurroundings}),
                    view.to_screen({area.width() + kSurroundings + 0.0, area.height() + kSurroundings + 0.0}),
                    true);
  const bool known =
      std::any_of(around.ring.begin(), around.ring.end(), [](auto t) { return t.has_value(); });
  const auto for_each = [&](auto visit) {
    for (int y = -1; y <= area.tiles.h; ++y) {
      for (int x = -1; x <= area.tiles.w; ++x) {
        const bool inside = x >= 0 && y >= 0 && x < area.tiles.w && y < area.tiles.h;
        const auto tile = inside ? static_cast<TileNumber>(area.tile_at(level, x, y)) : around.at(x, y);
        if (tile) visit(*tile, x, y, inside);
      }
    }
  };
  for_each([&](TileNumber tile, int x, int y, bool inside) {
    if (!inside) draw_tile(list, tile, x, y, view, ui);
  });
  for_each([&](TileNumber tile, int x, int y, bool) {
    draw_slope_line(list, shape_of_tile(level, tile), level.map.tile_size(), x, y, view, ui.scale);
  });
  if (!known)
    draw_centred(list, "not on the map yet", view.to_screen({area.width() / 2.0, -kSurroundings / 2.0}));
  list.PopClipRect();
}

const TileNeighbours& SpriteSurroundings::neighbours(const Session& session, const Ui& ui) {
  const TileMap& map = session.level().map;
  const CellRect& tiles = session.choices().area.tiles;
  if (const auto place = last_place(session.level(), tiles, ui.view))
    return placed_ = neighbours_at(map, tiles, *place);
  const bool same = counted_ && counted_tiles_ == tiles;
  // The result of a stroke can wait until its end.
  if (!same || (counted_revision_ != session.revision() && !ImGui::IsAnyMouseDown())) {
    counted_ = commonest_neighbours(session.level(), tiles);
    counted_tiles_ = tiles;
    counted_revision_ = session.revision();
  }
  return *counted_;
}

}  // namespace talus
