#include <talus/sim/state.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <tuple>

#include "collision/ground_queries.h"

namespace talus {
namespace {

Body body_at_start(const SceneItem& item, int id) {
  return {.id = id,
          .origin = item.origin(),
          .box = item.box,
          .velocity = item.velocity,
          .previous = item.box.position(),
          .kind = item.kind,
          .foot = item.foot,
          .gait = {}};
}

auto origin_key(const BodyOrigin& origin) {
  return std::make_tuple(origin.spawn, origin.cell.x, origin.cell.y);
}

// Lifts a body that the edited ground has buried so deep that the step would find no way out, or only one
// that is longer than the body.
template <class Real>
void lift_out_of(const BasicTerrain<Real>* ground, Body& body) {
  if (ground == nullptr) return;
  const auto real = [](double px) { return static_cast<Real>(px); };
  const BasicRect<Real> box{real(body.box.x), real(body.box.y), real(body.box.w), real(body.box.h)};
  if (!overlaps_ground(*ground, box, body.foot)) return;
  CastBudget budget{kMaxQueryWork};
  const auto out = way_out(*ground, box, body.foot, &budget);
  if (out && std::abs(out->x) <= box.w && std::abs(out->y) <= box.h) return;
  if (const auto y = free_above(*ground, box, body.foot)) body.box.y = *y;
}

// FNV-1a by Fowler, Noll and Vo, a byte at a time from the lowest, so that byte order does not matter.
void hash_bits(std::uint64_t& hash, std::uint64_t bits) {
  for (int byte = 0; byte < 8; ++byte) {
    hash ^= (bits >> (8 * byte)) & 0xff;
    hash *= 0x100000001b3;
  }
}

}  // namespace

const Body* State::find(int id) const {
  const auto at = std::lower_bound(bodies.begin(), bodies.end(), id,
                                   [](const Body& body, int wanted) { return body.id < wanted; });
  return at != bodies.end() && at->id == id ? &*at : nullptr;
}

State initial_state(const Scene& scene) {
  State state;
  for (const SceneItem& item : scene.items) {
    if (item.role != TileRole::ball) continue;
    state.bodies.push_back(body_at_start(item, state.next_id++));
  }
  return state;
}

State carry_over(const State& state, const Scene& edited) {
  std::map<std::tuple<int, int, int>, const Body*> by_origin;
  for (const Body& body : state.bodies) by_origin.emplace(origin_key(body.origin), &body);

  State next{.frame = state.frame, .bodies = {}, .grabbed = state.grabbed, .next_id = state.next_id};
  for (const SceneItem& item : edited.items) {
    if (item.role != TileRole::ball) continue;
    const auto old = by_origin.find(origin_key(item.origin()));
    next.bodies.push_back(old != by_origin.end() ? *old->second : body_at_start(item, next.next_id++));
    Body& body = next.bodies.back();
    body.kind = item.kind;
    body.foot = item.foot;
    body.is_clear = false;
    lift_out_of(edited.ground.get(), body);
    lift_out_of(edited.single_ground.get(), body);
  }
  std::sort(next.bodies.begin(), next.bodies.end(), [](const Body& a, const Body& b) { return a.id < b.id; });
  if (next.find(next.grabbed) == nullptr) next.grabbed = 0;
  return next;
}

std::uint64_t state_hash(const State& state) {
  std::uint64_t hash = 0xcbf29ce484222325;
  hash_bits(hash, static_cast<std::uint64_t>(state.frame));
  hash_bits(hash, static_cast<std::uint64_t>(state.grabbed));
  for (const Body& body : state.bodies) {
    hash_bits(hash, static_cast<std::uint64_t>(body.id));
    for (double number : {body.box.x, body.box.y, body.velocity.x, body.velocity.y}) {
      hash_bits(hash, std::bit_cast<std::uint64_t>(number));
    }
    if (traits_of(body.kind).shape == BodyShape::circle) {
      hash_bits(hash, std::bit_cast<std::uint64_t>(body.spin));
      hash_bits(hash, std::bit_cast<std::uint64_t>(body.turn));
    }
    if (traits_of(body.kind).takes_keys) {
      const Gait& gait = body.gait;
      hash_bits(hash, static_cast<std::uint64_t>(gait.coyote) << 3 | gait.grounded << 2 | gait.jumping << 1 |
                          std::uint64_t{gait.jump_held});
    }
  }
  return hash;
}

}  // namespace talus
