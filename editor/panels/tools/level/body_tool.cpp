// The body tool: places a body, moves one, or pulls the arrow of its velocity.
#include <cmath>

#include "debug/number_text.h"
#include "edit/spawn_tools.h"
#include "level/single_change.h"
#include "level_tools.h"
#include "overlay/visible.h"
#include "panels/canvas/curve_drawing.h"
#include "panels/inspector/chosen_spawn.h"

namespace talus {
namespace {

constexpr double kArrowScale = 4;     // px of the arrow for each px/frame, as in the velocity overlay
constexpr double kTipReach = 7;       // px of the screen
constexpr double kRestDistance = 10;  // px of the screen, from a resting body up to the handle

// A copy of the chosen body; if none is chosen, a player, or a ball where the solver moves no players.
Spawn next_spawn(const Session& session, Vec2 at) {
  Spawn spawn;
  spawn.kind = session.level().tuning.solver == SolverKind::exact ? BodyKind::player : BodyKind::ball;
  spawn.size = new_body_size(spawn.kind, session.level().map.tile_size());
  if (const int like = chosen_spawn(session); like >= 0) {
    const Spawn& chosen = session.level().spawns[static_cast<std::size_t>(like)];
    spawn.kind = chosen.kind;
    spawn.foot = chosen.foot;
    spawn.size = chosen.size;
  }
  const TileMap& map = session.level().map;
  spawn.position = map.corner_of(map.cell_at(at));
  return spawn;
}

Vec2 centre_of(const Spawn& spawn) { return spawn.position + spawn.size * 0.5; }
Vec2 tip_of(const Spawn& spawn) { return centre_of(spawn) + spawn.velocity * kArrowScale; }

// Where the tip can be grabbed: above a resting body, so that the body does not hide it.
Vec2 handle_place(const Spawn& spawn, const CanvasView& view) {
  if (spawn.velocity != Vec2{}) return tip_of(spawn);
  return {centre_of(spawn).x, spawn.position.y - kRestDistance / view.zoom};
}

bool is_on_tip(const Spawn& spawn, const LevelToolUse& use) {
  const Vec2 to = handle_place(spawn, use.view) - use.at;
  return std::hypot(to.x, to.y) * use.view.zoom <= kTipReach;
}

// Nothing for a body that is out of sight.
void draw_spawn_title(const CurvePen& pen, const LevelToolUse& use, int index, std::uint32_t color) {
  const Level& level = use.session.level();
  const Spawn& spawn = level.spawns[static_cast<std::size_t>(index)];
  if (!meet({spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y}, use.view.visible())) return;
  const Vec2 corner{spawn.position.x + spawn.size.x, spawn.position.y};
  const ImVec2 beside = use.view.to_screen(corner);
  pen.title(title_of_spawn(level, index), beside, color);
  use.ui.place(index == chosen_spawn(use.session) ? "map/chosen_body" : "map/pointed_body", beside, beside);
}

class BodyTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override;
  void drag(const LevelToolUse& use, Actions& actions) override;
  void release(const LevelToolUse&, Actions&) override { let_go(); }
  void cancel(const LevelToolUse& use, Actions& actions) override {
    LevelTool::cancel(use, actions);
    let_go();
  }
  // Draws the arrow of the chosen body, whose tip is registered as "map/velocity_handle", its name, at
  // "map/chosen_body", and, if the mouse is over the canvas, the name of the body under it.
  void draw(ImDrawList& list, const LevelToolUse& use) const override;

 private:
  void let_go() {
    held_ = -1;
    pulls_ = false;
  }
  void move(const LevelToolUse& use, Actions& actions) const;
  void pull(const LevelToolUse& use, Actions& actions) const;
  void draw_arrow(ImDrawList& list, const CurvePen& pen, const Spawn& spawn, const LevelToolUse& use) const;

