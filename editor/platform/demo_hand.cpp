// Goes from ball to ball. Each is lifted along a bow towards the middle of the first screen.
#include "demo_hand.h"

#include <algorithm>

#include <talus/level/tile_map.h>
#include <talus/level/tileset.h>

namespace talus {
namespace {

constexpr std::int64_t kAlone = 240;  // frames, in which the balls fall by themselves
constexpr std::int64_t kRound = 140;  // frames from one ball to the next
constexpr std::int64_t kLift = 60;    // frames, for which a ball is held
constexpr int kStride = 5;            // balls from one to the next, so that they are far from each other
constexpr double kUp = 64, kAside = 56, kTop = 24;  // px: the way of the hand, and how high it goes at most
constexpr double kMiddle = kScreenColumns * kCartTileSize / 2.0;  // px, x of the middle of the screen

}  // namespace

std::optional<action::HoldMouse> DemoHand::next(const State& state) {
  if (state.bodies.empty() || state.frame < kAlone) return std::nullopt;
  const std::int64_t round = (state.frame - kAlone) / kRound, frame = (state.frame - kAlone) % kRound;
  const auto count = static_cast<std::int64_t>(state.bodies.size());
  if (frame < kLift && round != round_) {
    round_ = round;
    from_ = state.bodies[static_cast<std::size_t>(round * kStride % count)].box.center();
  }
  if (!from_) return std::nullopt;
  const bool holds = frame < kLift && round == round_;
  const double share = holds ? static_cast<double>(frame) / kLift : 1;
  const double eased = share * share * (3 - 2 * share);
  const Vec2 at{from_->x + (from_->x < kMiddle ? kAside : -kAside) * eased,
                std::max(from_->y - kUp * eased, std::min(kTop, from_->y))};
  if (!holds) from_.reset();
  return action::HoldMouse{at, holds};
}

}  // namespace talus
