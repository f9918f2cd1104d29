#include "prove_scene.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include <talus/level/ground.h>
#include "level/ground_cells.h"
#include "level/lip.h"
#include "level/object_ground.h"
#include "sim/lone_body.h"

namespace talus {
namespace {

constexpr std::array<double, 3> kShares = {1, 0.37, 0.05};  // of the fastest speed
constexpr double kLeastSpeed = 1;                           // px/frame, of bodies without keys
constexpr double kBeyondCell = 2;                           // px; they roll so much further than a cell

RawGround ground_of_any(const Level& level) {
  if (has_object_ground(level)) return ground_of_any(with_object_tiles(level));
  return RawGround(ground_of(level, ground_cells(level)));
}

bool is_same_kind(const ProveBody& a, const ProveBody& b) {
  return a.kind == b.kind && a.size == b.size && a.foot == b.foot;
}

void add_body(std::vector<ProveBody>& bodies, const ProveBody& body) {
  const auto known = std::find_if(bodies.begin(), bodies.end(),
                                  [&](const ProveBody& other) { return is_same_kind(body, other); });
  if (known == bodies.end()) {
    bodies.push_back(body);
  } else {
    known->speed = std::max(known->speed, body.speed);
  }
}

// px/frame, with which a body rolls over a cell, before the grip of the floor stops it, or half a cell a
// frame.
double rolling_speed(const SharedTuning& tuning, int cell) {
  const double kept = (1 - tuning.drift_blend) * tuning.floor_grip;  // in a frame
  const double wanted = (cell + kBeyondCell) * (1 - kept);
  return std::max({kLeastSpeed, std::min(wanted, cell / 2.0), std::abs(tuning.drift_speed)});
}

bool has_conveyors(const Scene& scene) { return scene.ground != nullptr && scene.ground->has_conveyors(); }

std::vector<ProveBody> bodies_of(const Scene& scene) {
  std::vector<ProveBody> bodies;
  for (const SceneItem& item : scene.items) {
    if (item.role != TileRole::ball) continue;
    add_body(bodies, {item.kind, {item.box.w, item.box.h}, item.foot, std::abs(item.velocity.x)});
  }
  return bodies;
}

}  // namespace

ProveScene::ProveScene(const Level& level, const ProveOptions& options) : ground_(ground_of_any(level)) {
  assert(!ground_problem(level));
  const Scene scene = compile_scene(level);
  bodies_ = options.bodies.empty() ? bodies_of(scene) : options.bodies;
  assumes_body_ = bodies_.empty();
  if (assumes_body_) {
    const Vec2 size = new_body_size(BodyKind::player, level.map.tile_size());
    bodies_.push_back({BodyKind::player, size, traits_of(BodyKind::player).foot});
  }
  if (bodies_.size() > kMaxBodies) {
    left_out_ = bodies_.size() - kMaxBodies;
    bodies_.resize(kMaxBodies);
  }
  const double rolling = rolling_speed(scene.tuning.shared, level.map.tile_size().width);
  for (ProveBody& body : bodies_) body.speed = std::max(body.speed, rolling);
  LoneBody tried;
  tried.spawn.kind = BodyKind::player;
  tried.spawn.size = bodies_[0].size;
  lip_ = options.lip > 0 ? options.lip : highest_lip(level.map.tile_size());
  for (const double share : kShares) {
    tried.run_speed = scene.tuning.player.run_speed * share;
    auto slower = std::make_shared<const Scene>(scene_for(tried, scene));
    auto judge = std::make_unique<const Judge>(ground_, slower->tuning, lip_);
    speeds_.push_back({share, std::move(slower), std::move(judge)});
  }
  tried.spawn.kind = BodyKind::ball;
  auto meeting = std::make_shared<const Scene>(scene_for(tried, scene));
  if (!meeting->features.meets || meeting->ground == nullptr) return;
  meeting_ = std::move(meeting);
  meet_judge_ = std::make_unique<const MeetJudge>(ground_, *meeting_, lip_);
}

bool ProveScene::is_same_in(const ProveScene& other, int block) const {
  const RawGround& old = other.ground_;
  if (ground_.columns() != old.columns() || ground_.rows() != old.rows()) return false;
  if (ground_.tile_size() != old.tile_size() || bodies_ != other.bodies_ || lip_ != other.lip_) return false;
  if (speeds_.front().scene->tuning != other.speeds_.front().scene->tuning) return false;
  if (has_conveyors(*speeds_.front().scene) || has_conveyors(*other.speeds_.front().scene)) return false;
  // Trials end before they are so far away.
  const Cell first = first_cell(block);
  const int beyond = 2 * kProveBlock - 1;
  return ground_.is_same_in(old, {first.x - kProveBlock, first.y - kProveBlock},
                            {first.x + beyond, first.y + beyond});
}

std::vector<int> ProveScene::blocks_around(Cell cell) const {
  std::vector<int> all(static_cast<std::size_t>(blocks()));
  std::iota(all.begin(), all.end(), 0);
  const auto distance = [&](int block) {
    const Cell first = first_cell(block);
    return std::max(std::abs(first.x + kProveBlock / 2 - cell.x),
                    std::abs(first.y + kProveBlock / 2 - cell.y));
  };
  std::stable_sort(all.begin(), all.end(), [&](int a, int b) { return distance(a) < distance(b); });
  return all;
}

}  // namespace talus
