#include "article_solver.h"

#include <algorithm>
#include <cmath>

#include "../collision/sweep.h"

namespace talus {
namespace {

// The article's lerp, in its own order of operations: other forms differ in the last bit.
double lerp(double a, double b, double t) { return ((1 - t) * a) + (t * b); }

// The article leaves slope_normal() out; this is the unit normal pointing up and out of the slope.
Vec2 slope_normal(const Rect& box, double direction) {
  const double length = std::sqrt(box.w * box.w + box.h * box.h);
  return {-direction * box.h / length, -box.w / length};
}

// Groups of items in the world.
enum Group { kSolids, kSlopes, kBalls };

constexpr World::GroupResponses kMoving = {Response::slide, Response::cross, Response::slide};
constexpr World::GroupResponses kProbing = {Response::ignore, Response::cross, Response::ignore};

// A goal within the solver's limits. What is within them is left as it is, to the last bit.
Vec2 within_limits(Vec2 from, Vec2 goal) {
  const auto limit = [](double at, double to) {
    const double reachable = std::clamp(to, at - kMaxBodySpeed, at + kMaxBodySpeed);
    return std::clamp(reachable, -kMaxBodyDistance, kMaxBodyDistance);
  };
  return {limit(from.x, goal.x), limit(from.y, goal.y)};
}

double direction_of(TileRole role) {
  if (role == TileRole::up_slope) return 1;
  if (role == TileRole::down_slope) return -1;
  return 0;
}

}  // namespace

ArticleSolver::ArticleSolver(std::shared_ptr<const Scene> scene)
    : scene_(std::move(scene)),
      world_(scene_->tuning.article.cell_size),
      balls_block_(scene_->tuning.article.balls_block != 0) {
  rebuild(initial_state(*scene_));
}

// Adds everything in map order, so that ties are the article's: the bodies that the scene starts take their
// place among the tiles.
void ArticleSolver::rebuild(const State& state) {
  world_ = World(scene_->tuning.article.cell_size);
  entries_.assign(1, {});
  placed_.clear();
  std::vector<const Body*> by_start(state.bodies.size());
  for (std::size_t i = 0; i < state.bodies.size(); ++i) by_start[i] = &state.bodies[i];
  const auto less = [](const BodyOrigin& a, const BodyOrigin& b) {
    if (a.spawn != b.spawn) return a.spawn < b.spawn;
    return a.cell.x != b.cell.x ? a.cell.x < b.cell.x : a.cell.y < b.cell.y;
  };
  std::sort(by_start.begin(), by_start.end(),
            [&](const Body* a, const Body* b) { return less(a->origin, b->origin); });

  const auto add = [&](const Rect& box, const Entry& entry) {
    const int group = entry.is_slope() ? kSlopes : entry.what.role == TileRole::ball ? kBalls : kSolids;
    const ItemId item = world_.add(box, group);
    if (entries_.size() <= item.index) entries_.resize(item.index + 1);
    entries_[item.index] = entry;
    return item;
  };
  for (const SceneItem& item : scene_->items) {
    if (item.role != TileRole::ball) {
      add(item.box, {{item.role, item.cell, 0, item.box}, direction_of(item.role)});
      continue;
    }
    const auto body =
        std::lower_bound(by_start.begin(), by_start.end(), item.origin(),
                         [&](const Body* b, const BodyOrigin& o) { return less(b->origin, o); });
    if (body == by_start.end() || (*body)->origin != item.origin()) continue;
    Placed placed{(*body)->id, {}, (*body)->box};
    if (balls_block_) placed.item = add(placed.box, {{TileRole::ball, item.cell, placed.id, {}}, 0});
    placed_.push_back(placed);
  }
  std::sort(placed_.begin(), placed_.end(), [](const Placed& a, const Placed& b) { return a.id < b.id; });
  tested_marks_.assign(entries_.size(), 0);
}

// The world is only a cache of the state: whatever differs is brought up to date, so that a step depends on
// nothing but its arguments.
void ArticleSolver::synchronise(const State& state) {
  const bool same_bodies =
      std::equal(state.bodies.begin(), state.bodies.end(), placed_.begin(), placed_.end(),
                 [](const Body& body, const Placed& placed) { return body.id == placed.id; });
  if (!same_bodies) rebuild(state);
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    if (placed_[i].box != state.bodies[i].box) place(placed_[i], state.bodies[i].box);
  }
}

