// The flag brush on the map: sets or clears the chosen flag of the tiles that it passes.
#include "level/tile_color.h"
#include "level_tools.h"
#include "panels/tiles/flag_brush.h"

namespace talus {
namespace {

class FlagTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override {
    first_ = TileOfMap{use.session.level().map}(use.cell);
    update(use, actions, true, true);
    return brush_.active();
  }
  void drag(const LevelToolUse& use, Actions& actions) override { update(use, actions, false, true); }
  void release(const LevelToolUse& use, Actions& actions) override { update(use, actions, false, false); }
  void cancel(const LevelToolUse& use, Actions& actions) override { brush_.cancel(use.session, actions); }
  std::string hint(const LevelToolUse& use) const override {
    const Level& level = use.session.level();
    const auto tile = use.hovered ? TileOfMap{level.map}(use.cell) : std::nullopt;
    if (tile && brush_.active() && is_left_out(level, *tile))
      return "tile " + std::to_string(*tile) + ": left out, as the drag began on a drawn tile";
    return brush_.text(use.session, SheetId::tiles, tile) + (tile ? ", in all its cells" : "");
  }

 private:
  void update(const LevelToolUse& use, Actions& actions, bool pressed, bool down) {
    const Level& level = use.session.level();
    const auto tile_at = [&](Cell cell) {
      const std::optional<int> tile = TileOfMap{level.map}(cell);
      return tile && !is_left_out(level, *tile) ? tile : std::nullopt;
    };
    brush_.update(use.session, actions, SheetId::tiles, use.cell, tile_at, pressed, down);
  }
  // A stroke leaves out empty cells between tiles, unless it began on one.
  bool is_left_out(const Level& level, int tile) const {
    return first_ && ((tile == 0 && *first_ != 0) || (is_blank(level, static_cast<TileNumber>(tile)) &&
                                                      !is_blank(level, static_cast<TileNumber>(*first_))));
  }

  FlagBrush brush_;
  std::optional<int> first_;  // the tile on which the stroke began
};

}  // namespace

std::unique_ptr<LevelTool> make_flag_tool() { return std::make_unique<FlagTool>(); }

}  // namespace talus
