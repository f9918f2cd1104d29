// The selection tool: selects cells, moves the selection (with Ctrl a copy of it), and puts down pasted
// tiles.
#include "edit/map_selection.h"
#include "level_tools.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/canvas/selection_drawing.h"

namespace talus {
namespace {

constexpr int kPastedAlpha = 200;

// The top-left cell of pasted tiles, with the mouse on their middle.
Cell corner_of_pasted(const Stamp& tiles, Cell cell) {
  return {cell.x - (tiles.w - 1) / 2, cell.y - (tiles.h - 1) / 2};
}

class SelectTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override;
  void drag(const LevelToolUse& use, Actions& actions) override;
  void release(const LevelToolUse& use, Actions& actions) override;
  void cancel(const LevelToolUse& use, Actions& actions) override;
  void draw(ImDrawList& list, const LevelToolUse& use) const override;

 private:
  void move_to(Cell corner, const LevelToolUse& use, Actions& actions);
  static void paste(const LevelToolUse& use, Actions& actions);

  bool moves_ = false;              // whether it moves the selection; else it selects
  Cell grip_;                       // from the selection's corner to where the button went down
  bool moved_ = false;              // whether the mouse has left that cell since
  std::optional<CellRect> before_;  // the selection when the button went down
  bool leaves_copy_ = false;
};

bool SelectTool::press(const LevelToolUse& use, Actions& actions) {
  const Choices& choices = use.session.choices();
  if (choices.pasted) {
    paste(use, actions);
    return false;
  }
  moved_ = false;
  before_ = choices.selection;
  leaves_copy_ = ImGui::GetIO().KeyCtrl;
  moves_ = choices.selection && choices.selection->contains(use.cell);
  if (moves_) grip_ = {use.cell.x - choices.selection->x, use.cell.y - choices.selection->y};
  return true;
}

// Beside the map it stays at the mouse.
void SelectTool::paste(const LevelToolUse& use, Actions& actions) {
  const Choices& choices = use.session.choices();
  Edit edit = paste_cells(use.session.level(), corner_of_pasted(*choices.pasted, use.cell), *choices.pasted,
                          choices.selection);
  if (!edit.selection) return;
  actions.push_back(action::EditLevel{std::move(edit), use.stroke});
  actions.push_back(action::SetPasted{});
}

void SelectTool::drag(const LevelToolUse& use, Actions& actions) {
  if (use.cell == *use.from && !moved_) return;
  moved_ = true;
  if (moves_)
    move_to({use.cell.x - grip_.x, use.cell.y - grip_.y}, use, actions);
  else
    actions.push_back(action::SelectCells{use.dragged()});
}

void SelectTool::move_to(Cell corner, const LevelToolUse& use, Actions& actions) {
  const auto& selection = use.session.choices().selection;
  if (!selection) return;  // Undo may have removed it
  const Cell by{corner.x - selection->x, corner.y - selection->y};
  if (by == Cell{0, 0}) return;
  MovedCells moved = move_selection(use.session.level(), use.session.history(), *selection, by,
                                    use.session.next_stroke(), leaves_copy_);
  leaves_copy_ = false;  // the copy goes on as it is
  actions.push_back(action::EditLevel{std::move(moved.edit), moved.stroke});
}

// A click selects the cell or, if there was a selection, clears it.
void SelectTool::release(const LevelToolUse& use, Actions& actions) {
  if (moved_ || moves_) return;
  actions.push_back(before_ ? action::SelectCells{} : action::SelectCells{use.dragged()});
}

// A move may continue an earlier one, which stays: only this one is undone.
void SelectTool::cancel(const LevelToolUse& use, Actions& actions) {
  if (!moved_) return;
  if (moves_)
    move_to({before_->x, before_->y}, use, actions);
  else
    actions.push_back(action::SelectCells{before_});
}

void SelectTool::draw(ImDrawList& list, const LevelToolUse& use) const {
  if (!use.is_seen()) return;
  const Choices& choices = use.session.choices();
  const auto& selection = choices.selection;
  if (choices.pasted) {
    const Cell at = corner_of_pasted(*choices.pasted, use.cell);
    const CellRect cells{at.x, at.y, choices.pasted->w, choices.pasted->h};
    draw_stamp(list, *choices.pasted, cells, use.view, use.ui, kPastedAlpha);
    draw_selection(list, cells, use.view, use.ui);
    use.ui.view.canvas.hover.dragged = Cell{cells.w, cells.h};
    return;
  }
  if (selection && (use.from ? moves_ : selection->contains(use.cell)))
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
  else if (!use.from)
    LevelTool::draw(list, use);
  if (use.from && selection) use.ui.view.canvas.hover.dragged = Cell{selection->w, selection->h};
}

}  // namespace

std::unique_ptr<LevelTool> make_select_tool() { return std::make_unique<SelectTool>(); }

}  // namespace talus
