// The search follows states in the order in which they were found, each with every choice of keys.
#include "reach.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace talus {
namespace {

constexpr std::uint8_t kLeft = 1, kRight = 2, kJump = 4;
// In the order of the tries.
constexpr std::array<std::uint8_t, 6> kAllKeys = {0, kLeft, kRight, kJump, kLeft | kJump, kRight | kJump};

Input input_of(std::uint8_t keys) {
  Input input;
  input.left = (keys & kLeft) != 0;
  input.right = (keys & kRight) != 0;
  input.jump = (keys & kJump) != 0;
  return input;
}

Scene without_others(const Scene& scene) {
  Scene alone = scene;
  alone.items.clear();  // the exact solver needs only the ground
  alone.features.pairs = alone.features.meets = false;
  return alone;
}

// The part of the scale that a number is in, from 0; numbers beyond its ends are in the outermost parts.
std::uint64_t part_of(double value, double part, int bits) {
  const double most = std::exp2(bits - 1);
  return static_cast<std::uint64_t>(std::clamp(std::floor(value / part) + most, 0.0, 2 * most - 1));
}

}  // namespace

ReachSearch::ReachSearch(const Scene& scene, const Body& player, ReachOptions options)
    : options_(options),
      scene_(std::make_shared<const Scene>(without_others(scene))),
      solver_(make_solver(scene_)),
      width_(scene.ground ? scene.ground->width() : scene.single_ground->width()),
      height_(scene.ground ? scene.ground->height() : scene.single_ground->height()),
      tile_(scene.ground ? scene.ground->tile_size() : scene.single_ground->tile_size()),
      fastest_x_(std::max({scene.tuning.player.run_speed, std::abs(player.velocity.x), 1.0})),
      fastest_y_(std::max({scene.tuning.player.jump_speed, scene.tuning.player.fall_limit, 1.0})) {
  assert(traits_of(player.kind).takes_keys && options.hold >= 1 && options.hold <= 60);
  assert(options.grain >= 1 && options.grain <= 64 && options.most_states >= 1);
  state_.bodies = {player};
  nodes_.push_back({.position = player.box.position(), .velocity = player.velocity, .gait = player.gait});
  seen_.insert(key_of(player));
  mark(player, {});
}

bool ReachSearch::advance(int states) {
  for (; states > 0 && !finished(); --states) {
    const auto from = static_cast<std::uint32_t>(next_++);
    for (const std::uint8_t keys : kAllKeys) follow(from, keys);
  }
  return finished();
}

std::uint64_t ReachSearch::key_of(const Body& body) const {
  std::uint64_t key = part_of(body.box.x, options_.grain, 26);
  key = key << 25 | part_of(body.box.y, options_.grain, 25);
  // Sixths of the fastest speed, so that standing still is in the middle of one.
  key = key << 4 | part_of(body.velocity.x / fastest_x_ + 1.0 / 12, 1.0 / 6, 4);
  key = key << 4 | part_of(body.velocity.y / fastest_y_ + 1.0 / 12, 1.0 / 6, 4);
  const Gait& gait = body.gait;
  return key << 4 | (gait.grounded ? 8u : 0u) | (gait.jumping ? 4u : 0u) | (gait.jump_held ? 2u : 0u) |
         (gait.coyote > 0 ? 1u : 0u);
}

// Below, left and right of the map there is nothing, so a player would fall for ever.
bool ReachSearch::is_lost(const Body& body) const {
  return body.box.y >= 1.0 * height_ * tile_.height || body.box.right() <= 0 ||
         body.box.x >= 1.0 * width_ * tile_.width;
}

void ReachSearch::follow(std::uint32_t from, std::uint8_t keys) {
  Body& body = state_.bodies.front();
  const Node& start = nodes_[from];
  body.box.x = start.position.x, body.box.y = start.position.y;
  body.velocity = start.velocity;
  body.gait = start.gait;
  body.is_clear = start.is_clear;
  state_.frame = start.frames;
  const Input input = input_of(keys);
  for (int i = 1; i <= options_.hold; ++i) {
    solver_->step(state_, input);
    if (is_lost(body)) return;
    mark(body, {from, keys, static_cast<std::uint8_t>(i)});
  }
  if (is_full() || !seen_.insert(key_of(body)).second) return;
  nodes_.push_back({.position = body.box.position(),
                    .velocity = body.velocity,
                    .gait = body.gait,
                    .is_clear = body.is_clear,
                    .keys = keys,
                    .parent = from,
                    .frames = nodes_[from].frames + options_.hold});
}

void ReachSearch::mark(const Body& body, const Visit& visit) {
  const auto first = [](double at, int side) { return static_cast<int>(std::floor(at / side)); };
  const auto last = [](double end, int side) { return static_cast<int>(std::ceil(end / side)) - 1; };
  const Cell from{first(body.box.x, tile_.width), first(body.box.y, tile_.height)};
  const Cell to{last(body.box.right(), tile_.width), last(body.box.bottom(), tile_.height)};
  for (int y = std::max(from.y, 0); y <= std::min(to.y, height_ - 1); ++y) {
    for (int x = std::max(from.x, 0); x <= std::min(to.x, width_ - 1); ++x)
      visits_.try_emplace(index_of({x, y}), visit);
  }
  const Cell feet{first(body.box.center().x, tile_.width), to.y};
  if (body.gait.grounded && index_of(feet) >= 0) stood_.insert(index_of(feet));
}

std::vector<Input> ReachSearch::way_to(Cell cell) const {
  std::vector<Input> way;
  const auto visit = visits_.find(index_of(cell));
  if (visit == visits_.end()) return way;
  way.assign(visit->second.frames, input_of(visit->second.keys));
  for (std::uint32_t node = visit->second.node; node != 0; node = nodes_[node].parent)
    way.insert(way.end(), static_cast<std::size_t>(options_.hold), input_of(nodes_[node].keys));
  std::reverse(way.begin(), way.end());
  return way;
}

}  // namespace talus
