// The outline of the ground and the curves, as lines.
#include "overlay/outline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include <talus/level/ground.h>
#include "overlay/removed_edges.h"

namespace talus::outline_test {

using ::testing::UnorderedElementsAre;

constexpr Rect kEverything{-1000, -1000, 4000, 4000};

using Ends = std::pair<std::pair<double, double>, std::pair<double, double>>;
Ends ends(double x0, double y0, double x1, double y1) { return {{x0, y0}, {x1, y1}}; }

// 8x4 cells; tile 1 is solid, tile 2 a slope from 0 to 8 px, tile 3 a one-way solid tile.
Level empty_level() {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(8, 4);
  level.tile_shapes[1].kind = TileShape::Kind::solid;
  level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.tile_shapes[3] = {.kind = TileShape::Kind::solid, .one_way = true};
  return level;
}

// The ends of all lines, each of which must belong to the overlay.
std::vector<Ends> ends_of_lines(const OverlayDrawing& drawing, const Overlay* overlay) {
  std::vector<Ends> lines;
  for (const OverlayLine& l : drawing.lines) {
    EXPECT_EQ(l.overlay, overlay);
    lines.push_back(ends(l.from.x, l.from.y, l.to.x, l.to.y));
  }
  return lines;
}

std::vector<Ends> outline(const Level& level, Rect visible = kEverything) {
  OverlayDrawing drawing;
  add_outline(Terrain(ground_of(level)), visible, drawing);
  return ends_of_lines(drawing, &overlay::outline);
}

TEST(Outline, NormalsAreDetails) {
  Level level = empty_level();
  level.map.set({2, 1}, 1);
  OverlayDrawing drawing;
  add_outline(Terrain(ground_of(level)), kEverything, drawing);
  ASSERT_EQ(drawing.lines.size(), 8u);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(drawing.lines[i].detail, i % 2 == 1) << i;
}

TEST(Outline, FullTilesHaveOnlyTheirOpenSides) {
  Level level = empty_level();
  level.map.set({2, 1}, 1);
  level.map.set({3, 1}, 1);
  EXPECT_THAT(outline(level),
              UnorderedElementsAre(ends(16, 8, 24, 8), ends(20, 8, 20, 5),      // the top, then its normal
                                   ends(24, 8, 32, 8), ends(28, 8, 28, 5),      //
                                   ends(16, 16, 24, 16), ends(20, 16, 20, 19),  // the bottom
                                   ends(24, 16, 32, 16), ends(28, 16, 28, 19),  //
                                   ends(16, 8, 16, 16), ends(16, 12, 13, 12),   // the sides
                                   ends(32, 8, 32, 16), ends(32, 12, 35, 12)));
}

TEST(Outline, OneWayTileHasOnlyItsTop) {
  Level level = empty_level();
  level.map.set({2, 1}, 3);
  EXPECT_THAT(outline(level), UnorderedElementsAre(ends(16, 8, 24, 8), ends(20, 8, 20, 5)));
}

TEST(Outline, SlopesHaveTheirTrueNormal) {
  Level level = empty_level();
  level.map.set({2, 1}, 2);
  const auto lines = outline(level);
  EXPECT_THAT(lines, ::testing::Contains(ends(16, 16, 24, 8)));
  const double n = 3 / std::sqrt(2.0);
  bool found = false;
  for (const auto& [from, to] : lines) {
    found |= from == std::pair(20.0, 12.0) && std::abs(to.first - (20 - n)) < 1e-12 &&
             std::abs(to.second - (12 - n)) < 1e-12;
  }
  EXPECT_TRUE(found);
}

TEST(Outline, LongSegmentIsOneLine) {
  Level level = empty_level();
  level.curves.push_back({"", {Segment{{4, 20}, {60, 20}}, Curve::Faces::up}, ""});
  std::vector<Ends> lines = outline(level);
  ASSERT_EQ(lines.size(), 1u + 4u);  // a normal for each 16 px or less
  EXPECT_EQ(lines[0], ends(4, 20, 60, 20));
  EXPECT_EQ(lines[1], ends(11, 20, 11, 17));
}

TEST(Outline, LinesOutOfSightAreLeftOut) {
  Level level = empty_level();
  for (int x = 0; x < 8; ++x) level.map.set({x, 3}, 1);
  level.curves.push_back({"", {Segment{{4, 4}, {60, 4}}, Curve::Faces::up}, ""});
  for (const auto& [from, to] : outline(level, {17, 0, 6, 30})) {
    EXPECT_GE(to.first, 16);
    EXPECT_LE(from.first, 24);
  }
  EXPECT_TRUE(outline(level, {17, 10, 6, 6}).empty());
}

TEST(Outline, OneWaySidesHaveArrowsInThePassableDirection) {
  Level level = empty_level();
  level.map.set({2, 1}, 3);
  level.map.set({4, 1}, 1);
  OverlayDrawing drawing;
  add_one_way_arrows(Terrain(ground_of(level)), kEverything, drawing);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].overlay, &overlay::one_way);
  EXPECT_TRUE(drawing.lines[0].arrow);
  EXPECT_EQ(drawing.lines[0].from, (Vec2{20, 13}));
  EXPECT_EQ(drawing.lines[0].to, (Vec2{20, 3}));
}