void ArticleSolver::step(State& state, const Input& input, StepRecord* record) {
  record_ = record;
  if (record_ != nullptr) record_->clear();
  synchronise(state);
  take_mouse(state, input);
  for (std::size_t i = 0; i < state.bodies.size(); ++i) {
    Body& body = state.bodies[i];
    ++test_mark_;
    if (body.id == state.grabbed) {
      drag(body, placed_[i], input);
    } else {
      fall(body, placed_[i]);
    }
    if (record_ != nullptr) record_->paths.back().to = body.box;
  }
  ++state.frame;
}

// A pressed button takes the ball under it; a released one throws it with the speed of its last frame.
void ArticleSolver::take_mouse(State& state, const Input& input) {
  if (input.mouse_down) {
    if (state.grabbed == 0) state.grabbed = body_at(state, input.mouse);
    return;
  }
  if (state.grabbed == 0) return;
  for (Body& body : state.bodies) {
    if (body.id == state.grabbed) body.velocity = body.box.position() - body.previous;
  }
  state.grabbed = 0;
}

// The first ball, in scene order, that has the point inside; 0 when there is none.
int ArticleSolver::body_at(const State& state, Vec2 point) {
  if (!balls_block_) {
    const auto found = std::find_if(state.bodies.begin(), state.bodies.end(),
                                    [&](const Body& body) { return contains(sides_of(body.box), point); });
    return found == state.bodies.end() ? 0 : found->id;
  }
  world_.query_point(
      point, [&](ItemId item) { return entries_[item.index].what.role == TileRole::ball; }, under_mouse_);
  return under_mouse_.empty() ? 0 : entries_[under_mouse_.front().index].what.body;
}

void ArticleSolver::fall(Body& body, Placed& placed) {
  const ArticleTuning& t = scene_->tuning.article;
  body.velocity.y = lerp(body.velocity.y, t.fall_speed, t.fall_blend);
  body.velocity.x = lerp(body.velocity.x, t.drift_speed, t.drift_blend);
  move(body, placed, body.box.position() + body.velocity);

  for (std::size_t i = 0; i < hits_.size(); ++i) {
    ContactRecord* contact = contact_of_hit(i);
    if (entries_[hits_[i].other.index].is_slope()) {
      const std::optional<SlopeProbe> probe = settle_on_slope(body, placed, body.velocity.y, contact);
      if (!probe || !probe->corrected) continue;
      body.velocity.x = body.velocity.x + probe->normal.x;
      body.velocity.y = (-body.velocity.y - probe->normal.y) * t.slope_bounce;
      break;
    }
    if (contact != nullptr) contact->handled = true;
    if (hits_[i].normal.y != 0) {
      body.velocity.y = -(body.velocity.y * t.floor_bounce);
      body.velocity.x = body.velocity.x * t.floor_grip;
    }
    if (hits_[i].normal.x != 0) body.velocity.x = -(body.velocity.x * t.wall_bounce);
  }
  const Vec2 wanted = body.velocity;
  body.velocity = {std::clamp(wanted.x, -kMaxBodySpeed, kMaxBodySpeed),
                   std::clamp(wanted.y, -kMaxBodySpeed, kMaxBodySpeed)};
  if (record_ != nullptr && body.velocity != wanted) record_->paths.back().limited = true;
}

void ArticleSolver::drag(Body& body, Placed& placed, const Input& input) {
  const ArticleTuning& t = scene_->tuning.article;
  const Vec2 goal = {lerp(body.box.x, input.mouse.x - t.drag_offset, t.drag_blend),
                     lerp(body.box.y, input.mouse.y - t.drag_offset, t.drag_blend)};
  body.previous = body.box.position();
  move(body, placed, goal);
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    if (!entries_[hits_[i].other.index].is_slope()) continue;
    settle_on_slope(body, placed, t.drag_probe, contact_of_hit(i));
  }
}

void ArticleSolver::move(Body& body, Placed& placed, Vec2 wanted) {
  const Vec2 goal = within_limits(body.box.position(), wanted);
  if (record_ != nullptr) {
    const bool limited = goal != wanted;
    record_->paths.push_back({.body = body.id, .from = body.box, .goal = goal, .to = {}, .limited = limited});
  }
  const Vec2 at = run(body, placed, goal);
  body.box.x = at.x;
  body.box.y = at.y;
  place(placed, body.box);
  if (record_ != nullptr) note_contacts(body.id);
}

