#include "world_solver.h"

#include <algorithm>

#include "../collision/sweep.h"
#include "lerp.h"
#include "mouse.h"

namespace talus {
namespace {

// Cells and boxes of the world that are tested in the time of one unit of work.
constexpr std::int64_t kLooksPerWork = 2;

// Boxes that a record keeps as tested; in a crowd, all of them would fill the memory.
constexpr std::size_t kMaxTested = 2'097'152;

Slope slope_of(const SceneItem& item) {
  if (!item.line) return {item.box, slope_direction(item.role)};
  const GroundLine& line = *item.line;
  return {item.box, line.rises_to_the_right ? 1.0 : -1.0, line.low, line.ceiling, line.one_way};
}

// The side of a cell of the world. Only speed depends on it. If boxes are so large that their cells would
// cost much memory, it is doubled until they cover few enough.
double cell_size_for(const Scene& scene) {
  double size = scene.tuning.shared.cell_size;
  constexpr double kFree = World::kMaxCellsOfItem, kMax = World::kMaxCells / 2;
  const auto covered = [&] {
    double cells = 0;
    for (const SceneItem& item : scene.items)
      cells += std::max((item.box.w / size + 2) * (item.box.h / size + 2) - kFree, 0.0);
    return cells;
  };
  while (covered() > kMax) size *= 2;
  return size;
}

}  // namespace

WorldSolver::WorldSolver(std::shared_ptr<const Scene> scene, World::ResponseFunction slope_response)
    : scene_(std::move(scene)),
      cell_size_(cell_size_for(*scene_)),
      world_(cell_size_),
      slope_response_(std::move(slope_response)),
      moving_{Response::slide, Response::cross, Response::slide},
      bodies_block_(tuning().pairs() != BodyPairs::pass) {
  rebuild(initial_state(*scene_));
}

// Adds everything in map order, so that ties are the article's: bodies take their places among the tiles.
void WorldSolver::rebuild(const State& state) {
  world_ = World(cell_size_);
  if (slope_response_) moving_[kSlopeGroup] = world_.add_response("slope", slope_response_);
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

  for (const SceneItem& item : scene_->items) {
    if (item.role != TileRole::ball) {
      const Slope slope = slope_of(item);
      add(item.box,
          {{item.role, item.cell, 0, item.box}, slope, slope.direction != 0 ? kSlopeGroup : kSolidGroup});
      continue;
    }
    const auto body =
        std::lower_bound(by_start.begin(), by_start.end(), item.origin(),
                         [&](const Body* b, const BodyOrigin& o) { return less(b->origin, o); });
    if (body == by_start.end() || (*body)->origin != item.origin()) continue;
    Placed placed{(*body)->id, {}, (*body)->box};
    if (bodies_block_)
      placed.item = add(placed.box, {{TileRole::ball, item.cell, placed.id, {}}, {}, kBallGroup});
    placed_.push_back(placed);
  }
  std::sort(placed_.begin(), placed_.end(), [](const Placed& a, const Placed& b) { return a.id < b.id; });
  tested_marks_.assign(entries_.size(), 0);
}

ItemId WorldSolver::add(const Rect& box, const Entry& entry) {
  const ItemId item = world_.add(box, entry.group);
  if (entries_.size() <= item.index) entries_.resize(item.index + 1);
  entries_[item.index] = entry;
  return item;
}

void WorldSolver::synchronise(const State& state) {
  const bool same_bodies =
      std::equal(state.bodies.begin(), state.bodies.end(), placed_.begin(), placed_.end(),
                 [](const Body& body, const Placed& placed) { return body.id == placed.id; });
  if (!same_bodies) rebuild(state);
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    if (placed_[i].box != state.bodies[i].box) place(placed_[i], state.bodies[i].box);
  }
  budget_ = StepBudget(state.bodies.size());
}

void WorldSolver::step(State& state, const Input& input, StepRecord* record) {
  if (record != nullptr) record->clear();
  record_ = record != nullptr && !record->only_events ? record : nullptr;
  synchronise(state);
  take_mouse(state, input, [&] { return body_at(state, input.mouse); });
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
  if (record_ != nullptr) record_->work = budget_.spent();
  ++state.frame;
}