OverlayDrawing drawn_conveyors(const Level& level) {
  const Scene scene = compile_scene(level);
  const Terrain ground(ground_of(level));
  const State state;
  const StepRecord record;
  OverlaySet overlays;
  overlays.set(overlay::conveyors, true);
  return make_overlays({.scene = scene, .state = state, .record = record, .ground = &ground}, overlays,
                       kEverything);
}

TEST(Conveyors, OfATwoSidedLineHaveArrowsOnBothSides) {
  Level level = empty_level();
  level.curves.push_back({"", {Segment{{8, 16}, {56, 16}}, Curve::Faces::both, 1}, ""});
  int above = 0, below = 0;
  for (const OverlayLine& arrow : drawn_conveyors(level).lines) {
    const Vec2 way = arrow.to - arrow.from;
    if (way.x == 0) continue;  // at an end
    const bool is_above = arrow.from.y < 16;
    EXPECT_GT(way.x * (is_above ? 1 : -1), 0);
    ++(is_above ? above : below);
  }
  EXPECT_GT(above, 0);
  EXPECT_EQ(above, below);
}

TEST(Conveyors, AreDrawnOnlyWithTheirSolver) {
  Level level = empty_level();
  level.map.set({2, 1}, 1);
  level.tile_shapes[1].conveyor = 1;
  EXPECT_FALSE(drawn_conveyors(level).lines.empty());
  EXPECT_EQ(why_nothing(overlay::conveyors, level), "");
  level.tuning.solver = SolverKind::bump;
  EXPECT_TRUE(drawn_conveyors(level).lines.empty());
  EXPECT_EQ(why_nothing(overlay::conveyors, level), "Conveyors move only with the solver exact.");
}

std::vector<Ends> removed(const Level& level) {
  OverlayDrawing drawing;
  add_removed_edges(Terrain(ground_of(level)), kEverything, drawing);
  return ends_of_lines(drawing, &overlay::removed_edges);
}

TEST(RemovedEdges, AreTheSharedSidesOfTiles) {
  Level level = empty_level();
  for (const Cell c : {Cell{2, 1}, {3, 1}, {4, 1}, {3, 2}}) level.map.set(c, 1);
  EXPECT_THAT(removed(level), UnorderedElementsAre(ends(24, 8, 24, 16), ends(32, 8, 32, 16),  //
                                                   ends(24, 16, 32, 16)));
}

//       /|  a slope from 0 to 8 px against a tile, on another tile
//      / |##
//     ######
TEST(RemovedEdges, OfASlopeAreItsBottomAndItsBack) {
  Level level = empty_level();
  level.map.set({2, 1}, 2);
  level.map.set({3, 1}, 1);
  level.map.set({2, 2}, 1);
  level.map.set({3, 2}, 1);
  EXPECT_THAT(removed(level), UnorderedElementsAre(ends(24, 8, 24, 16), ends(16, 16, 24, 16),  //
                                                   ends(24, 16, 32, 16), ends(24, 16, 24, 24)));
}

TEST(RemovedEdges, ASlopeAloneHasAllItsSides) {
  Level level = empty_level();
  level.map.set({2, 1}, 2);
  EXPECT_TRUE(removed(level).empty());
}

TEST(CurveLines, FollowAnArcAndShowATwoSidedOneOnce) {
  Level level = empty_level();
  level.curves.push_back({"", {Arc{{32, 28}, 20, 12, 52, true}, Curve::Faces::both}, ""});
  const auto lines = curve_lines(level, kEverything);
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front().from, (Vec2{12, 28}));
  EXPECT_EQ(lines.back().to, (Vec2{52, 28}));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_NEAR(std::hypot(lines[i].from.x - 32, lines[i].from.y - 28), 20, 1e-9);
    if (i > 0) {
      EXPECT_EQ(lines[i].from, lines[i - 1].to);
    }
  }
}

TEST(CurveLines, HaveVerticalSegmentsAndLeaveOutInvalidCurves) {
  Level level = empty_level();
  level.curves.push_back({"", {Segment{{30, 2}, {30, 22}}, Curve::Faces::down}, ""});
  level.curves.push_back({"", {Arc{{32, 28}, -1, 12, 52, true}, Curve::Faces::up}, ""});
  const auto lines = curve_lines(level, kEverything);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_EQ(lines[0].from, (Vec2{30, 2}));
  EXPECT_EQ(lines[0].to, (Vec2{30, 22}));
  EXPECT_TRUE(curve_lines(level, {40, 0, 8, 8}).empty());
}

}  // namespace talus::outline_test
