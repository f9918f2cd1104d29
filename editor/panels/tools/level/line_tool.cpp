// The line tool: paints the stamp along a straight line.
#include "cell_shape_tool.h"
#include "edit/map_stroke.h"
#include "level_tools.h"

namespace talus {
namespace {

class LineTool : public CellShapeTool {
  Edit shape(const Session& session, Cell from, Cell to) const override {
    const Choices& choices = session.choices();
    return paint_stroke(session.level(), from, from, to, choices.stamp, choices.selection);
  }
};

}  // namespace

std::unique_ptr<LevelTool> make_line_tool() { return std::make_unique<LineTool>(); }

}  // namespace talus