// The first ball, in scene order, that contains the point; 0 if there is none.
int WorldSolver::body_at(const State& state, Vec2 point) {
  if (!bodies_block_) {
    const auto found = std::find_if(state.bodies.begin(), state.bodies.end(),
                                    [&](const Body& body) { return contains(sides_of(body.box), point); });
    return found == state.bodies.end() ? 0 : found->id;
  }
  world_.query_point(
      point, [&](ItemId item) { return entries_[item.index].group == kBallGroup; }, under_mouse_);
  return under_mouse_.empty() ? 0 : entries_[under_mouse_.front().index].what.body;
}

void WorldSolver::pull(Body& body) const {
  const SharedTuning& t = tuning();
  body.velocity.y = lerp(body.velocity.y, t.fall_speed, t.fall_blend);
  body.velocity.x = lerp(body.velocity.x, t.drift_speed, t.drift_blend);
}

void WorldSolver::limit_velocity(Body& body) {
  const Vec2 wanted = body.velocity;
  body.velocity = {std::clamp(wanted.x, -kMaxBodySpeed, kMaxBodySpeed),
                   std::clamp(wanted.y, -kMaxBodySpeed, kMaxBodySpeed)};
  if (record_ != nullptr && body.velocity != wanted) record_->paths.back().limited = true;
}

void WorldSolver::move(Body& body, Placed& placed, Vec2 wanted) {
  const Vec2 goal = within_limits(body.box.position(), wanted);
  if (record_ != nullptr) {
    const bool limited = goal != wanted;
    record_->paths.push_back({.body = body.id, .from = body.box, .goal = goal, .to = {}, .limited = limited});
  }
  const auto way = run(placed, goal);
  if (record_ != nullptr) record_->paths.back().cut_short = !way.has_value();
  const Vec2 at = way.value_or(body.box.position());
  body.box.x = at.x;
  body.box.y = at.y;
  place(placed, body.box);
  if (record_ != nullptr) note_contacts(body.id);
}

// Returns the result of look(), which may test no more than is left; nothing, and no hits, if that was too
// little.
template <class Look>
std::optional<Vec2> WorldSolver::within_budget(std::vector<Collision>& hits, Look look) {
  const std::int64_t part = budget_.part();
  if (part == 0) {
    hits.clear();
    return std::nullopt;
  }
  const std::int64_t looks = world_.looks();
  world_.set_most_tests(part);
  const Vec2 at = look();
  budget_.spend(1 + (world_.looks() - looks) / kLooksPerWork);
  if (world_.gave_up()) return std::nullopt;
  return at;
}

// The table and the function give the same answers; the function also records what is tested.
std::optional<Vec2> WorldSolver::run(const Placed& placed, Vec2 goal) {
  if (record_ == nullptr) return check(placed, goal, moving_, hits_);
  return within_budget(hits_, [&] {
    const auto noting = [&](ItemId, ItemId other) {
      note_test(placed.id, other);
      return moving_[entries_[other.index].group];
    };
    return placed.item ? world_.check(placed.item, goal, noting, hits_)
                       : world_.check(placed.box, goal, noting, hits_);
  });
}

std::optional<Vec2> WorldSolver::check(const Placed& placed, Vec2 goal,
                                       const World::GroupResponses& responses, std::vector<Collision>& hits) {
  return within_budget(hits, [&] {
    return placed.item ? world_.check(placed.item, goal, responses, hits)
                       : world_.check(placed.box, goal, responses, hits);
  });
}

void WorldSolver::place(Placed& placed, const Rect& box) {
  placed.box = box;
  if (placed.item) world_.update(placed.item, box);
}

Obstacle WorldSolver::obstacle(ItemId item) const {
  Obstacle what = entries_[item.index].what;
  what.box = world_.rect(item);
  return what;
}

// A body's path is tested again after each response; its candidates are recorded once.
void WorldSolver::note_test(int body, ItemId other) {
  std::uint64_t& mark = tested_marks_[other.index];
  if (mark == test_mark_ || record_->tested.size() == kMaxTested) return;
  mark = test_mark_;
  record_->tested.push_back({body, obstacle(other)});
}

void WorldSolver::note_contacts(int body) {
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

ContactRecord* WorldSolver::contact_of_hit(std::size_t i) {
  if (record_ == nullptr) return nullptr;
  return &record_->contacts[record_->contacts.size() - hits_.size() + i];
}

}  // namespace talus
