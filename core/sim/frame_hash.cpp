// Five lanes side by side, so that no multiplication waits for the one before it.
#include "frame_hash.h"

#include <array>
#include <bit>

namespace talus {
namespace {

void mix(std::uint64_t& lane, std::uint64_t bits) { lane = std::rotl(lane ^ bits, 29) * 0x9e3779b97f4a7c15; }

std::uint64_t gait_bits(const Gait& gait) {
  return static_cast<std::uint64_t>(gait.coyote) << 3 | gait.grounded << 2 | gait.jumping << 1 |
         std::uint64_t{gait.jump_held};
}

}  // namespace

std::uint64_t frame_hash(const State& state) {
  std::array<std::uint64_t, 5> lanes = {1, 2, 3, 4, 5};
  const auto kinds = body_kinds();
  for (const Body& body : state.bodies) {
    mix(lanes[0], std::bit_cast<std::uint64_t>(body.box.x));
    mix(lanes[1], std::bit_cast<std::uint64_t>(body.box.y));
    mix(lanes[2], std::bit_cast<std::uint64_t>(body.velocity.x));
    mix(lanes[3], std::bit_cast<std::uint64_t>(body.velocity.y));
    const std::uint64_t gait =
        kinds[static_cast<std::size_t>(body.kind)].takes_keys ? gait_bits(body.gait) : 0;
    mix(lanes[4], static_cast<std::uint64_t>(body.id) | gait << 32);
    if (kinds[static_cast<std::size_t>(body.kind)].shape != BodyShape::circle) continue;
    mix(lanes[0], std::bit_cast<std::uint64_t>(body.spin));
    mix(lanes[1], std::bit_cast<std::uint64_t>(body.turn));
  }
  std::uint64_t hash = static_cast<std::uint64_t>(state.grabbed);
  for (const std::uint64_t lane : lanes) mix(hash, lane);
  return hash;
}

}  // namespace talus
