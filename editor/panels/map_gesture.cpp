// The map tools' gestures.
#include "map_gesture.h"

#include "canvas_layers.h"

namespace talus {
namespace {

constexpr int kGhostAlpha = 150;

bool selects_a_rectangle(MapTool tool) { return tool == MapTool::rectangle || tool == MapTool::pick; }

// What the sheet shows of picked tiles: all of them where they lie there as on the map, else the first.
SpriteArea area_of(const Stamp& stamp) {
  const CellRect first{stamp.at(0, 0) % kSheetColumns, stamp.at(0, 0) / kSheetColumns, 1, 1};
  const CellRect all{first.x, first.y, stamp.w, stamp.h};
  return {SheetId::tiles, stamp_of_sheet(all) == stamp ? all : first};
}

}  // namespace

void MapGesture::update(const Session& session, Actions& actions, Cell cell, bool pressed, bool down) {
  if (pressed) {
    from_ = last_ = cell;
    stroke_ = session.next_stroke();
    if (session.choices().map_tool == MapTool::fill && session.level().map.contains(cell))
      actions.push_back(action::EditLevel{flood_fill(session.level(), cell, session.choices().stamp)});
  }
  if (!from_) return;
  if (down) {
    if (pressed || cell != last_) paint(session, actions, cell);
    last_ = cell;
  } else {
    finish(session, actions);
    from_.reset();
  }
}

void MapGesture::paint(const Session& session, Actions& actions, Cell cell) {
  const MapTool tool = session.choices().map_tool;
  if (tool != MapTool::stamp && tool != MapTool::erase) return;
  const Stamp stamp = tool == MapTool::stamp ? session.choices().stamp : Stamp{};
  Edit edit = paint_stroke(session.level(), *from_, last_, cell, stamp);
  if (tool == MapTool::erase) edit.label = "Erase tiles";
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), stroke_});
}

void MapGesture::finish(const Session& session, Actions& actions) {
  const MapTool tool = session.choices().map_tool;
  const CellRect cells = spanned(*from_, last_);
  if (tool == MapTool::rectangle) {
    Edit edit = fill_rect(session.level(), cells, session.choices().stamp);
    if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit)});
  } else if (tool == MapTool::pick && session.level().map.contains(*from_)) {
    const Stamp stamp = stamp_of_map(session.level(), cells);
    actions.push_back(action::SelectTiles{area_of(stamp)});
    actions.push_back(action::SetStamp{stamp});
    actions.push_back(action::SetMapTool{MapTool::stamp});
  }
}

void MapGesture::draw_preview(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui,
                              Cell cell) const {
  const MapTool tool = session.choices().map_tool;
  const Stamp& stamp = session.choices().stamp;
  if (tool == MapTool::pan) return;
  CellRect cells{cell.x, cell.y, 1, 1};  // of the body tool: where a new one goes
  if (tool == MapTool::stamp) cells = {cell.x, cell.y, stamp.w, stamp.h};
  if (selects_a_rectangle(tool) && from_) cells = spanned(*from_, cell);
  if (tool == MapTool::stamp && !from_) draw_stamp(list, stamp, cells, view, ui, kGhostAlpha);
  if (tool == MapTool::rectangle) draw_stamp(list, stamp, cells, view, ui, kGhostAlpha);
  const bool erases = tool == MapTool::erase;
  draw_cell_frame(list, cells, view, theme::color(erases ? theme::kError : theme::kText), ui.px(1));
}

}  // namespace talus
