// Properties of the collision world over random scenes: the early reject and the broad phase change nothing,
// x and y are treated alike, and the order of adding does not matter.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <talus/collision/world.h>
#include "collision/sweep.h"

namespace talus::world_property_test {

constexpr auto kSlide = [](ItemId, ItemId) { return Response::slide; };

// rapidcheck picks the seed, so that one number names a failure and repeats it.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double in(double lo, double hi) { return std::uniform_real_distribution<double>(lo, hi)(engine_); }
  int up_to(int last) { return std::uniform_int_distribution<int>(0, last)(engine_); }
  Rect rect(double area) { return {in(-area, area), in(-area, area), in(0.5, 30), in(0.5, 30)}; }
  template <class T>
  void shuffle(std::vector<T>& values) {
    std::shuffle(values.begin(), values.end(), engine_);
  }

 private:
  std::mt19937_64 engine_;
};

// A value equal to `v`, a few units in the last place beside it, or off by about the tolerance of the sweep.
double near(Random& random, double v) {
  switch (random.up_to(3)) {
    case 0:
      return v;
    case 1:
      return v + random.in(-4, 4) * kDelta;
    case 2:
      return v * (1 + random.in(-3, 3) * kDelta);
    default:
      for (int i = random.up_to(3); i > 0; --i) v = std::nextafter(v, random.up_to(1) ? 1e300 : -1e300);
      return v;
  }
}

// One axis of a sweep whose boxes touch or nearly touch, at the start or at the end of the motion.
struct NearTouch {
  double at, size, motion, other, extent;
  explicit NearTouch(Random& random)
      : at(random.in(-100, 100)), size(random.in(0.1, 20)), extent(random.in(0.1, 20)) {
    const double motions[] = {0, -0.0, random.in(-50, 50), random.in(-1e-9, 1e-9), random.in(-1e9, 1e9)};
    motion = motions[random.up_to(4)];
    const double others[] = {at + size, at - extent, at + size + motion, at - extent + motion,
                             random.in(-150, 150)};
    other = near(random, others[random.up_to(4)]);
  }
};

RC_GTEST_PROP(WorldProperty, EarlyRejectNeverHidesAContact, (std::uint64_t seed)) {
  Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    const NearTouch x(random);
    const NearTouch y(random);
    const Sweep sweep({x.at, y.at, x.size, y.size}, {x.at + x.motion, y.at + y.motion});
    const Sides difference = minkowski_difference(sweep.box, {x.other, y.other, x.extent, y.extent});
    SweepContact contact;
    RC_ASSERT(!(misses(difference, sweep.d) && detect_faithful(sweep, difference, contact)));
  }
}

// Differences are given directly, down to subnormal motions, where the product of the reject rounds coarsely.
RC_GTEST_PROP(WorldProperty, EarlyRejectHoldsForEveryScale, (std::uint64_t seed)) {
  Random random(seed);
  for (int i = 0; i < 2000; ++i) {
    const auto axis = [&](double& lo, double& hi, double& d) {
      d = std::ldexp(random.in(-1, 1), -random.up_to(1074));
      const double ends[] = {d, 0, -1e-10 * d, -2e-10 * d, random.in(-1, 1)};
      const double end = near(random, ends[random.up_to(4)]);
      const double size = random.up_to(1) ? random.in(0, 2) : std::abs(d) * random.in(0, 2);
      lo = random.up_to(1) ? end : end - size;
      hi = lo + size;
    };
    Sides sides;
    Vec2 d;
    axis(sides.left, sides.right, d.x);
    axis(sides.top, sides.bottom, d.y);
    SweepContact contact;
    RC_ASSERT(!(misses(sides, d) && detect_faithful(Sweep({0, 0, 1, 1}, d), sides, contact)));
  }
}

bool same(const Collision& a, const Collision& b) {
  return a.overlaps == b.overlaps && a.ti == b.ti && a.move == b.move && a.normal == b.normal &&
         a.touch == b.touch && a.other_rect == b.other_rect && a.aim == b.aim;
}

// The cells of a range along one axis, straight from the definition.
bool cells_meet(double a, double a_size, double b, double b_size, double cell) {
  return std::floor(a / cell) + 1 <= std::ceil((b + b_size) / cell) &&
         std::floor(b / cell) + 1 <= std::ceil((a + a_size) / cell);
}

