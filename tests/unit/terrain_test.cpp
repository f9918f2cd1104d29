// The compiled ground: what is on its outline, and that editing gives the same ground as compiling.
#include <talus/collision/terrain.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <tuple>

#include "collision/outline_compiler.h"
#include "test_map.h"

namespace talus::terrain_test {

// A piece as text: its facing and its ends; "(" or ")" where an end is convex, "|" where no piece continues.
std::string text_of(const Piece<double>& p) {
  const auto number = [](double v) {
    std::string text = std::to_string(v);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
  };
  static constexpr const char* kFacings[] = {"up", "down", "left", "right"};
  std::string text = kFacings[static_cast<int>(p.facing)];
  text += p.one_way ? " thin " : " ";
  text += (p.last0 ? "|" : "") + std::string(p.convex0 ? "(" : "");
  text += number(p.x0) + "," + number(p.y0) + " " + number(p.x1) + "," + number(p.y1);
  return text + (p.convex1 ? ")" : "") + (p.last1 ? "|" : "");
}

std::vector<std::string> outline_of(const Terrain& terrain) {
  std::vector<std::string> outline;
  for (Cell c{0, 0}; c.y < terrain.height(); ++c.y) {
    for (c.x = 0; c.x < terrain.width(); ++c.x) {
      for (const Piece<double>& p : terrain.pieces_in(c)) outline.push_back(text_of(p));
    }
  }
  std::sort(outline.begin(), outline.end());
  outline.erase(std::unique(outline.begin(), outline.end()), outline.end());
  return outline;
}

using testing::ElementsAre;
using testing::UnorderedElementsAre;

// ---- The outline ----

TEST(Terrain, FullTilesAreStoredAsBitsOnly) {
  const Terrain terrain = TestMap({"....", ".11.", "...."}).compile();
  for (Cell c{-1, -1}; c.y <= 3; ++c.y) {
    for (c.x = -1; c.x <= 4; ++c.x) EXPECT_EQ(terrain.is_solid(c), c.y == 1 && (c.x == 1 || c.x == 2));
  }
  EXPECT_FALSE(terrain.has_pieces());
  EXPECT_THAT(outline_of(terrain), ElementsAre());
}

TEST(Terrain, TheFirstTileMayBeASlopeInAllCells) {
  const std::vector<TileNumber> cells(2);
  TerrainSource source;
  source.width = 2;
  source.height = 1;
  source.cells = cells;
  source.shapes[0] = {.kind = TileShape::Kind::slope, .heights = {2, 4}};
  const Terrain terrain(source);
  EXPECT_TRUE(terrain.is_detailed({0, 0}));
  EXPECT_TRUE(terrain.is_detailed({1, 0}));
}

TEST(Terrain, ALoneSlopeIsALineAWallABaseAndATip) {
  const Terrain terrain = TestMap({"...", ".2.", "..."}).compile();
  EXPECT_TRUE(terrain.has_pieces());
  EXPECT_THAT(outline_of(terrain), UnorderedElementsAre("up |(8,16 16,8)|", "right (16,8 16,16)",
                                                        "down |(8,16 16,16)|", "left (8,16 8,16)"));
}

TEST(Terrain, SlopesJoinTheFloorsBesideThem) {
  // A floor, and a slope up to the next floor: there is no wall between them, and only real corners are
  // convex.
  const Terrain terrain = TestMap({"....", "..21", "1111"}).compile();
  EXPECT_THAT(
      outline_of(terrain),
      UnorderedElementsAre("down 16,24 24,24", "down 24,24 32,24)|", "down 8,24 16,24", "right (32,8 32,16",
                           "right 32,16 32,24)", "up (24,8 32,8)|", "up 16,16 24,8", "up 8,16 16,16"));
}

TEST(Terrain, AHillHasNoEdgesInside) {
  const Terrain terrain = TestMap({"....", ".23.", "1111"}).compile();
  EXPECT_THAT(outline_of(terrain),
              UnorderedElementsAre("down 16,24 24,24", "down 24,24 32,24)|", "down 8,24 16,24",
                                   "down |(0,24 8,24", "left (0,16 0,24)", "right (32,16 32,24)",
                                   "up (16,8 24,16", "up 24,16 32,16)|", "up 8,16 16,8)", "up |(0,16 8,16"));
}

TEST(Terrain, SlopesAboveOneAnotherHideWhatTheyCover) {
  const Terrain terrain = TestMap({"....", "..2.", ".21.", "...."}).compile();
  EXPECT_THAT(
      outline_of(terrain),
      UnorderedElementsAre("down 16,24 24,24)|", "down |(8,24 16,24", "left (8,24 8,24)", "right (24,8 24,16",
                           "right 24,16 24,24)", "up (16,16 24,8)|", "up |(8,24 16,16"));
}

TEST(Terrain, AProfileIsALineThroughItsHeights) {
  const Terrain terrain = TestMap({"...", ".4.", "111"}).compile();
  EXPECT_THAT(
      outline_of(terrain),
      UnorderedElementsAre("down 16,24 24,24)|", "down 8,24 16,24", "down |(0,24 8,24", "left (0,16 0,24)",
                           "right (24,16 24,24)", "up (10,12 12,10)", "up (12,10 14,12)", "up 14,12 16,16",
                           "up 16,16 24,16)|", "up 8,16 10,12", "up |(0,16 8,16"));
}

TEST(Terrain, ASlopeOfManyTilesHasOnePieceForEachCell) {
  const Terrain terrain = TestMap({".....", ".5...", "11111"}).compile();
  EXPECT_THAT(
      outline_of(terrain),
      UnorderedElementsAre("down 16,24 24,24", "down 24,24 32,24", "down 32,24 40,24)|", "down 8,24 16,24",
                           "down |(0,24 8,24", "left (0,16 0,24)", "right (32,8 32,16", "right (40,16 40,24)",
                           "up (16,13.333333 24,10.666667", "up (24,10.666667 32,8)|", "up 32,16 40,16)|",
                           "up 8,16 16,13.333333", "up |(0,16 8,16"));
}

TEST(Terrain, ACeilingIsAFloorUpsideDown) {
  const Terrain terrain = TestMap({"111", ".6.", "..."}).compile();
  EXPECT_THAT(outline_of(terrain),
              UnorderedElementsAre("down 16,8 24,8)|", "down 8,8 16,16)|", "down |(0,8 8,8", "left (0,0 0,8)",
                                   "right (24,0 24,8)", "right 16,8 16,16)", "up 16,0 24,0)|", "up 8,0 16,0",
                                   "up |(0,0 8,0"));
}

TEST(Terrain, FloorAndCeilingThatTouchLeaveNothingBetween) {
  const Terrain terrain = TestMap({"...", ".8.", "..."}).compile();
  EXPECT_THAT(outline_of(terrain), UnorderedElementsAre("down |(8,16 16,16)|", "left (8,12 8,16)",
                                                        "right (16,12 16,16)", "up |(8,12 16,12)|"));
}

TEST(Terrain, ASlopeMayEndInsideACell) {
  Terrain terrain = TestMap({"...", "...", "..."}).compile();
  terrain.set_cell({1, 1}, kTail);
  EXPECT_THAT(outline_of(terrain), UnorderedElementsAre("down |(8,16 12,16)|", "left (8,8 8,16)",
                                                        "right (12,16 12,16)", "up |(8,8 12,16)|"));
}

TEST(Terrain, AShapeWithoutHeightAddsNoOutline) {
  Terrain terrain = TestMap({"...", "...", ".4."}).compile();
  const std::vector<std::string> alone = outline_of(terrain);
  terrain.set_cell({0, 2}, kFlat);
  EXPECT_EQ(outline_of(terrain), alone);
}

TEST(Terrain, OneWayShapesAreThinLines) {
  const Terrain terrain = TestMap({"....", ".77.", "...."}).compile();
  EXPECT_THAT(outline_of(terrain), UnorderedElementsAre("up thin 16,8 24,8)|", "up thin |(8,8 16,8"));
}

TEST(Terrain, GroundHidesOneWayShapesInsideIt) {
  const Terrain terrain = TestMap({"1..", "71.", "..."}).compile();
  EXPECT_THAT(
      outline_of(terrain),
      UnorderedElementsAre("down |(0,8 8,8)|", "down |(8,16 16,16)|", "left (0,0 0,8)", "left (8,8 8,16)",
                           "right (16,8 16,16)", "right (8,0 8,8)", "up 8,8 16,8)|", "up |(0,0 8,0)|"));
}

TEST(Terrain, ASlopeMayReachOverOtherTiles) {
  const Terrain terrain = TestMap({"....", "1...", "2...", "...."}).compile();
  EXPECT_THAT(
      outline_of(terrain),
      UnorderedElementsAre("down |(0,16 8,16)|", "down |(0,24 8,24)|", "left (0,24 0,24)", "left (0,8 0,16)",
                           "right (8,8 8,16", "right 8,16 8,24)", "up |(0,24 8,16)|", "up |(0,8 8,8)|"));
}

TEST(Terrain, SlopesAtTheBordersOfTheMap) {
  const Terrain terrain = TestMap({"3.2"}).compile();
  EXPECT_THAT(
      outline_of(terrain),
      UnorderedElementsAre("down |(0,8 8,8)|", "down |(16,8 24,8)|", "left (0,0 0,8)", "left (16,8 16,8)",
                           "right (24,0 24,8)", "right (8,8 8,8)", "up |(0,0 8,8)|", "up |(16,8 24,0)|"));
}

TEST(Terrain, ACurveJoinsTheFloor) {
  TestMap map({"....", "....", "1..1"});
  map.curves = {{Segment{{8, 16}, {16, 12}}, Curve::Faces::up},
                {Segment{{16, 12}, {24, 16}}, Curve::Faces::up}};
  EXPECT_THAT(outline_of(map.compile()),
              UnorderedElementsAre("down |(0,24 8,24)|", "down |(24,24 32,24)|", "left (0,16 0,24)",
                                   "left (24,16 24,24)", "right (32,16 32,24)", "right (8,16 8,24)",
                                   "up |24,16 32,16)|", "up thin (16,12 24,16", "up thin 16,12 24,16",
                                   "up thin 8,16 16,12", "up thin 8,16 16,12)", "up |(0,16 8,16|"));
}

TEST(Terrain, ALineThatFacesBothSidesHasTips) {
  TestMap map({"....", "....", "...."});
  map.curves = {{Segment{{8, 16}, {16, 12}}, Curve::Faces::both},
                {Segment{{20, 4}, {20, 12}}, Curve::Faces::both}};
  EXPECT_THAT(outline_of(map.compile()),
              UnorderedElementsAre("down 8,16 16,12)|", "down |(20,12 20,12)|", "down |(8,16 16,12",
                                   "down |(8,16 16,12)|", "left (20,4 20,12)", "left (8,16 8,16)",
                                   "right (16,12 16,12)", "right (20,4 20,12)", "up 8,16 16,12)|",
                                   "up |(20,4 20,4)|", "up |(8,16 16,12", "up |(8,16 16,12)|"));
}

// Comparing each end with all other pieces would take seconds here.
TEST(Terrain, ALongPolylineHasTipsOnlyAtItsEnds) {
  Polyline line{0, 16384, {}};
  for (int i = 0; i <= 16384; ++i) line.ys.push_back(i % 2);
  const std::vector<Curve> curves = {{line, Curve::Faces::both}};
  const std::vector<Piece<double>> pieces = cut_curves(curves).pieces;
  ASSERT_EQ(pieces.size(), 2 * 16384 + 2);
  for (std::size_t i = 0; i < 2 * 16384; ++i) ASSERT_FALSE(pieces[i].is_wall()) << i;
  const Piece<double>&first = pieces[2 * 16384], &last = pieces[2 * 16384 + 1];
  EXPECT_EQ(first.facing, Facing::left);
  EXPECT_EQ((Vec2{first.x0, first.y0}), (Vec2{0, 0}));
  EXPECT_EQ(last.facing, Facing::right);
  EXPECT_EQ((Vec2{last.x0, last.y0}), (Vec2{16384, 0}));
}

TEST(Terrain, EndsOfCurvesMeetThoseOfLines) {
  const Arc arc{{108.003, 120.1}, 50.001, 100.0013, 116.003, true};
  const Sine sine{116.003, 190.002, 71, 3, 41.7, 114};
  const std::vector<Curve> curves = {{arc, Curve::Faces::both}, {sine, Curve::Faces::both}};
  const std::vector<Piece<double>> pieces = cut_curves(curves).pieces;
  const Piece<double>* before = nullptr;
  for (const Piece<double>& piece : pieces) {
    if (piece.facing != Facing::up) continue;
    const bool is_first = before == nullptr, is_next = !is_first && before->origin != piece.origin;
    if (is_first || is_next) {
      EXPECT_EQ((Vec2{piece.x0, piece.y0}), weld({piece.x0, piece.y0}));
    }
    if (is_next) {
      EXPECT_EQ((Vec2{before->x1, before->y1}), weld({before->x1, before->y1}));
    }
    if (!is_first && !is_next) {
      EXPECT_EQ((Vec2{before->x1, before->y1}), (Vec2{piece.x0, piece.y0}));
    }
    if (is_first || is_next) {
      EXPECT_NEAR(piece.x1 - piece.x0, 0.25, 0.02);
    }
    before = &piece;
  }
  const auto height_at = [&](double x) {
    return arc.center.y - std::sqrt(arc.radius * arc.radius - (x - arc.center.x) * (x - arc.center.x));
  };
  EXPECT_EQ(pieces[0].x0, weld(arc.x0));
  EXPECT_EQ(pieces[0].y0, weld(height_at(arc.x0)));
}

TEST(Terrain, CurvesAreCutWhereTheyTurn) {
  TestMap map({"........", "........", "........"});
  map.curves = {{Arc{{32, 20}, 10, 22, 40, true}, Curve::Faces::up}};
  EXPECT_THAT(outline_of(map.compile()),
              UnorderedElementsAre("up thin (32,10 40,14", "up thin (32,10 40,14)|", "up thin 22,20 32,10",
                                   "up thin 22,20 32,10)", "up thin 32,10 40,14)|", "up thin |(22,20 32,10"));
  map.curves = {{Parabola{{8, 16}, {24, 16}, 0}, Curve::Faces::up}};
  EXPECT_THAT(outline_of(map.compile()),
              UnorderedElementsAre("up thin (16,8 24,16", "up thin (16,8 24,16)|", "up thin 16,8 24,16)|",
                                   "up thin 8,16 16,8)", "up thin |(8,16 16,8", "up thin |(8,16 16,8)"));
  map.curves = {{Sine{8, 40, 12, 4, 32, 8}, Curve::Faces::up}};
  EXPECT_THAT(outline_of(map.compile()),
              UnorderedElementsAre("up thin (24,12 32,8", "up thin (24,12 32,8)", "up thin (32,8 40,12",
                                   "up thin (32,8 40,12)|", "up thin 16,16 24,12", "up thin 24,12 32,8)",
                                   "up thin 32,8 40,12)|", "up thin 8,12 16,16", "up thin |(8,12 16,16"));
  map.curves = {{Polyline{8, 24, {16, 12, 16}}, Curve::Faces::down}};
  EXPECT_THAT(outline_of(map.compile()),
              UnorderedElementsAre("down thin 16,12 24,16", "down thin 16,12 24,16)|", "down thin 8,16 16,12",
                                   "down thin |(8,16 16,12"));
}

// ---- Editing ----

bool same(const Piece<double>& a, const Piece<double>& b) {
  const auto marks = [](const Piece<double>& p) {
    return std::tuple(p.convex0, p.convex1, p.last0, p.last1, p.one_way);
  };
  return std::tie(a.x0, a.y0, a.x1, a.y1, a.base_x, a.base_y, a.slope, a.origin, a.stretch, a.facing) ==
             std::tie(b.x0, b.y0, b.x1, b.y1, b.base_x, b.base_y, b.slope, b.origin, b.stretch, b.facing) &&
         marks(a) == marks(b);
}

void expect_same(const Terrain& edited, const Terrain& fresh) {
  ASSERT_EQ(edited.has_pieces(), fresh.has_pieces());
  for (Cell c{0, 0}; c.y < fresh.height(); ++c.y) {
    for (c.x = 0; c.x < fresh.width(); ++c.x) {
      ASSERT_EQ(edited.tile_at(c), fresh.tile_at(c));
      ASSERT_EQ(edited.is_solid(c), fresh.is_solid(c)) << "cell " << c.x << "," << c.y;
      ASSERT_EQ(edited.is_detailed(c), fresh.is_detailed(c)) << "cell " << c.x << "," << c.y;
      const auto a = edited.pieces_in(c), b = fresh.pieces_in(c);
      ASSERT_EQ(a.size(), b.size()) << "cell " << c.x << "," << c.y;
      for (std::size_t i = 0; i < a.size(); ++i)
        ASSERT_TRUE(same(a[i], b[i])) << text_of(a[i]) << text_of(b[i]);
    }
  }
}

// Paints random tiles, most of them where chunks meet and at the borders.
void paint_and_compare(TestMap map, int edits, unsigned seed) {
  std::mt19937 random(seed);
  const auto up_to = [&](int last) { return std::uniform_int_distribution<int>(0, last)(random); };
  for (TileNumber& cell : map.cells) cell = static_cast<TileNumber>(up_to(2) == 0 ? up_to(kFlat) : 0);
  Terrain terrain = map.compile();
  for (int i = 0; i < edits; ++i) {
    Cell cell{up_to(map.width - 1), up_to(map.height - 1)};
    if (up_to(1) == 0 && map.width > 70) cell.x = 60 + up_to(7);
    if (up_to(1) == 0 && map.height > 70) cell.y = 60 + up_to(7);
    const auto tile = static_cast<TileNumber>(up_to(kFlat));
    map.cells[static_cast<std::size_t>(cell.y) * map.width + cell.x] = tile;
    terrain.set_cell(cell, tile);
    if (i % 8 == 7) expect_same(terrain, map.compile());
    if (testing::Test::HasFatalFailure()) FAIL() << "edit " << i << " at " << cell.x << "," << cell.y;
  }
}

TEST(TerrainEdit, EqualsCompilingFromTheStart) {
  paint_and_compare(TestMap(12, 12), 160, 1);
  paint_and_compare(TestMap(1, 1), 20, 2);
  paint_and_compare(TestMap(64, 3), 100, 3);
  paint_and_compare(TestMap(65, 70), 40, 4);
  paint_and_compare(TestMap(130, 72), 32, 5);
}

// A map may be as long or as high as curves may reach. Its far end behaves like any other place.
TEST(TerrainEdit, EqualsCompilingAtTheFarEnds) {
  for (const bool is_long : {true, false}) {
    const int width = is_long ? kMaxTerrainSide : 8, height = kMaxTerrainCells / width;
    TestMap map(width, height);
    const Cell last{width - 1, height - 1};
    const auto tile = [&](Cell back) -> TileNumber& {
      return map.cells[static_cast<std::size_t>(last.y - back.y) * width + last.x - back.x];
    };
    Terrain terrain = map.compile();
    const auto put = [&](Cell back, TileNumber number) {
      tile(back) = number;
      terrain.set_cell({last.x - back.x, last.y - back.y}, number);
    };
    for (int x = 0; x < 6; ++x) put({x, 0}, kSolid);
    put({5, 1}, kWide);
    put({2, 1}, kDown);
    put({0, 2}, kCeiling);
    const Terrain fresh = map.compile();
    EXPECT_TRUE(terrain == fresh);
    for (Cell back{0, 0}; back.y < 6; ++back.y) {
      for (back.x = 0; back.x < 8; ++back.x) {
        const Cell cell{last.x - back.x, last.y - back.y};
        const auto a = terrain.pieces_in(cell), b = fresh.pieces_in(cell);
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same(a[i], b[i])) << text_of(a[i]);
      }
    }
    // The pieces are those of a small map, moved.
    TestMap small(8, 8);
    for (Cell back{0, 0}; back.y < 8; ++back.y) {
      for (back.x = 0; back.x < 8; ++back.x)
        small.cells[static_cast<std::size_t>(7 - back.y) * 8 + 7 - back.x] = tile(back);
    }
    const Terrain near = small.compile();
    const Cell wide{last.x - 5, last.y - 1};
    ASSERT_FALSE(near.pieces_in({2, 6}).empty());
    ASSERT_EQ(terrain.pieces_in(wide).size(), near.pieces_in({2, 6}).size());
    const Piece<double>&far_piece = terrain.pieces_in(wide)[0], &piece = near.pieces_in({2, 6})[0];
    EXPECT_EQ(far_piece.x0 - piece.x0, (wide.x - 2) * 8.0);
    EXPECT_EQ(far_piece.base_y - piece.base_y, (wide.y - 6) * 8.0);
    EXPECT_EQ(far_piece.slope, piece.slope);
    EXPECT_EQ(far_piece.origin, wide.y * width + wide.x);
  }
}

