#include "bump_solver.h"

#include <algorithm>

#include "mouse.h"

namespace talus {
namespace {

// The velocity after a contact. On a level floor and at a wall it is the article's. On a slope the part along
// the slope is kept, and the part into it is reversed.
Vec2 bounced(Vec2 v, Vec2 normal, const SharedTuning& t) {
  const double out = v.x * normal.x + v.y * normal.y;
  if (out >= 0) return v;
  if (normal.x == 0) return {v.x * t.floor_grip, -(v.y * t.floor_bounce)};
  if (normal.y == 0) return {-(v.x * t.wall_bounce), v.y};
  return v - normal * ((1 + t.slope_bounce) * out);
}

}  // namespace

BumpSolver::BumpSolver(std::shared_ptr<const Scene> scene)
    : WorldSolver(std::move(scene),
                  [this](const World& world, Collision& hit, Rect, Vec2 goal, World::Filter filter,
                         std::vector<Collision>& next) { return respond(world, hit, goal, filter, next); }) {
  has_one_way_ = std::any_of(items().begin(), items().end(),
                             [](const SceneItem& item) { return item.line && item.line->one_way; });
}

// The motion continues from where this leg began, not from where the whole move did: an earlier contact may
// have turned it.
Vec2 BumpSolver::respond(const World& world, Collision& hit, Vec2 goal, World::Filter filter,
                         std::vector<Collision>& next) const {
  Rect from = hit.item_rect;
  SlopeContact contact = meet_slope(entry(hit.other).slope, from, goal);
  if (has_one_way_ && contact.kind == SlopeContact::Kind::surface)
    keep_above_lines(world, hit, goal, filter, contact);
  switch (contact.kind) {
    case SlopeContact::Kind::none:
      hit.response = Response::cross;
      hit.normal = {};
      break;
    case SlopeContact::Kind::surface:
      hit.overlaps = false;
      hit.ti = contact.ti;
      hit.normal = contact.normal;
      hit.touch = contact.touch;
      hit.aim = goal = contact.goal;
      break;
    case SlopeContact::Kind::solid:
      hit.response = Response::slide;
      if (hit.move != Vec2{})
        goal = hit.normal.x != 0 ? Vec2{hit.touch.x, goal.y} : Vec2{goal.x, hit.touch.y};
      hit.aim = goal;
      break;
  }
  if (contact.kind != SlopeContact::Kind::none) from = {hit.touch.x, hit.touch.y, from.w, from.h};
  world.project(hit.item, from, goal, filter, next);
  return goal;
}

// World meets boxes that the body is in by how far it is in them, and each once in a move. Solid ground lifts
// a body out again; below a one-way line it would be lost. So a line that the body would be below at this
// contact comes first, and the way after the contact ends at a line that was met before.
void BumpSolver::keep_above_lines(const World& world, Collision& hit, Vec2 goal, World::Filter filter,
                                  SlopeContact& contact) const {
  const Rect from = hit.item_rect;
  const auto at = [&](Vec2 place) { return Rect{place.x, place.y, from.w, from.h}; };
  const auto line_of = [&](const Collision& other) {
    const bool is_line = other.response == moving()[kSlopeGroup] && entry(other.other).slope.one_way;
    return is_line ? &entry(other.other).slope : nullptr;
  };
  const Slope& slope = entry(hit.other).slope;
  std::vector<Collision> on_the_way;
  world.project(hit.item, from, goal, filter, on_the_way);
  for (const Collision& other : on_the_way) {
    const Slope* line = line_of(other);
    if (line == nullptr || !is_past_line(*line, at(contact.touch))) continue;
    const SlopeContact first = meet_slope(*line, from, goal);
    if (first.kind != SlopeContact::Kind::surface || first.ti >= contact.ti) continue;
    contact = meet_slope(slope, at(first.touch), first.goal);
    if (contact.kind == SlopeContact::Kind::surface) continue;
    contact = first;
    hit.other = other.other;
    hit.other_rect = other.other_rect;
  }
  for (const Collision& met : hits_) {
    const Slope* line = line_of(met);
    if (line == nullptr) continue;
    const SlopeContact again = meet_slope(*line, at(contact.touch), contact.goal);
    if (again.kind == SlopeContact::Kind::surface) contact.goal = again.touch;
  }
}

void BumpSolver::fall(Body& body, Placed& placed) {
  pull(body);
  move(body, placed, body.box.position() + body.velocity);
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (hits_[i].response == Response::cross) continue;
    body.velocity = bounced(body.velocity, hits_[i].normal, tuning());
    note_surface(i);
  }
  limit_velocity(body);
}

void BumpSolver::drag(Body& body, Placed& placed, const Input& input) {
  body.previous = body.box.position();
  move(body, placed, drag_goal(tuning(), body, input));
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (hits_[i].response != Response::cross) note_surface(i);
  }
}

// A contact that turned the body and, on a slope, its place on the slope.
void BumpSolver::note_surface(std::size_t i) {
  ContactRecord* contact = contact_of_hit(i);
  if (contact == nullptr) return;
  contact->handled = true;
  const Collision& hit = hits_[i];
  if (hit.response != moving()[kSlopeGroup]) return;
  const SlopeContact on =
      meet_slope(entry(hit.other).slope, hit.item_rect, hit.item_rect.position() + hit.move);
  contact->slope = {.slope = contact->other,
                    .delta = on.delta,
                    .floor_y = on.floor_y,
                    .placed_y = on.touch.y,
                    .normal = on.normal,
                    .corrected = true};
}

bool BumpSolver::is_grounded(const State& state, int body) {
  synchronise(state);
  const auto found =
      std::find_if(placed().begin(), placed().end(), [&](const Placed& p) { return p.id == body; });
  if (found == placed().end()) return false;
  check(*found, {found->box.x, found->box.y + kGroundReach}, moving(), hits_);
  return std::any_of(hits_.begin(), hits_.end(), [](const Collision& hit) { return hit.normal.y < 0; });
}

}  // namespace talus
