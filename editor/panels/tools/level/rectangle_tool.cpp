// The rectangle tool: fills a rectangle with the stamp, or with its tiles at random; with Shift outlines it.
#include "cell_shape_tool.h"
#include "edit/brush_tools.h"
#include "edit/map_rectangle.h"
#include "level_tools.h"

namespace talus {
namespace {

class RectangleTool : public CellShapeTool {
  Edit shape(const Session& session, Cell from, Cell to) const override {
    const Level& level = session.level();
    const Choices& choices = session.choices();
    const CellRect cells = spanned(from, to);
    if (ImGui::GetIO().KeyShift) return outline_rect(level, cells, choices.stamp, choices.selection);
    if (choices.random_stamp)
      return fill_rect_at_random(level, cells, choices.stamp, choices.random_seed, choices.selection);
    return fill_rect(level, cells, choices.stamp, choices.selection);
  }
};

}  // namespace

std::unique_ptr<LevelTool> make_rectangle_tool() { return std::make_unique<RectangleTool>(); }

}  // namespace talus
