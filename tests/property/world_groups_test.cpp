// A table of responses by group gives the same bits as a function with the same answers, although the table
// looks at the candidates of a check only once.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include <talus/collision/world.h>

namespace talus::world_groups_test {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
bool same_bits(Vec2 a, Vec2 b) { return same_bits(a.x, b.x) && same_bits(a.y, b.y); }

bool same_bits(const Collision& a, const Collision& b) {
  return a.item == b.item && a.other == b.other && a.response == b.response && a.overlaps == b.overlaps &&
         same_bits(a.ti, b.ti) && same_bits(a.move, b.move) && same_bits(a.normal, b.normal) &&
         same_bits(a.touch, b.touch) && a.aim.has_value() == b.aim.has_value() &&
         (!a.aim || same_bits(*a.aim, *b.aim));
}

// A floor of tiles, as in a level, with scattered boxes of every group. Coordinates are whole, halves or
// anything, so that flush sides and cell borders occur.
struct Scene {
  World world{24};
  std::vector<ItemId> items;
  std::vector<int> groups{0};  // by ItemId::index
  std::mt19937_64 random;

  explicit Scene(std::uint64_t seed) : random(seed) {
    for (int i = 0; i < 30; ++i) add({i * 8.0, 96, 8, 8}, pick(3));
    for (int i = 0; i < 60; ++i) add({coordinate(240), coordinate(96), 8, 8}, pick(World::kGroupCount));
  }
  void add(Rect rect, int group) {
    items.push_back(world.add(rect, group));
    groups.push_back(group);
  }
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); }
  double in(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(random); }
  double coordinate(double size) {
    const double v = in(0, size);
    const int kind = pick(3);
    return kind == 0 ? std::floor(v / 8) * 8 : kind == 1 ? std::floor(v * 2) / 2 : v;
  }
  // A motion that is short or long, along an axis, zero, or too small to move anything.
  double motion() {
    const double motions[] = {0, in(-6, 6), in(-60, 60), in(-1e-15, 1e-15), 1e-300};
    return motions[pick(5)];
  }
  World::GroupResponses responses() {
    World::GroupResponses all;
    for (Response& response : all) response = static_cast<Response>(pick(5));
    return all;
  }
};

RC_GTEST_PROP(WorldGroups, ATableGivesTheBitsOfAFunction, (std::uint64_t seed)) {
  Scene scene(seed);
  World& world = scene.world;
  std::vector<Collision> by_table, by_function;
  for (int i = 0; i < 400; ++i) {
    const ItemId item =
        scene.items[static_cast<std::size_t>(scene.pick(static_cast<int>(scene.items.size())))];
    const World::GroupResponses responses = scene.responses();
    const auto filter = [&](ItemId, ItemId other) {
      return responses[static_cast<std::size_t>(scene.groups[other.index])];
    };
    const Vec2 goal = world.rect(item).position() + Vec2{scene.motion(), scene.motion()};
    const Vec2 wanted = world.check(item, goal, filter, by_function);
    RC_ASSERT(same_bits(world.check(item, goal, responses, by_table), wanted));
    RC_ASSERT(std::equal(by_table.begin(), by_table.end(), by_function.begin(), by_function.end(),
                         [](const Collision& a, const Collision& b) { return same_bits(a, b); }));
    world.move(item, goal, responses, by_table);
  }
}

RC_GTEST_PROP(WorldGroups, AFreeBoxMovesLikeAnItem, (std::uint64_t seed)) {
  Scene scene(seed);
  World& world = scene.world;
  std::vector<Collision> of_item, of_box;
  for (int i = 0; i < 100; ++i) {
    const Rect box{scene.coordinate(240), scene.coordinate(96), 8, 8};
    const Vec2 goal = box.position() + Vec2{scene.motion(), scene.motion()};
    const World::GroupResponses responses = scene.responses();
    const Vec2 at = world.check(box, goal, responses, of_box);
    const ItemId item = world.add(box);
    RC_ASSERT(same_bits(world.check(item, goal, responses, of_item), at));
    RC_ASSERT(of_item.size() == of_box.size());
    world.remove(item);
  }
}

}  // namespace talus::world_groups_test
