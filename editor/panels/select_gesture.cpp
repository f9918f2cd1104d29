// Selecting, moving and pasting cells.
#include "select_gesture.h"

#include <algorithm>

#include "canvas_layers.h"
#include "edit/map_selection.h"

namespace talus {
namespace {

constexpr int kPastedAlpha = 200;

// Where the top-left cell of what is pasted goes, with the mouse on its middle.
Cell corner_of(const Stamp& tiles, Cell cell) {
  return {cell.x - (tiles.w - 1) / 2, cell.y - (tiles.h - 1) / 2};
}

// A line of dashes, upright or level.
void draw_dashes(ImDrawList& list, ImVec2 from, ImVec2 to, float dash, float width) {
  const bool level = from.y == to.y;
  const float end = level ? to.x : to.y;
  bool bright = true;
  for (float at = level ? from.x : from.y; at < end; at += dash, bright = !bright) {
    const float next = std::min(at + dash, end);
    const ImU32 color = bright ? theme::color(theme::kText) : theme::color(theme::kDark);
    if (level)
      list.AddRectFilled({at, from.y}, {next, from.y + width}, color);
    else
      list.AddRectFilled({from.x, at}, {from.x + width, next}, color);
  }
}

}  // namespace

void SelectGesture::update(const Session& session, Actions& actions, Cell cell, bool pressed, bool down) {
  if (pressed) press(session, actions, cell);
  if (drag_ == Drag::none) return;
  if (down) {
    drag_on(session, actions, cell);
  } else {
    release(actions);
    drag_ = Drag::none;
  }
}

void SelectGesture::press(const Session& session, Actions& actions, Cell cell) {
  const Choices& choices = session.choices();
  if (choices.pasted) {
    Edit edit =
        paste_cells(session.level(), corner_of(*choices.pasted, cell), *choices.pasted, choices.selection);
    if (!edit.selection) return;  // beside the map: it goes on hanging at the mouse
    actions.push_back(action::EditLevel{std::move(edit), session.next_stroke()});
    actions.push_back(action::SetPasted{});
    return;
  }
  from_ = cell;
  moved_ = false;
  had_selection_ = choices.selection.has_value();
  leaves_copy_ = ImGui::GetIO().KeyCtrl;
  drag_ = Drag::select;
  if (!choices.selection || !choices.selection->contains(cell)) return;
  drag_ = Drag::move;
  grip_ = {cell.x - choices.selection->x, cell.y - choices.selection->y};
}

void SelectGesture::drag_on(const Session& session, Actions& actions, Cell cell) {
  if (cell == from_ && !moved_) return;
  moved_ = true;
  const auto& selection = session.choices().selection;
  if (drag_ == Drag::select) {
    actions.push_back(action::SelectCells{spanned(from_, cell)});
  } else if (selection) {  // Undo may have taken it away
    const Cell by{cell.x - grip_.x - selection->x, cell.y - grip_.y - selection->y};
    if (by == Cell{0, 0}) return;
    MovedCells moved = move_selection(session.level(), session.history(), *selection, by,
                                      session.next_stroke(), leaves_copy_);
    leaves_copy_ = false;  // the copy goes on as it is
    actions.push_back(action::EditLevel{std::move(moved.edit), moved.stroke});
  }
}

// A click selects the cell, or nothing where there was a selection.
void SelectGesture::release(Actions& actions) const {
  if (moved_ || drag_ == Drag::move) return;
  if (had_selection_)
    actions.push_back(action::SelectCells{});
  else
    actions.push_back(action::SelectCells{spanned(from_, from_)});
}

void SelectGesture::draw_preview(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui,
                                 Cell cell) const {
  const Choices& choices = session.choices();
  if (choices.pasted) {
    const Cell at = corner_of(*choices.pasted, cell);
    const CellRect cells{at.x, at.y, choices.pasted->w, choices.pasted->h};
    draw_stamp(list, *choices.pasted, cells, view, ui, kPastedAlpha);
    draw_selection(list, cells, view, ui);
    ui.view.hover.dragged = Cell{cells.w, cells.h};
    return;
  }
  if (choices.selection && (drag_ == Drag::move || (!active() && choices.selection->contains(cell))))
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  else if (!active())
    draw_cell_frame(list, {cell.x, cell.y, 1, 1}, view, theme::color(theme::kText), ui.px(1));
  if (active() && choices.selection) ui.view.hover.dragged = Cell{choices.selection->w, choices.selection->h};
}

void draw_selection(ImDrawList& list, const CellRect& cells, const CanvasView& view, const Ui& ui) {
  const ImVec2 from = view.to_screen({cells.x * 1.0 * kTileSize, cells.y * 1.0 * kTileSize});
  const ImVec2 to =
      view.to_screen({(cells.x + cells.w) * 1.0 * kTileSize, (cells.y + cells.h) * 1.0 * kTileSize});
  const float width = std::max(1.0f, ui.px(1)), dash = ui.px(4);
  // No more dashes than can be seen.
  const float left = std::max(from.x, view.min.x - dash), right = std::min(to.x, view.max.x + dash);
  const float top = std::max(from.y, view.min.y - dash), bottom = std::min(to.y, view.max.y + dash);
  draw_dashes(list, {left, from.y - width}, {right, from.y - width}, dash, width);
  draw_dashes(list, {left, to.y}, {right, to.y}, dash, width);
  draw_dashes(list, {from.x - width, top}, {from.x - width, bottom}, dash, width);
  draw_dashes(list, {to.x, top}, {to.x, bottom}, dash, width);
}

}  // namespace talus