RC_GTEST_PROP(WorldProperty, TheGridFindsTheSameAsTestingEveryItem, (std::uint64_t seed)) {
  Random random(seed);
  const double cell = random.in(2, 80);
  World world(cell);
  std::vector<Rect> rects;
  for (int i = 0; i < 60; ++i) {
    rects.push_back(random.rect(100));
    world.add(rects.back());
  }
  for (int i = 0; i < 20; ++i) {
    const Rect box = random.rect(100);
    const Vec2 goal{random.in(-150, 150), random.in(-150, 150)};
    const Sweep sweep(box, goal);
    const Vec2 from{std::min(box.x, goal.x), std::min(box.y, goal.y)};
    const Vec2 size{std::max(box.x, goal.x) + box.w - from.x, std::max(box.y, goal.y) + box.h - from.y};
    std::size_t contacts = 0;
    std::size_t candidates = 0;
    for (const Rect& other : rects) {
      if (!cells_meet(from.x, size.x, other.x, other.w, cell)) continue;
      if (!cells_meet(from.y, size.y, other.y, other.h, cell)) continue;
      ++candidates;
      SweepContact contact;
      contacts += detect_faithful(sweep, minkowski_difference(box, other), contact);
    }
    std::size_t asked = 0;
    std::vector<Collision> hits;
    const auto count = [&](ItemId, ItemId) {
      ++asked;
      return Response::slide;
    };
    world.project({}, box, goal, count, hits);
    RC_ASSERT(hits.size() == contacts);
    RC_ASSERT(asked == candidates);
    RC_ASSERT(std::is_sorted(hits.begin(), hits.end(),
                             [](const Collision& a, const Collision& b) { return a.ti < b.ti; }));
    std::vector<ItemId> found;
    world.query_rect(box, found);
    RC_ASSERT(found.size() ==
              static_cast<std::size_t>(std::count_if(rects.begin(), rects.end(),
                                                     [&](const Rect& r) { return intersect(box, r); })));
    world.query_point(goal, found);
    RC_ASSERT(found.size() ==
              static_cast<std::size_t>(std::count_if(
                  rects.begin(), rects.end(), [&](const Rect& r) { return contains(sides_of(r), goal); })));
  }
}

Response mixed(ItemId other) { return static_cast<Response>(other.index % 5); }

Vec2 swapped(Vec2 v) { return {v.y, v.x}; }
Rect swapped(const Rect& r) { return {r.y, r.x, r.h, r.w}; }

// Only corners treat x and y differently, and random boxes never meet corner to corner.
template <World::Mode mode>
void check_transposition(std::uint64_t seed) {
  Random random(seed);
  World world(32, mode);
  World transposed(32, mode);
  for (int i = 0; i < 40; ++i) {
    const Rect rect = random.rect(80);
    world.add(rect);
    transposed.add(swapped(rect));
  }
  std::vector<Collision> hits;
  std::vector<Collision> transposed_hits;
  const auto filter = [](ItemId, ItemId other) { return mixed(other); };
  std::vector<ItemId> items;
  world.items(items);
  for (const ItemId item : items) {
    const Vec2 goal{random.in(-90, 90), random.in(-90, 90)};
    const Vec2 end = world.move(item, goal, filter, hits);
    RC_ASSERT(swapped(end) == transposed.move(item, swapped(goal), filter, transposed_hits));
    RC_ASSERT(hits.size() == transposed_hits.size());
    for (std::size_t i = 0; i < hits.size(); ++i) {
      RC_ASSERT(hits[i].other == transposed_hits[i].other);
      RC_ASSERT(hits[i].ti == transposed_hits[i].ti);
      RC_ASSERT(swapped(hits[i].normal) == transposed_hits[i].normal);
      RC_ASSERT(swapped(hits[i].touch) == transposed_hits[i].touch);
    }
  }
}

RC_GTEST_PROP(WorldProperty, FaithfulTreatsBothAxesAlike, (std::uint64_t seed)) {
  check_transposition<World::Mode::faithful>(seed);
}
RC_GTEST_PROP(WorldProperty, RobustTreatsBothAxesAlike, (std::uint64_t seed)) {
  check_transposition<World::Mode::robust>(seed);
}

template <World::Mode mode>
void check_permutation(std::uint64_t seed) {
  Random random(seed);
  std::vector<Rect> rects;
  for (int i = 0; i < 40; ++i) rects.push_back(random.rect(80));
  const Rect box = random.rect(80);
  const Vec2 goal{random.in(-90, 90), random.in(-90, 90)};
  const auto run = [&](std::vector<Collision>& hits) {
    World world(32, mode);
    const ItemId mover = world.add(box);
    for (const Rect& rect : rects) world.add(rect);
    return world.move(mover, goal, kSlide, hits);
  };
  std::vector<Collision> hits;
  std::vector<Collision> shuffled_hits;
  const Vec2 end = run(hits);
  random.shuffle(rects);
  RC_ASSERT(run(shuffled_hits) == end);
  RC_ASSERT(std::equal(hits.begin(), hits.end(), shuffled_hits.begin(), shuffled_hits.end(), same));
}

