// The shape of each tile, and the curves that a level may have.
#include <gtest/gtest.h>

#include <talus/level/ground.h>
#include <talus/level/level.h>

namespace talus::level_shape_test {

using Kind = TileShape::Kind;
using Side = TileShape::Side;

TileShape slope(std::vector<double> heights, int tiles = 1) {
  return {.kind = Kind::slope, .tiles = tiles, .heights = std::move(heights)};
}

TEST(ShapeOfTile, RolesGiveTheArticlesShapes) {
  Level level;
  EXPECT_EQ(shape_of_flags(level, 0), TileShape());
  EXPECT_EQ(shape_of_flags(level, 1), TileShape{.kind = Kind::solid});
  EXPECT_EQ(shape_of_flags(level, 2), TileShape()) << "a ball";
  EXPECT_EQ(shape_of_flags(level, 4), slope({0, 8}, 2));
  EXPECT_EQ(shape_of_flags(level, 8), slope({8, 0}, 2));
  EXPECT_EQ(shape_of_flags(level, 15), TileShape{.kind = Kind::solid});
}

TEST(ShapeOfTile, SlopesHaveTheTunedBox) {
  Level level;
  level.tuning.shared.slope_width = 24;
  level.tuning.shared.slope_height = 6;
  EXPECT_EQ(shape_of_flags(level, 4), slope({2, 8}, 3));
  level.tuning.shared.slope_width = 1;
  level.tuning.shared.slope_height = 64;
  EXPECT_EQ(shape_of_flags(level, 8), slope({8, 0}, 1));
  level.tuning.shared.slope_width = 64;
  EXPECT_EQ(shape_of_flags(level, 8), slope({8, 0}, 8));
}

TEST(ShapeOfTile, AFlagStandsForAShapeUnlessARoleWins) {
  Level level;
  level.flag_shapes[5] = slope({0, 4});
  level.flag_shapes[6] = slope({4, 8});
  level.flag_shapes[1] = slope({1, 2});
  EXPECT_EQ(shape_of_flags(level, 1 << 6), slope({4, 8}));
  EXPECT_EQ(shape_of_flags(level, 1 << 6 | 1 << 5), slope({0, 4})) << "the lowest flag wins";
  EXPECT_EQ(shape_of_flags(level, 1 << 6 | 1), TileShape{.kind = Kind::solid});
  EXPECT_EQ(shape_of_flags(level, 1 << 6 | 1 << 1), TileShape()) << "a ball";
}

TEST(ShapeOfTile, ModifiersChangeWhatTheFlagsGive) {
  Level level;
  level.roles.one_way = 6;
  level.roles.ceiling = 7;
  TileShape expected = slope({0, 8}, 2);
  expected.one_way = true;
  EXPECT_EQ(shape_of_flags(level, 1 << 6 | 4), expected);
  expected.side = Side::ceiling;
  EXPECT_EQ(shape_of_flags(level, 1 << 7 | 1 << 6 | 4), expected);
  EXPECT_EQ(shape_of_flags(level, 1 << 6 | 1 << 7), TileShape());
  level.flag_shapes[5] = {.kind = Kind::slope, .side = Side::ceiling, .heights = {1, 2}};
  EXPECT_EQ(shape_of_flags(level, 1 << 7 | 1 << 5), slope({1, 2}))
      << "a ceiling turned upside down is a floor";
}

TEST(ShapeOfTile, TheTilesOwnShapeComesFirst) {
  Level level;
  level.roles.one_way = 6;
  level.sheet(SheetId::tiles).flags[9] = 1 | 1 << 6;
  level.tile_shapes[9] = slope({3, 5});
  EXPECT_EQ(shape_of_tile(level, 9), slope({3, 5}));
  level.tile_shapes[9] = {};
  EXPECT_EQ(shape_of_tile(level, 9), (TileShape{.kind = Kind::solid, .one_way = true}));
}

TEST(FlagRoles, ModifiersAreNoRoles) {
  FlagRoles roles;
  roles.one_way = 6;
  EXPECT_EQ(role_of(1 << 6, roles), TileRole::none);
  EXPECT_EQ(role_of(1 << 6 | 4, roles), TileRole::up_slope);
}

TEST(Spawn, TheKindGivesTheFootUnlessItIsChosen) {
  Spawn spawn;
  EXPECT_EQ(spawn.used_foot(), Foot::box);
  spawn.kind = BodyKind::player;
  EXPECT_EQ(spawn.used_foot(), Foot::centre);
  spawn.foot = Foot::box;
  EXPECT_EQ(spawn.used_foot(), Foot::box);
}

TEST(LevelCurve, EndsMustBeOnTheMap) {
  const TileMap map(4, 2);  // 32 x 16 px
  const auto problem = [&](auto form) {
    return problem_of(Curve{std::move(form), Curve::Faces::up}, map).value_or("");
  };
  const std::string first = "has its first end off the map", last = "has its last end off the map";
  EXPECT_EQ(problem(Segment{{0, 0}, {32, 16}}), "");
  EXPECT_EQ(problem(Segment{{0, 0}, {32.5, 16}}), last);
  EXPECT_EQ(problem(Segment{{0, -1}, {32, 16}}), first);
  EXPECT_EQ(problem(Parabola{{0, 8}, {8, 17}, 0}), last);
  EXPECT_EQ(problem(Cubic{{-1, 8}, {8, 8}, 0, 0}), first);
  EXPECT_EQ(problem(Polyline{0, 8, {-3, 0, 4}}), first);
  EXPECT_EQ(problem(Arc{{8, 8}, 8, 8, 16, true}), "");
  EXPECT_EQ(problem(Arc{{8, 8}, 12, 8, 16, true}), first);
  EXPECT_EQ(problem(Arc{{8, 8}, 12, 8, 16, false}), first);
  EXPECT_EQ(problem(Sine{0, 32, 0, 8, 32, 0}), "") << "its ends are on the map's upper side";
  EXPECT_EQ(problem(Sine{0, 24, 4, 8, 32, 0}), last);
  EXPECT_EQ(problem(Segment{{3, 3}, {3, 3}}), "has a length of zero");
}

// A curve may be valid when it is drawn, and off the map after the map was made smaller.
TEST(LevelCurve, ACurveOffTheMapIsNoGround) {
  Level level;
  level.map = TileMap(4, 2);
  const Curve kept{Segment{{0, 0}, {32, 16}}, Curve::Faces::up};
  level.curves = {{"", {Segment{{0, 0}, {40, 16}}, Curve::Faces::up}, ""}, {"", kept, ""}};
  EXPECT_EQ(ground_of(level).curves, std::vector<Curve>{kept});
  level.map = TileMap(5, 2);
  EXPECT_EQ(ground_of(level).curves.size(), 2);
}

}  // namespace talus::level_shape_test
