// The public queries answer for any numbers: NaN, infinities, numbers outside int, and invalid sizes. Under
// the sanitizers this finds undefined behaviour.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include <talus/c/talus.h>
#include <talus/collision/world.h>
#include <talus/level/limits.h>
#include "collision/cast_rounding.h"
#include "collision/cast_trace.h"
#include "collision/ground_queries.h"
#include "test_map.h"

namespace talus::any_number_test {

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::array kNasty = {0.0,    -0.0,    4.0,  -4.0,  1e-308, -1e-320, 2147483648.0,
                               1.7e10, -1.8e10, 1e12, -1e12, 1e15,   -1e19,   1e300,
                               -1e300, 1.7e308, kInf, -kInf, kNan,   4e9};
constexpr std::array kSizes = {4.0, 0.0, -0.0, -1.0, 1e-308, 1e9, 1e11, 1e300, kInf, -kInf, kNan};
constexpr std::array kCells = {
    0, 1, -1, 1 << 24, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()};

Terrain every_kind() {
  TestMap map({"1.2.3", "..4.6", "7.5..", "11111"});
  map.curves = {{.form = Arc{{20, 20}, 8, 14, 26, true}}, {.form = Sine{0, 30, 10, 4, 16, 0}}};
  return map.compile();
}

// Calls use(box, motion) for boxes and motions in which two numbers at a time are nasty.
template <class Use>
void for_nasty(Use use) {
  for (const double a : kNasty) {
    for (const double b : kNasty) {
      use(Rect{a, b, 4, 4}, Vec2{3, 5});
      use(Rect{4, 4, 4, 4}, Vec2{a, b});
      use(Rect{a, 4, 4, 4}, Vec2{b, 3});
      use(Rect{a, 4, 4, 4}, Vec2{-a, b});
      use(Rect{4, a, 4, 4}, Vec2{3, b});
    }
    for (const double size : kSizes) {
      use(Rect{a, 4, size, 4}, Vec2{3, 5});
      use(Rect{4, 4, 4, size}, Vec2{a, 5});
      use(Rect{4, a, size, size}, Vec2{-3, a});
    }
  }
}

TEST(AnyNumber, IsAnsweredByTheTerrainAndItsQueries) {
  const Terrain ground = every_kind();
  for (const Foot foot : {Foot::box, Foot::centre}) {
    for_nasty([&](const Rect& box, Vec2 motion) {
      const Cast<double> cast{box, motion, foot};
      const auto contact = cast_box(ground, cast);
      if (contact) {
        EXPECT_TRUE(is_usable(cast));
        EXPECT_TRUE(std::isfinite(contact.position.x) && std::isfinite(contact.position.y));
      }
      trace_cast(ground, cast);
      floor_below(ground, box, motion.y, foot);
      ceiling_above(ground, box, motion.y);
      cast_segment(ground, box.position(), motion);
      if (overlaps_ground(ground, box, foot)) way_out(ground, box, foot);
    });
  }
  for (const int x : kCells) {
    for (const int y : kCells) {
      const bool inside = ground.contains({x, y});
      if (!inside) {
        EXPECT_FALSE(ground.is_solid({x, y}) || ground.is_detailed({x, y}));
        EXPECT_EQ(ground.tile_at({x, y}), 0);
        EXPECT_TRUE(ground.pieces_in({x, y}).empty());
      }
    }
  }
}

TEST(AnyNumber, IsAnsweredInSinglePrecision) {
  const TestMap map({"1.2.3", "..4.6", "11111"});
  const BasicTerrain<float> ground(map.source());
  for_nasty([&](const Rect& box, Vec2 motion) {
    const auto narrow = [](double v) {
      return std::abs(v) > 1e38 ? std::copysign(1e38f, float(v > 0 ? 1 : -1)) : float(v);
    };
    const BasicRect<float> b{narrow(box.x), narrow(box.y), narrow(box.w), narrow(box.h)};
    cast_box<float>(ground, {b, {narrow(motion.x), narrow(motion.y)}, Foot::box});
    if (overlaps_ground(ground, b)) way_out(ground, b);
  });
}

TEST(AnyNumber, AFarFloorIsFoundWithinTheAskedDistance) {
  const Terrain ground = TestMap({"...", "...", "111"}).compile();
  const auto far = floor_below(ground, {8, -1e11, 4, 4}, kInf);
  ASSERT_TRUE(far);
  EXPECT_EQ(far->y, 16);
  EXPECT_FALSE(floor_below(ground, {8, 0, 4, 4}, kNan));
  EXPECT_FALSE(floor_below(ground, {8, 0, 4, 4}, -1));
  EXPECT_FALSE(floor_below(ground, {8, 1e12, 4, 4}, 1e12));
  EXPECT_TRUE(ceiling_above(ground, {8, 1e11, 4, 4}, 2e11));
}

// The world answers, or throws its own error and stays as it was.
template <class Ask>
void ask(Ask question) {
  try {
    question();
  } catch (const WorldError&) {
  }
}

TEST(AnyNumber, IsAnsweredByTheWorld) {
  for (const World::Mode mode : {World::Mode::faithful, World::Mode::robust}) {
    for (const double cell_size : {64.0, 1e-300, 1e99}) {
      World world(cell_size, mode);
      std::vector<ItemId> found;
      std::vector<Collision> hits;
      std::vector<SegmentHit> cuts;
      ask([&] { world.add({0, 20, 30, 8}); });
      for_nasty([&](const Rect& box, Vec2 motion) {
        ItemId item;
        ask([&] { item = world.add(box); });
        if (item) {
          ask([&] { world.check(item, motion, World::GroupResponses{Response::slide}, hits); });
          ask([&] { world.move(item, motion, hits); });
          ask([&] { world.update(item, motion); });
          ask([&] {
            world.project(
                item, box, motion, [](ItemId, ItemId) { return Response::cross; }, hits);
          });
          world.remove(item);
        }
        ask([&] { world.check(box, motion, World::GroupResponses{Response::bounce}, hits); });
        ask([&] { world.query_rect(box, found); });
        ask([&] { world.query_point(motion, found); });
        ask([&] { world.to_cell(motion); });
      });
      for (const double a : kNasty) {
        ask([&] { world.query_segment({a, 4}, {4, a}, cuts); });
        ask([&] { world.query_segment({3, a}, {-a, a}, cuts); });
      }
      EXPECT_LE(world.item_count(), 1u);
    }
  }
  for (const double size : {0.0, -1.0, kNan, kInf, 1e200}) EXPECT_THROW(World{size}, WorldError) << size;
}

TEST(AnyNumber, IsAnsweredByTheInterfaceForC) {
  const std::string level =
      R"({"talus": 1, "spawns": [{"name": "", "x": 4, "y": 4}], "tiles": {"1": {"flags": [0]}},
    "roles": {"solid": 0}, "map": {"width": 3, "height": 3, "rows": ["", "", "010101"]}})";
  char error[200];
  talus_game* game = talus_read(level.data(), level.size(), "a.talus.json", error, sizeof error);
  ASSERT_NE(game, nullptr) << error;
  double y = -1;
  for (const double a : kNasty) {
    for (const double b : kNasty) {
      EXPECT_EQ(talus_step(game, ~0u, a, b, 1), 1);
      talus_floor(game, a, b, 4, 4, 100, &y);
      talus_floor(game, 4, a, 4, 4, b, &y);
      for (const double size : kSizes) talus_floor(game, a, 4, size, size, b, &y);
    }
  }
  EXPECT_EQ(talus_floor(game, 4, 0, 4, 4, 2e10, &y), 1);  // as in cast.cpp: far below all ints of cells
  EXPECT_EQ(y, 16);
  EXPECT_EQ(talus_floor(game, 4, 0, 4, 4, 1e12, &y), 1);
  for (const double far : {1.1e12, -1.1e12}) {
    EXPECT_EQ(talus_floor(game, 4, 0, 4, 4, far, &y), 0) << "as talus.h promises";
    EXPECT_EQ(talus_floor(game, 4, far, 4, 4, 1e12, &y), 0);
  }
  talus_body body;
  ASSERT_EQ(talus_body_at(game, 0, &body), 1);
  EXPECT_TRUE(std::isfinite(body.x) && std::isfinite(body.y) && std::isfinite(body.vx) &&
              std::isfinite(body.vy));
  talus_close(game);
}

TEST(AnyNumber, TheInterfaceForCRefusesEmptyInput) {
  char error[200] = "as it was";
  EXPECT_EQ(talus_read(nullptr, 5, "a.talus.json", error, sizeof error), nullptr);
  EXPECT_STREQ(error, "error: the bytes are null");
  EXPECT_EQ(talus_read(nullptr, 0, "a.talus.json", error, sizeof error), nullptr);
  EXPECT_TRUE(std::string_view(error).starts_with("a.talus.json:")) << error;
  const std::string large = R"({"talus": 1})" + std::string(kMaxFileBytes, ' ');
  EXPECT_EQ(talus_read(large.data(), large.size(), "a.talus.json", error, sizeof error), nullptr);
  EXPECT_STREQ(error, "a.talus.json: error: is larger than 96 MiB") << "as a file is";
  EXPECT_EQ(talus_open(nullptr, error, sizeof error), nullptr);
  EXPECT_STREQ(error, "error: the path is null");
}

}  // namespace talus::any_number_test
