// The flag brush on the map: sets or clears the chosen flag of the tiles that it passes.
#include "level_tools.h"
#include "panels/flag_brush.h"

namespace talus {
namespace {

class FlagTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override {
    update(use, actions, true, true);
    return brush_.active();
  }
  void drag(const LevelToolUse& use, Actions& actions) override { update(use, actions, false, true); }
  void release(const LevelToolUse& use, Actions& actions) override { update(use, actions, false, false); }

 private:
  void update(const LevelToolUse& use, Actions& actions, bool pressed, bool down) {
    brush_.update(use.session, actions, SheetId::tiles, use.cell, TileOfMap{use.session.level().map}, pressed,
                  down);
  }

  FlagBrush brush_;
};

}  // namespace

std::unique_ptr<LevelTool> make_flag_tool() { return std::make_unique<FlagTool>(); }

}  // namespace talus