RC_GTEST_PROP(WorldProperty, FaithfulIgnoresTheOrderOfAdding, (std::uint64_t seed)) {
  check_permutation<World::Mode::faithful>(seed);
}
RC_GTEST_PROP(WorldProperty, RobustIgnoresTheOrderOfAdding, (std::uint64_t seed)) {
  check_permutation<World::Mode::robust>(seed);
}

// A table of responses, and a function that looks the table up, give the same ends and the same contacts,
// even if boxes are flush or far from the origin.
template <World::Mode mode>
void check_groups(std::uint64_t seed) {
  Random random(seed);
  const double offset = std::pow(10, random.in(3, 9.5)) * random.in(-1, 1);
  World world(random.in(4, 60), mode);
  std::vector<ItemId> items;
  std::vector<int> groups(1);
  World::GroupResponses table;
  for (Response& response : table) response = static_cast<Response>(random.up_to(4));
  for (int i = 0; i < 50; ++i) {
    Rect rect = random.rect(60);
    if (i % 2 == 0) rect = {8.0 * random.up_to(12), 8.0 * random.up_to(12), 8, 8};
    groups.push_back(random.up_to(World::kGroupCount - 1));
    items.push_back(world.add({offset + rect.x, rect.y - offset, rect.w, rect.h}, groups.back()));
  }
  const auto filter = [&](ItemId, ItemId other) {
    return table[static_cast<std::size_t>(groups[other.index])];
  };
  std::vector<Collision> hits;
  std::vector<Collision> table_hits;
  for (int round = 0; round < 4; ++round) {
    for (const ItemId item : items) {
      const double reach = random.up_to(3) ? 20 : 300;
      const Vec2 goal =
          world.rect(item).position() + Vec2{random.in(-reach, reach), random.in(-reach, reach)};
      const Vec2 end = world.check(item, goal, filter, hits);
      RC_ASSERT(world.move(item, goal, table, table_hits) == end);
      RC_ASSERT(std::equal(hits.begin(), hits.end(), table_hits.begin(), table_hits.end(),
                           [](const Collision& a, const Collision& b) {
                             return same(a, b) && a.item == b.item && a.other == b.other &&
                                    a.response == b.response && a.item_rect == b.item_rect;
                           }));
    }
  }
}

RC_GTEST_PROP(WorldProperty, FaithfulGroupsAnswerLikeAFilterFarOut, (std::uint64_t seed)) {
  check_groups<World::Mode::faithful>(seed);
}
RC_GTEST_PROP(WorldProperty, RobustGroupsAnswerLikeAFilterFarOut, (std::uint64_t seed)) {
  check_groups<World::Mode::robust>(seed);
}

// After a long random history the grid answers as a fresh grid with the same items.
RC_GTEST_PROP(WorldProperty, HistoryLeavesNoTrace, (std::uint64_t seed)) {
  Random random(seed);
  World world(16);
  std::vector<ItemId> items;
  std::vector<Collision> hits;
  for (int i = 0; i < 400; ++i) {
    const int action = random.up_to(3);
    if (action == 0 || items.empty()) {
      items.push_back(world.add(random.rect(100)));
    } else if (action == 1 && items.size() > 10) {
      const auto at = items.begin() + random.up_to(static_cast<int>(items.size()) - 1);
      world.remove(*at);
      items.erase(at);
      if (random.up_to(9) == 0) world.collect_empty_cells();
    } else {
      const ItemId item = items[static_cast<std::size_t>(random.up_to(static_cast<int>(items.size()) - 1))];
      world.move(item, {random.in(-100, 100), random.in(-100, 100)}, hits);
    }
  }
  World fresh(16);
  for (const ItemId item : items) fresh.add(world.rect(item));
  std::vector<Collision> fresh_hits;
  for (int i = 0; i < 30; ++i) {
    const Rect box = random.rect(100);
    const Vec2 goal{random.in(-100, 100), random.in(-100, 100)};
    world.project({}, box, goal, kSlide, hits);
    fresh.project({}, box, goal, kSlide, fresh_hits);
    RC_ASSERT(std::equal(hits.begin(), hits.end(), fresh_hits.begin(), fresh_hits.end(), same));
  }
}

}  // namespace talus::world_property_test
