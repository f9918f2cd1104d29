// The picker: takes the tiles of a rectangle of the map as the stamp.
#include "edit/stamp.h"
#include "level_tools.h"
#include "panels/canvas/canvas_layers.h"

namespace talus {
namespace {

// How the sheet shows picked tiles: all of them if they lie there as on the map, else the first one.
SpriteArea area_of(const Level& level, const Stamp& stamp) {
  const SheetLayout sheet = level.sheet(SheetId::tiles).layout();
  const Cell place = sheet.place_of(stamp.at(0, 0).tile);
  const CellRect first{place.x, place.y, 1, 1};
  const CellRect all{first.x, first.y, stamp.w, stamp.h};
  return {SheetId::tiles,
          SpriteArea{SheetId::tiles, all}.lies_in_sheet(level) && stamp_of_sheet(sheet, all) == stamp
              ? all
              : first};
}

class PickTool : public LevelTool {
 public:
  void release(const LevelToolUse& use, Actions& actions) override {
    const Level& level = use.session.level();
    if (!level.map.contains(*use.from)) return;
    const Stamp stamp = stamp_of_map(level, use.dragged());
    actions.push_back(action::SelectTiles{area_of(level, stamp)});
    actions.push_back(action::SetStamp{stamp});
    actions.push_back(action::SetMapTool{MapTool::stamp});
  }
  void draw(ImDrawList& list, const LevelToolUse& use) const override {
    if (!use.is_seen()) return;
    const CellRect cells = use.dragged();
    if (use.from) use.ui.view.canvas.hover.dragged = Cell{cells.w, cells.h};
    draw_cell_frame(list, cells, use.view, theme::color(theme::kText), use.ui.px(1));
  }
};

}  // namespace

std::unique_ptr<LevelTool> make_pick_tool() { return std::make_unique<PickTool>(); }

}  // namespace talus
