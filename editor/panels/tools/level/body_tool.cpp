// The body tool: places a body, moves one, or pulls the arrow of its velocity.
#include <algorithm>
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

constexpr double kArrowScale = 4;  // px of the arrow for each px/frame, as in the velocity overlay
constexpr double kTipReach = 7;    // px of the screen
constexpr const char* kFirstBody = "first body";
constexpr double kRestDistance = 10;  // px of the screen, from a resting body up to the handle

// In the corner of the cell at a place.
Spawn new_spawn(const Level& level, BodyKind kind, Vec2 at) {
  Spawn spawn;
  spawn.kind = kind;
  spawn.size = new_body_size(kind, level.map.tile_size());
  spawn.position = level.map.corner_of(level.map.cell_at(at));
  return spawn;
}

// What a new body is like: the chosen one, else the last one of the kind that was placed last; nothing if
// none was placed yet.
std::optional<Spawn> next_spawn(const Session& session, std::optional<BodyKind> placed, Vec2 at) {
  const std::vector<Spawn>& spawns = session.level().spawns;
  const int chosen = chosen_spawn(session);
  if (chosen >= 0) placed = spawns[static_cast<std::size_t>(chosen)].kind;
  if (!placed) return std::nullopt;
  Spawn spawn = new_spawn(session.level(), *placed, at);
  const auto last =
      std::find_if(spawns.rbegin(), spawns.rend(), [&](const Spawn& s) { return s.kind == *placed; });
  if (last == spawns.rend()) return spawn;
  const Spawn& like = chosen >= 0 ? spawns[static_cast<std::size_t>(chosen)] : *last;
  spawn.foot = like.foot;
  spawn.size = like.size;
  spawn.picture = like.picture;
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

// A corner of its box: 0 and 1 at the top, 0 and 2 at the left.
Vec2 corner_of(const Spawn& spawn, int corner) {
  return {spawn.position.x + (corner % 2 == 1 ? spawn.size.x : 0),
          spawn.position.y + (corner >= 2 ? spawn.size.y : 0)};
}

// Where a corner can be grabbed: outside of a small box, so that there is a place to hold it by.
Vec2 corner_place(const Spawn& spawn, int corner, const CanvasView& view) {
  constexpr double kLeastSide = 4 * kTipReach;  // px of the screen
  const auto outside = [&](double side) { return std::max(0.0, (kLeastSide / view.zoom - side) / 2); };
  const Vec2 off{outside(spawn.size.x), outside(spawn.size.y)};
  return corner_of(spawn, corner) + Vec2{corner % 2 == 1 ? off.x : -off.x, corner >= 2 ? off.y : -off.y};
}

// The corner under the mouse; -1: none.
int corner_at(const Spawn& spawn, const LevelToolUse& use) {
  for (int corner = 0; corner < 4; ++corner) {
    const Vec2 to = corner_place(spawn, corner, use.view) - use.at;
    if (std::max(std::abs(to.x), std::abs(to.y)) * use.view.zoom <= kTipReach) return corner;
  }
  return -1;
}

// The body with a corner elsewhere, at least 1 px from the opposite one, which stays.
Spawn with_corner(Spawn spawn, int corner, Vec2 to) {
  const Vec2 stays = corner_of(spawn, 3 - corner);
  const auto side = [](double from, double there, bool is_after) {
    return std::clamp(is_after ? there - from : from - there, 1.0, kMaxBodySize);
  };
  spawn.size = {side(stays.x, to.x, corner % 2 == 1), side(stays.y, to.y, corner >= 2)};
  spawn.position = {corner % 2 == 1 ? stays.x : stays.x - spawn.size.x,
                    corner >= 2 ? stays.y : stays.y - spawn.size.y};
  return spawn;
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
  // Asks what the first body shall be.
  void rest(const LevelToolUse& use, Actions& actions) override;
  void cancel(const LevelToolUse& use, Actions& actions) override {
    LevelTool::cancel(use, actions);
    let_go();
  }
  // Draws the arrow of the chosen body, whose tip is registered as "map/velocity_handle", its name, at
  // "map/chosen_body", and, if the mouse is over the canvas, the name of the body under it.
  void draw(ImDrawList& list, const LevelToolUse& use) const override;

 private:
  void let_go() {
    held_ = corner_ = -1;
    pulls_ = false;
  }
  void move(const LevelToolUse& use, Actions& actions) const;
  void pull(const LevelToolUse& use, Actions& actions) const;
  void resize(const LevelToolUse& use, Actions& actions) const;
  // The corners that can be dragged, registered as "map/body_corner0" to 3, and what it stands on.
  void draw_box(ImDrawList& list, const CurvePen& pen, const Spawn& spawn, const LevelToolUse& use) const;
  void draw_arrow(ImDrawList& list, const CurvePen& pen, const Spawn& spawn, const LevelToolUse& use) const;

  int held_ = -1;                   // index of the held spawn
  bool pulls_ = false;              // its arrow is held, not its box
  int corner_ = -1;                 // the corner of its box that is held; -1: none
  Vec2 asked_at_;                   // px, where the first body will be
  std::optional<BodyKind> placed_;  // the last one that was placed
  Vec2 grip_;                       // px, from its corner, or from the arrow's tip, to the mouse
};

bool BodyTool::press(const LevelToolUse& use, Actions& actions) {
  const Session& session = use.session;
  const Level& level = session.level();
  pulls_ = false;
  corner_ = -1;
  if (const int chosen = chosen_spawn(session); chosen >= 0) {
    const Spawn& spawn = level.spawns[static_cast<std::size_t>(chosen)];
    if (corner_ = corner_at(spawn, use); corner_ >= 0) {
      held_ = chosen;
      grip_ = use.at - corner_of(spawn, corner_);
      return true;
    }
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
  const std::optional<Spawn> spawn = next_spawn(session, placed_, use.at);
  if (!spawn) {
    asked_at_ = use.at;
    ImGui::OpenPopup(kFirstBody);
    return false;
  }
  placed_ = spawn->kind;
  held_ = static_cast<int>(level.spawns.size());
  grip_ = use.at - spawn->position;
  actions.push_back(action::EditLevel{add_spawn(level, *spawn), use.stroke});
  actions.push_back(action::SelectSpawn{held_});
  return true;
}

void BodyTool::rest(const LevelToolUse& use, Actions& actions) {
  ImGui::SetNextWindowSizeConstraints({use.ui.px(240), 0}, {use.ui.px(240), use.ui.px(240)});
  if (!ImGui::BeginPopup(kFirstBody)) return;
  const Level& level = use.session.level();
  use.ui.hint("What shall it be? The next ones are like it.");
  for (const BodyTraits& traits : body_kinds()) {
    if (menu_item(capitalized(traits.word), traits.word)) {
      placed_ = find_body_kind(traits.word);
      const Spawn spawn = new_spawn(level, *placed_, asked_at_);
      actions.push_back(action::EditLevel{add_spawn(level, spawn)});
      actions.push_back(action::SelectSpawn{static_cast<int>(level.spawns.size())});
    }
    use.ui.item("map/first_body_" + std::string(traits.word), traits.help);
  }
  ImGui::EndPopup();
}

void BodyTool::drag(const LevelToolUse& use, Actions& actions) {
  const Level& level = use.session.level();
  if (held_ >= static_cast<int>(level.spawns.size())) held_ = -1;  // Undo has removed it
  if (held_ < 0) return;
  if (pulls_)
    pull(use, actions);
  else if (corner_ >= 0)
    resize(use, actions);
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

void BodyTool::resize(const LevelToolUse& use, Actions& actions) const {
  const Level& level = use.session.level();
  const Spawn& spawn = level.spawns[static_cast<std::size_t>(held_)];
  const Vec2 to{std::round(use.at.x - grip_.x), std::round(use.at.y - grip_.y)};
  const Vec2 now = corner_of(spawn, corner_);
  if (std::abs(to.x - now.x) < 1 && std::abs(to.y - now.y) < 1) return;
  const Spawn resized = with_corner(spawn, corner_, to);
  if (resized == spawn) return;
  actions.push_back(
      action::EditLevel{change_spawn(level, held_, resized, "Change a body's size"), use.stroke});
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
  draw_box(list, pen, spawn, use);
  draw_arrow(list, pen, spawn, use);
  if (corner_ >= 0)
    pen.title(short_text(spawn.size) + " px", use.view.to_screen(corner_of(spawn, 1)), theme::kWarning);
  else if (pulls_ || (use.hovered && is_on_tip(spawn, use)))
    pen.title(short_text(spawn.velocity) + " px/frame", use.view.to_screen(handle_place(spawn, use.view)),
              theme::kWarning);
  else
    draw_spawn_title(pen, use, chosen, theme::kAccent);
}

void BodyTool::draw_box(ImDrawList& list, const CurvePen& pen, const Spawn& spawn,
                        const LevelToolUse& use) const {
  const double bottom = spawn.position.y + spawn.size.y, middle = spawn.position.x + spawn.size.x / 2;
  const ImU32 color = theme::color(theme::kWarning);
  if (spawn.used_foot() == Foot::centre)
    pen.line({middle, bottom - kRestDistance / 2 / use.view.zoom}, {middle, bottom}, color);
  else
    pen.line({spawn.position.x, bottom}, {spawn.position.x + spawn.size.x, bottom}, color);
  const float half = use.ui.px(3);
  for (int corner = 0; corner < 4; ++corner) {
    const ImVec2 at = use.view.to_screen(corner_place(spawn, corner, use.view));
    const ImVec2 min{at.x - half, at.y - half}, max{at.x + half, at.y + half};
    list.AddRectFilled({min.x - 1, min.y - 1}, {max.x + 1, max.y + 1}, theme::color(theme::kDark));
    list.AddRectFilled(min, max, theme::color(theme::kAccent));
    use.ui.place("map/body_corner" + std::to_string(corner), min, max);
  }
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
