// Where the sheet lies, and choosing on it.
#include "sheet_overlay.h"

#include <algorithm>
#include <cmath>

#include "canvas_layers.h"
#include "panels/inspector/chosen_curve.h"

namespace talus {
namespace {

struct Place {
  ImVec2 min, max;
  float cell;  // px of the screen
};

// In the top right corner, as large as fits up to twice the size of the design.
Place place_of(const CanvasView& view, const Ui& ui) {
  const SheetLayout& sheet = ui.layout(SheetId::tiles);
  const float gap = ui.px(4);
  const float columns = static_cast<float>(sheet.columns), rows = static_cast<float>(sheet.rows());
  const float room =
      std::min((view.max.x - view.min.x - 2 * gap) / columns, (view.max.y - view.min.y - 2 * gap) / rows);
  const float zoom = std::min(room / kCartTileSize, std::max(1.0f, std::floor(2 * ui.scale)));
  const float cell =
      kCartTileSize * (zoom < 1 ? zoom : std::floor(zoom));  // pixels of equal size, if it fits
  const ImVec2 min{view.max.x - gap - cell * columns, view.min.y + gap};
  return {min, {min.x + cell * columns, min.y + cell * rows}, cell};
}

// Whether Shift means something else over the map.
bool uses_shift(MapTool tool) { return draws_curves(tool) || tool == MapTool::object; }

}  // namespace

bool paints_with_stamp(MapTool tool) {
  return tool == MapTool::stamp || tool == MapTool::fill || tool == MapTool::line ||
         tool == MapTool::rectangle || tool == MapTool::ellipse;
}

bool SheetOverlay::update(const Session& session, Actions& actions, Ui& ui, const CanvasView& view,
                          bool hovered, bool busy) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool asked = io.KeyShift && !io.KeyCtrl && !io.KeyAlt && !io.WantTextInput &&
                     !ui.view.canvas.cursor.on() && !uses_shift(session.choices().map_tool);
  shown_ = from_ || (asked && hovered && !busy);
  const Place place = place_of(view, ui);
  const Cell tile{static_cast<int>(std::floor((io.MousePos.x - place.min.x) / place.cell)),
                  static_cast<int>(std::floor((io.MousePos.y - place.min.y) / place.cell))};
  const SheetLayout& sheet = ui.layout(SheetId::tiles);
  has_mouse_ = from_ || (shown_ && sheet.contains(tile));
  if (!has_mouse_) return false;
  const Cell there = sheet.nearest(tile);
  ui.view.canvas.hover = {};
  ui.view.canvas.hover.tile = sheet.tile_at(there);
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
  const float edge = ui.px(2);
  const ImVec2 max = place.max;
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
