// Paints shapes of cells.
#include "cell_shape_tool.h"

#include "panels/canvas/canvas_layers.h"
#include "selection_hint.h"

namespace talus {

void CellShapeTool::release(const LevelToolUse& use, Actions& actions) {
  if (!meets_selection(use.session, actions, use.dragged())) return;
  Edit edit = shape(use.session, *use.from, use.cell);
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit)});
}

void CellShapeTool::draw(ImDrawList& list, const LevelToolUse& use) const {
  constexpr int kAlpha = 150;
  if (!use.is_seen()) return;
  const CellRect cells = use.dragged();
  if (use.from) use.ui.view.canvas.hover.dragged = Cell{cells.w, cells.h};
  draw_painted_cells(list, shape(use.session, use.from.value_or(use.cell), use.cell), use.view, use.ui,
                     kAlpha);
  draw_cell_frame(list, cells, use.view, theme::color(theme::kText), use.ui.px(1));
}

}  // namespace talus
