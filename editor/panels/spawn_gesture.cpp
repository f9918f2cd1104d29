// Placing, moving and throwing bodies.
#include "spawn_gesture.h"

#include <cmath>

#include "curve_drawing.h"
#include "debug/number_text.h"
#include "edit/spawn_tools.h"

namespace talus {
namespace {

// Another one like the chosen body; a player when none is chosen.
Spawn next_spawn(const Session& session, Vec2 at) {
  Spawn spawn;
  spawn.kind = BodyKind::player;
  if (const int like = chosen_spawn(session); like >= 0) {
    const Spawn& chosen = session.level().spawns[static_cast<std::size_t>(like)];
    spawn.kind = chosen.kind;
    spawn.foot = chosen.foot;
    spawn.size = chosen.size;
  }
  spawn.position = {std::floor(at.x / kTileSize) * kTileSize, std::floor(at.y / kTileSize) * kTileSize};
  return spawn;
}

constexpr double kArrowScale = 4;     // px of the arrow for each px/frame, as the velocity overlay has it
constexpr double kHandleReach = 7;    // px of the screen
constexpr double kRestDistance = 10;  // px of the screen, from a body that rests up to the handle

Vec2 centre_of(const Spawn& spawn) { return spawn.position + spawn.size * 0.5; }
Vec2 tip_of(const Spawn& spawn) { return centre_of(spawn) + spawn.velocity * kArrowScale; }

// Where the tip can be taken: over a body that rests, where it does not hide under it.
Vec2 handle_place(const Spawn& spawn, const CanvasView& view) {
  if (spawn.velocity != Vec2{}) return tip_of(spawn);
  return {centre_of(spawn).x, spawn.position.y - kRestDistance / view.zoom};
}

bool is_on(const TileMap& map, Vec2 at) {
  return map.contains(
      {static_cast<int>(std::floor(at.x / kTileSize)), static_cast<int>(std::floor(at.y / kTileSize))});
}

}  // namespace

int chosen_spawn(const Session& session) {
  const Body* body = session.state().find(session.choices().body);
  if (body == nullptr || body->origin.spawn >= static_cast<int>(session.level().spawns.size())) return -1;
  return body->origin.spawn;
}

void SpawnGesture::update(const Session& session, Actions& actions, const CanvasView& view, Vec2 at,
                          bool pressed, bool down) {
  const Level& level = session.level();
  if (pressed) begin(session, actions, view, at);
  if (!down) held_ = -1;
  if (pressed || held_ < 0) return;
  if (held_ >= static_cast<int>(level.spawns.size())) {  // Undo has taken it away
    held_ = -1;
  } else if (pulls_) {
    pull(session, actions, at);
  } else if (is_on(level.map, at)) {
    move(session, actions, at);
  }
}

void SpawnGesture::begin(const Session& session, Actions& actions, const CanvasView& view, Vec2 at) {
  const Level& level = session.level();
  stroke_ = session.next_stroke();
  pulls_ = false;
  if (const int chosen = chosen_spawn(session); chosen >= 0) {
    const Spawn& spawn = level.spawns[static_cast<std::size_t>(chosen)];
    const Vec2 to = handle_place(spawn, view) - at;
    if (std::hypot(to.x, to.y) * view.zoom <= kHandleReach) {
      held_ = chosen;
      pulls_ = true;
      grip_ = at - tip_of(spawn);
      return;
    }
  }
  if (!is_on(level.map, at)) return;
  held_ = spawn_at(level, at);
  if (held_ >= 0) {
    grip_ = at - level.spawns[static_cast<std::size_t>(held_)].position;
    actions.push_back(action::SelectSpawn{held_});
    return;
  }
  const Spawn spawn = next_spawn(session, at);
  held_ = static_cast<int>(level.spawns.size());
  grip_ = at - spawn.position;
  actions.push_back(action::EditLevel{add_spawn(level, spawn), stroke_});
  actions.push_back(action::SelectSpawn{held_});
}

void SpawnGesture::move(const Session& session, Actions& actions, Vec2 at) const {
  Spawn spawn = session.level().spawns[static_cast<std::size_t>(held_)];
  const Vec2 to{std::round(at.x - grip_.x), std::round(at.y - grip_.y)};
  // A hand that does not move leaves a place between pixels as it is.
  if (std::abs(to.x - spawn.position.x) < 1 && std::abs(to.y - spawn.position.y) < 1) return;
  spawn.position = to;
  actions.push_back(action::EditLevel{change_spawn(session.level(), held_, spawn, "Move a body"), stroke_});
}

// The tip keeps to whole px, which are quarters of a px/frame; with Alt it does not.
void SpawnGesture::pull(const Session& session, Actions& actions, Vec2 at) const {
  Spawn spawn = session.level().spawns[static_cast<std::size_t>(held_)];
  const Vec2 arrow = at - grip_ - centre_of(spawn);
  const auto snapped = [free = ImGui::GetIO().KeyAlt](double px) {
    return (free ? weld(px) : std::round(px)) / kArrowScale;
  };
  const Vec2 velocity{snapped(arrow.x), snapped(arrow.y)};
  if (velocity == spawn.velocity) return;
  spawn.velocity = velocity;
  actions.push_back(action::EditLevel{
      change_spawn(session.level(), held_, spawn, "Change a body's velocity at the start"), stroke_});
}

void SpawnGesture::draw(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui, Vec2 at,
                        bool hovered) const {
  const Level& level = session.level();
  const CurvePen pen(list, view, ui.px(2));
  const int chosen = chosen_spawn(session), pointed = hovered && !active() ? spawn_at(level, at) : -1;
  const auto draw_title = [&](int index, std::uint32_t color) {
    const Spawn& spawn = level.spawns[static_cast<std::size_t>(index)];
    const Vec2 corner{spawn.position.x + spawn.size.x, spawn.position.y};
    pen.title(title_of_spawn(level, index), view.to_screen(corner), color);
  };
  if (pointed >= 0 && pointed != chosen) draw_title(pointed, theme::kText);
  if (chosen < 0) return;
  const Spawn& spawn = level.spawns[static_cast<std::size_t>(chosen)];
  const ImVec2 tip = view.to_screen(handle_place(spawn, view));
  const bool still = spawn.velocity == Vec2{};
  if (!still) pen.line(centre_of(spawn), tip_of(spawn), theme::color(theme::kWarning));
  const float radius = ui.px(4);
  list.AddCircleFilled(tip, radius + 1, theme::color(theme::kDark));
  if (still)
    list.AddCircle(tip, radius, theme::color(theme::kWarning), 0, ui.px(2));
  else
    list.AddCircleFilled(tip, radius, theme::color(theme::kWarning));
  ui.place("map/velocity_handle", {tip.x - radius, tip.y - radius}, {tip.x + radius, tip.y + radius});
  const Vec2 to = handle_place(spawn, view) - at;
  const bool on_tip = hovered && std::hypot(to.x, to.y) * view.zoom <= kHandleReach;
  if (pulls_ || on_tip)
    pen.title(short_text(spawn.velocity) + " px/frame", tip, theme::kWarning);
  else
    draw_title(chosen, theme::kAccent);
}

}  // namespace talus