  int held_ = -1;       // index of the held spawn
  bool pulls_ = false;  // its arrow is held, not its box
  Vec2 grip_;           // px, from its corner, or from the arrow's tip, to the mouse
};

bool BodyTool::press(const LevelToolUse& use, Actions& actions) {
  const Session& session = use.session;
  const Level& level = session.level();
  pulls_ = false;
  if (const int chosen = chosen_spawn(session); chosen >= 0) {
    const Spawn& spawn = level.spawns[static_cast<std::size_t>(chosen)];
    if (is_on_tip(spawn, use)) {
      held_ = chosen;
      pulls_ = true;
      grip_ = use.at - tip_of(spawn);
      return true;
    }
  }
  if (!level.map.contains(use.cell)) return false;
  held_ = spawn_at(level, use.at);
  if (held_ >= 0) {
    grip_ = use.at - level.spawns[static_cast<std::size_t>(held_)].position;
    actions.push_back(action::SelectSpawn{held_});
    return true;
  }
  const Spawn spawn = next_spawn(session, use.at);
  held_ = static_cast<int>(level.spawns.size());
  grip_ = use.at - spawn.position;
  actions.push_back(action::EditLevel{add_spawn(level, spawn), use.stroke});
  actions.push_back(action::SelectSpawn{held_});
  return true;
}

void BodyTool::drag(const LevelToolUse& use, Actions& actions) {
  const Level& level = use.session.level();
  if (held_ >= static_cast<int>(level.spawns.size())) held_ = -1;  // Undo has removed it
  if (held_ < 0) return;
  if (pulls_)
    pull(use, actions);
  else if (level.map.contains(use.cell))
    move(use, actions);
}

void BodyTool::move(const LevelToolUse& use, Actions& actions) const {
  const Level& level = use.session.level();
  Spawn spawn = level.spawns[static_cast<std::size_t>(held_)];
  const Vec2 to{std::round(use.at.x - grip_.x), std::round(use.at.y - grip_.y)};
  // If the hand does not move, a place between pixels stays as it is.
  if (std::abs(to.x - spawn.position.x) < 1 && std::abs(to.y - spawn.position.y) < 1) return;
  spawn.position = to;
  actions.push_back(action::EditLevel{change_spawn(level, held_, spawn, "Move a body"), use.stroke});
}

// The tip stays on whole px, which are quarters of a px/frame; with Alt it does not.
void BodyTool::pull(const LevelToolUse& use, Actions& actions) const {
  const Level& level = use.session.level();
  Spawn spawn = level.spawns[static_cast<std::size_t>(held_)];
  const Vec2 arrow = use.at - grip_ - centre_of(spawn);
  const auto snapped = [free = ImGui::GetIO().KeyAlt](double px) {
    return (free ? weld(px) : std::round(px)) / kArrowScale;
  };
  const Vec2 velocity{snapped(arrow.x), snapped(arrow.y)};
  if (velocity == spawn.velocity) return;
  spawn.velocity = velocity;
  actions.push_back(action::EditLevel{
      change_spawn(level, held_, spawn, "Change a body's velocity at the start"), use.stroke});
}

void BodyTool::draw(ImDrawList& list, const LevelToolUse& use) const {
  if (use.hovered) LevelTool::draw(list, use);
  const Level& level = use.session.level();
  const CurvePen pen(list, use.view, use.ui.px(2));
  const int chosen = chosen_spawn(use.session);
  const int pointed = use.hovered && !use.from ? spawn_at(level, use.at) : -1;
  if (pointed >= 0 && pointed != chosen) draw_spawn_title(pen, use, pointed, theme::kText);
  if (chosen < 0) return;
  const Spawn& spawn = level.spawns[static_cast<std::size_t>(chosen)];
  draw_arrow(list, pen, spawn, use);
  if (pulls_ || (use.hovered && is_on_tip(spawn, use)))
    pen.title(short_text(spawn.velocity) + " px/frame", use.view.to_screen(handle_place(spawn, use.view)),
              theme::kWarning);
  else
    draw_spawn_title(pen, use, chosen, theme::kAccent);
}

void BodyTool::draw_arrow(ImDrawList& list, const CurvePen& pen, const Spawn& spawn,
                          const LevelToolUse& use) const {
  const ImVec2 tip = use.view.to_screen(handle_place(spawn, use.view));
  const ImU32 color = theme::color(theme::kWarning);
  const bool still = spawn.velocity == Vec2{};
  if (!still) pen.line(centre_of(spawn), tip_of(spawn), color);
  const float radius = use.ui.px(4);
  list.AddCircleFilled(tip, radius + 1, theme::color(theme::kDark));
  if (still)
    list.AddCircle(tip, radius, color, 0, use.ui.px(2));
  else
    list.AddCircleFilled(tip, radius, color);
  use.ui.place("map/velocity_handle", {tip.x - radius, tip.y - radius}, {tip.x + radius, tip.y + radius});
}

}  // namespace

std::unique_ptr<LevelTool> make_body_tool() { return std::make_unique<BodyTool>(); }

}  // namespace talus
