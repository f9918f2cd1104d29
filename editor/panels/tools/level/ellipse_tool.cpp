// The ellipse tool: fills the ellipse of a rectangle with the stamp; with Shift outlines it.
#include "cell_shape_tool.h"
#include "edit/map_ellipse.h"
#include "level_tools.h"

namespace talus {
namespace {

class EllipseTool : public CellShapeTool {
  Edit shape(const Session& session, Cell from, Cell to) const override {
    const Choices& choices = session.choices();
    const auto paint = ImGui::GetIO().KeyShift ? outline_ellipse : fill_ellipse;
    return paint(session.level(), spanned(from, to), choices.stamp, choices.selection);
  }
};

}  // namespace

std::unique_ptr<LevelTool> make_ellipse_tool() { return std::make_unique<EllipseTool>(); }

}  // namespace talus