TEST(Terrain, SizesHaveLimits) {
  EXPECT_TRUE(is_terrain_size(1, 1));
  EXPECT_TRUE(is_terrain_size(4096, 4096));
  EXPECT_TRUE(is_terrain_size(2097152, 8));
  EXPECT_TRUE(is_terrain_size(8, 2097152));
  EXPECT_FALSE(is_terrain_size(2097153, 1));
  EXPECT_FALSE(is_terrain_size(1, 2097153));
  EXPECT_FALSE(is_terrain_size(4097, 4096));
  EXPECT_FALSE(is_terrain_size(0, 8));
  EXPECT_FALSE(is_terrain_size(8, 0));
  EXPECT_FALSE(is_terrain_size(2147483647, 2147483647));
}

TEST(TerrainEdit, EqualsCompilingBesideCurves) {
  TestMap map(72, 72);
  map.curves = {{Arc{{500, 520}, 60, 445, 550, true}, Curve::Faces::both},
                {Segment{{0, 0}, {576, 500}}, Curve::Faces::up},
                {Sine{300, 560, 510, 20, 100, 300}, Curve::Faces::down}};
  paint_and_compare(map, 32, 6);
}

TEST(TerrainEdit, RemovingTheLastSlopeRemovesItsPieces) {
  Terrain terrain = TestMap({"...", ".2.", "111"}).compile();
  EXPECT_TRUE(terrain.has_pieces());
  terrain.set_cell({1, 1}, 0);
  EXPECT_FALSE(terrain.has_pieces());
  expect_same(terrain, TestMap({"...", "...", "111"}).compile());
}

TEST(TerrainEdit, CopiesAreIndependent) {
  const Terrain before = TestMap({"...", ".2.", "111"}).compile();
  Terrain after = before;
  EXPECT_TRUE(after == before);
  after.set_cell({1, 1}, kSolid);
  EXPECT_FALSE(after == before);
  EXPECT_EQ(before.tile_at({1, 1}), kUp);
  expect_same(before, TestMap({"...", ".2.", "111"}).compile());
  expect_same(after, TestMap({"...", ".1.", "111"}).compile());
  after.set_cell({1, 1}, kUp);
  EXPECT_TRUE(after == before);
}

}  // namespace talus::terrain_test