// The table and the function say the same; the function also notes what is tested.
Vec2 ArticleSolver::run(const Body& body, const Placed& placed, Vec2 goal) {
  const auto noting = [&](ItemId, ItemId other) {
    note_test(body.id, other);
    return entries_[other.index].is_slope() ? Response::cross : Response::slide;
  };
  if (record_ != nullptr) {
    return placed.item ? world_.check(placed.item, goal, noting, hits_)
                       : world_.check(body.box, goal, noting, hits_);
  }
  return placed.item ? world_.check(placed.item, goal, kMoving, hits_)
                     : world_.check(body.box, goal, kMoving, hits_);
}

void ArticleSolver::place(Placed& placed, const Rect& box) {
  placed.box = box;
  if (placed.item) world_.update(placed.item, box);
}

// The article's slope(obj): looks straight down by `speed` for the first slope that is not met from below,
// and interpolates its floor at the body's centre.
std::optional<SlopeProbe> ArticleSolver::probe_slope(const Body& body, const Placed& placed, double speed) {
  if (!(speed >= 0)) return std::nullopt;
  const Vec2 below{body.box.x, body.box.y + speed};
  if (placed.item) {
    world_.check(placed.item, below, kProbing, slope_hits_);
  } else {
    world_.check(body.box, below, kProbing, slope_hits_);
  }
  const auto hit = std::find_if(slope_hits_.begin(), slope_hits_.end(),
                                [](const Collision& h) { return h.normal.y != 1; });
  if (hit == slope_hits_.end()) return std::nullopt;

  const Entry& slope = entries_[hit->other.index];
  const Rect& box = slope.what.box;
  SlopeProbe probe;
  probe.slope = slope.what;
  probe.delta = std::max(0.0, std::min((body.box.x + body.box.w / 2) - box.x, box.w)) / box.w;
  const double offset = slope.direction > 0 ? lerp(box.h, 0, probe.delta) : lerp(0, box.h, probe.delta);
  const double top = (box.y - box.h) + offset;
  probe.floor_y = top + body.box.h;
  probe.placed_y = std::floor(top);
  probe.normal = slope_normal(box, slope.direction);
  return probe;
}

// Puts the body on the slope's floor when it is below it.
std::optional<SlopeProbe> ArticleSolver::settle_on_slope(Body& body, Placed& placed, double speed,
                                                         ContactRecord* contact) {
  std::optional<SlopeProbe> probe = probe_slope(body, placed, speed);
  if (probe && body.box.y >= probe->placed_y) {
    probe->corrected = true;
    body.box.y = probe->placed_y;
    place(placed, body.box);
  }
  if (contact != nullptr) {
    contact->handled = true;
    contact->slope = probe;
  }
  return probe;
}

Obstacle ArticleSolver::obstacle(ItemId item) const {
  Obstacle what = entries_[item.index].what;
  what.box = world_.rect(item);
  return what;
}

// A body's way is tested again after each response; its candidates are noted once.
void ArticleSolver::note_test(int body, ItemId other) {
  std::uint64_t& mark = tested_marks_[other.index];
  if (mark == test_mark_) return;
  mark = test_mark_;
  record_->tested.push_back({body, obstacle(other)});
}

void ArticleSolver::note_contacts(int body) {
  for (std::size_t i = 0; i < hits_.size(); ++i) {
    const Collision& hit = hits_[i];
    record_->contacts.push_back({.body = body,
                                 .order = static_cast<int>(i),
                                 .other = obstacle(hit.other),
                                 .response = hit.response,
                                 .overlaps = hit.overlaps,
                                 .ti = hit.ti,
                                 .move = hit.move,
                                 .normal = hit.normal,
                                 .touch = hit.touch,
                                 .slope = std::nullopt,
                                 .handled = false});
  }
}

ContactRecord* ArticleSolver::contact_of_hit(std::size_t i) {
  if (record_ == nullptr) return nullptr;
  return &record_->contacts[record_->contacts.size() - hits_.size() + i];
}

}  // namespace talus
