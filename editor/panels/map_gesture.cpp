// The map tools' gestures.
#include "map_gesture.h"

#include "canvas_layers.h"
#include "edit/auto_tile.h"
#include "edit/brushes.h"

namespace talus {
namespace {

constexpr int kGhostAlpha = 150;

// Whether the tool works with the rectangle of a drag when the button is released.
bool spans_cells(MapTool tool) {
  return tool == MapTool::line || tool == MapTool::rectangle || tool == MapTool::ellipse ||
         tool == MapTool::pick;
}

// What the sheet shows of picked tiles: all of them where they lie there as on the map, else the first.
SpriteArea area_of(const Stamp& stamp) {
  const CellRect first{stamp.at(0, 0) % kSheetColumns, stamp.at(0, 0) / kSheetColumns, 1, 1};
  const CellRect all{first.x, first.y, stamp.w, stamp.h};
  return {SheetId::tiles, stamp_of_sheet(all) == stamp ? all : first};
}

// What a tool that draws a shape paints; Shift leaves its inside out.
Edit shape_edit(const Session& session, MapTool tool, Cell from, Cell to) {
  const Level& level = session.level();
  const Choices& choices = session.choices();
  const CellRect cells = spanned(from, to);
  const bool outline = ImGui::GetIO().KeyShift;
  if (tool == MapTool::line) return paint_stroke(level, from, from, to, choices.stamp, choices.selection);
  if (tool == MapTool::ellipse)
    return (outline ? outline_ellipse : fill_ellipse)(level, cells, choices.stamp, choices.selection);
  if (choices.random_stamp && !outline)
    return fill_rect_at_random(level, cells, choices.stamp, choices.random_seed, choices.selection);
  return (outline ? outline_rect : fill_rect)(level, cells, choices.stamp, choices.selection);
}

Edit fill_edit(const Session& session, Cell cell) {
  const Level& level = session.level();
  const Choices& choices = session.choices();
  if (ImGui::GetIO().KeyCtrl)
    return replace_tile(level, level.map.at(cell), cell, choices.stamp, choices.selection);
  return flood_fill(level, cell, choices.stamp, choices.selection);
}

// Whether these cells have one that may be painted; says why not.
bool is_in_selection(const Session& session, Actions& actions, CellRect cells) {
  const auto& selection = session.choices().selection;
  if (!selection || shared(*selection, cells)) return true;
  actions.push_back(
      action::ShowMessage{"The tools stay inside the selection: draw there, or press Escape first."});
  return false;
}

}  // namespace

void MapGesture::update(const Session& session, Actions& actions, Cell cell, int pressed) {
  if (pressed != kNoButton && !from_) {
    from_ = last_ = cell;
    button_ = pressed;
    tool_ = pressed == 0 ? session.choices().map_tool : MapTool::pick;
    stroke_ = session.next_stroke();
    press(session, actions, cell);
    paint(session, actions, cell);
  }
  if (!from_) return;
  if (ImGui::GetIO().MouseDown[button_]) {
    if (cell != last_) paint(session, actions, cell);
    last_ = cell;
  } else {
    finish(session, actions);
    from_.reset();
  }
}

void MapGesture::press(const Session& session, Actions& actions, Cell cell) {
  if (tool_ != MapTool::fill || !session.level().map.contains(cell)) return;
  if (!is_in_selection(session, actions, {cell.x, cell.y, 1, 1})) return;
  Edit edit = fill_edit(session, cell);
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit)});
}

void MapGesture::paint(const Session& session, Actions& actions, Cell cell) const {
  if (tool_ != MapTool::stamp && tool_ != MapTool::erase) return;
  const Choices& choices = session.choices();
  const Stamp stamp = tool_ == MapTool::stamp ? choices.stamp : Stamp{};
  Edit edit = tool_ == MapTool::stamp && choices.random_stamp
                  ? paint_random_stroke(session.level(), last_, cell, stamp, choices.random_seed)
                  : paint_stroke(session.level(), *from_, last_, cell, stamp);
  if (tool_ == MapTool::erase) edit.label = "Erase tiles";
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), stroke_});
}

void MapGesture::finish(const Session& session, Actions& actions) const {
  if (!spans_cells(tool_)) return;
  if (tool_ != MapTool::pick) {
    if (!is_in_selection(session, actions, spanned(*from_, last_))) return;
    Edit edit = shape_edit(session, tool_, *from_, last_);
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit)});
  } else if (session.level().map.contains(*from_)) {
    const Stamp stamp = stamp_of_map(session.level(), spanned(*from_, last_));
    actions.push_back(action::SelectTiles{area_of(stamp)});
    actions.push_back(action::SetStamp{stamp});
    actions.push_back(action::SetMapTool{MapTool::stamp});
  }
}

void MapGesture::draw_preview(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui,
                              Cell cell) const {
  const MapTool tool = from_ ? tool_ : session.choices().map_tool;
  const Choices& choices = session.choices();
  const Stamp stamp = choices.random_stamp
                          ? Stamp{1, 1, {random_tile(choices.stamp, cell, choices.random_seed)}}
                          : choices.stamp;
  if (tool == MapTool::pan) return;
  CellRect cells{cell.x, cell.y, 1, 1};
  if (tool == MapTool::stamp) cells = {cell.x, cell.y, stamp.w, stamp.h};
  if (spans_cells(tool) && from_) {
    cells = spanned(*from_, cell);
    ui.view.hover.dragged = Cell{cells.w, cells.h};
  }
  if (tool == MapTool::stamp && !from_) draw_stamp(list, stamp, cells, view, ui, kGhostAlpha);
  if (spans_cells(tool) && tool != MapTool::pick)
    draw_painted_cells(list, shape_edit(session, tool, from_.value_or(cell), cell), view, ui, kGhostAlpha);
  const bool erases = tool == MapTool::erase;
  draw_cell_frame(list, cells, view, theme::color(erases ? theme::kError : theme::kText), ui.px(1));
}

}  // namespace talus
