// Where the sheet lies, and choosing on it.
#include "sheet_overlay.h"

#include <algorithm>
#include <cmath>

#include "canvas_layers.h"

namespace talus {
namespace {

struct Place {
  ImVec2 min;
  float cell;  // px of the screen
};

// In the top right corner, as large as fits up to twice the size of the design.
Place place_of(const CanvasView& view, const Ui& ui) {
  const float gap = ui.px(4);
  const float room = std::min(view.max.x - view.min.x, view.max.y - view.min.y) - 2 * gap;
  const float zoom =
      std::clamp(std::floor(room / kSheetSide), 1.0f, std::max(1.0f, std::floor(2 * ui.scale)));
  return {{view.max.x - gap - zoom * kSheetSide, view.min.y + gap}, zoom * kCartTileSize};
}

bool paints_with_stamp(MapTool tool) {
  return tool == MapTool::stamp || tool == MapTool::fill || tool == MapTool::line ||
         tool == MapTool::rectangle || tool == MapTool::ellipse;
}

}  // namespace

bool SheetOverlay::update(const Session& session, Actions& actions, Ui& ui, const CanvasView& view,
                          bool hovered, bool busy) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool asked =
      io.KeyShift && !io.KeyCtrl && !io.KeyAlt && !io.WantTextInput && !ui.view.canvas.cursor.on();
  shown_ = from_ || (asked && hovered && !busy);
  const Place place = place_of(view, ui);
  const Cell tile{static_cast<int>(std::floor((io.MousePos.x - place.min.x) / place.cell)),
                  static_cast<int>(std::floor((io.MousePos.y - place.min.y) / place.cell))};
  const bool on_sheet = tile.x >= 0 && tile.y >= 0 && tile.x < kSheetColumns && tile.y < kSheetColumns;
  has_mouse_ = from_ || (shown_ && on_sheet);
  if (!has_mouse_) return false;
  const Cell there{std::clamp(tile.x, 0, kSheetColumns - 1), std::clamp(tile.y, 0, kSheetColumns - 1)};
  ui.view.canvas.hover = {};
  ui.view.canvas.hover.tile = there.y * kSheetColumns + there.x;
  if (ImGui::IsMouseClicked(0)) {
    from_ = there;
    if (!paints_with_stamp(session.choices().map_tool)) actions.push_back(action::SetMapTool{MapTool::stamp});
  }
  if (from_) actions.push_back(action::SelectTiles{{SheetId::tiles, spanned(*from_, there)}});
  if (!io.MouseDown[0]) from_.reset();
  return true;
}

void SheetOverlay::draw(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui) const {
  if (!shown_) return;
  const Place place = place_of(view, ui);
  const float side = place.cell * kSheetColumns, edge = ui.px(2);
  const ImVec2 max{place.min.x + side, place.min.y + side};
  list.AddRectFilled({place.min.x - edge, place.min.y - edge}, {max.x + edge, max.y + edge},
                     theme::color(theme::kText));
  list.AddRectFilled(place.min, max, theme::color(theme::kDark));
  list.AddImage(ui.sheet(SheetId::tiles), place.min, max);
  const SpriteArea& area = session.choices().area;
  const CanvasView tiles{place.min, max, {place.min.x, place.min.y}, place.cell / kCartTileSize};
  if (area.sheet == SheetId::tiles)
    draw_cell_frame(list, area.tiles, tiles, theme::color(theme::kText), ui.px(1));
  ui.place("map/sheet", place.min, max);
}

}  // namespace talus
