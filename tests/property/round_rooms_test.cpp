// Circles and boxes in rooms without gravity, compared with a reference that goes from impact to impact.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <talus/level/body_kind.h>
#include "random_ground.h"
#include "reference/round_room.h"
#include "tries.h"
#include "unit/meeting_run.h"

namespace talus::round_rooms_test {

constexpr double kWidth = 200, kHeight = 104;  // px, of the room, whose corner is at 8, 8

Level room(double bounce, double parts) {
  const std::string wall(27, '#'), inside = "#" + std::string(25, '.') + "#";
  Level level = meeting_level({wall, inside, inside, inside, inside, inside, inside, inside, inside, inside,
                               inside, inside, inside, inside, wall},
                              0, bounce);
  level.tuning.exact.substeps = parts;
  return level;
}

// In places of a grid, so that none is inside of another one.
void add_bodies(Level& level, Dice& dice, int count) {
  constexpr double kCell = 24;
  std::vector<Vec2> places;
  for (double y = 8; y + kCell <= 8 + kHeight; y += kCell)
    for (double x = 8; x + kCell <= 8 + kWidth; x += kCell) places.push_back({x, y});
  dice.shuffle(places);
  for (int i = 0; i < count; ++i) {
    const bool is_round = !dice.one_in(3);
    const double side = dice.in(3, 16);
    const Vec2 size{side, is_round ? side : dice.in(3, 16)};
    const Vec2 place = places[static_cast<std::size_t>(i)] + Vec2{dice.in(0.5, 7), dice.in(0.5, 7)};
    const Vec2 velocity{dice.in(-3, 3), dice.in(-3, 3)};
    add_body(level, is_round ? BodyKind::marble : BodyKind::ball, place, velocity, size);
  }
}

reference::RoomBody of_reference(const Spawn& spawn) {
  reference::RoomBody body;
  const double radius = radius_of(spawn.kind, spawn.size);
  body.x = reference::Number(spawn.position.x) - 8 + reference::Number(spawn.size.x) / 2;
  body.y = reference::Number(spawn.position.y) - 8 + reference::Number(spawn.size.y) / 2;
  body.vx = spawn.velocity.x;
  body.vy = spawn.velocity.y;
  body.half_x = radius > 0 ? 0 : reference::Number(spawn.size.x) / 2;
  body.half_y = radius > 0 ? 0 : reference::Number(spawn.size.y) / 2;
  body.radius = radius;
  body.mass = reference::Number(spawn.size.x) * spawn.size.y;
  return body;
}

double distance(const reference::RoomBody& a, const reference::RoomBody& b) {
  return static_cast<double>(std::hypot(a.x - b.x, a.y - b.y));
}

// What a change of 1e-12 px of each body has become says how far rounding may lead. Bodies touch that are
// 1e-9 px apart.
TEST(RoundRooms, GoAsTheReference) {
  const auto last = static_cast<std::uint64_t>(tries("TALUS_ROUND_ROOMS", 60));
  int impacts = 0, compared = 0;
  for (std::uint64_t seed = 1; seed <= last; ++seed) {
    Dice dice(8'000'000 + seed);
    const double bounce = dice.one_in(2) ? 1 : dice.in(0.3, 1);
    Level level = room(bounce, 1 + dice.up_to(3));
    add_bodies(level, dice, 2 + dice.up_to(seed % 4 == 0 ? 28 : 6));
    std::vector<reference::RoomBody> bodies, changed;
    for (const Spawn& spawn : level.spawns) bodies.push_back(of_reference(spawn));
    changed = bodies;
    for (std::size_t i = 0; i < changed.size(); ++i) changed[i].x += i % 2 == 0 ? 1e-12L : -1e-12L;
    reference::Room right(kWidth, kHeight, bounce, bodies), beside(kWidth, kHeight, bounce, changed);
    MeetingRun run(level);
    double chaos = 1e-12;
    for (int frame = 1; frame <= 300 && chaos < 1e-9; ++frame) {
      run.step();
      const int now = right.step();
      impacts += now;
      if (now == reference::Room::kMax || beside.step() == reference::Room::kMax) break;
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const reference::RoomBody& wanted = right.bodies()[i];
        chaos = std::max(chaos, distance(wanted, beside.bodies()[i]));
        const Vec2 middle = run.body(i).box.center();
        const double off = std::hypot(middle.x - 8 - static_cast<double>(wanted.x),
                                      middle.y - 8 - static_cast<double>(wanted.y));
        ASSERT_LE(off, 1e-8 + 1e-9 * frame + 1e4 * chaos)
            << "seed " << seed << ", frame " << frame << ", body " << i + 1;
      }
      ++compared;
    }
  }
  EXPECT_GT(impacts, 2000);
  EXPECT_GT(compared, 3000);
}

}  // namespace talus::round_rooms_test
