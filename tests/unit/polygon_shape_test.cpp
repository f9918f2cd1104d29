// Tiles whose shape is a polygon or a group: which are valid, and the ground that they make.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <talus/collision/cast.h>
#include "collision/ground_queries.h"

namespace talus::polygon_shape_test {

using Kind = TileShape::Kind;
using Points = std::vector<Vec2>;

TileShape polygon(Points points) {
  TileShape shape;
  shape.kind = Kind::polygon;
  shape.points = std::move(points);
  return shape;
}

TileShape group(std::vector<TileShape> parts) {
  TileShape shape;
  shape.kind = Kind::group;
  shape.parts = std::move(parts);
  return shape;
}

TileShape slope(double left, double right) { return {.kind = Kind::slope, .heights = {left, right}}; }

const TileShape kSolid{.kind = Kind::solid};
const Points kBox = {{2, 3}, {7, 3}, {7, 8}, {2, 8}};

std::string problem(const TileShape& shape) { return problem_of(shape, {8, 8}).value_or(""); }

// A map of 6x4 tiles of 8x8 px, each the number of a shape.
struct Map {
  std::vector<TileShape> shapes;  // from tile 1
  std::vector<TileNumber> cells = std::vector<TileNumber>(24);
  Map(std::vector<TileShape> of, std::vector<std::pair<Cell, int>> tiles) : shapes(std::move(of)) {
    for (const auto& [cell, tile] : tiles)
      cells[static_cast<std::size_t>(cell.y) * 6 + cell.x] = static_cast<TileNumber>(tile);
  }
  Terrain compile() const {
    TerrainSource source;
    source.width = 6, source.height = 4;
    source.cells = cells;
    for (std::size_t i = 0; i < shapes.size(); ++i) source.shapes[i + 1] = shapes[i];
    return Terrain(source);
  }
};

Terrain one_tile(const TileShape& shape) { return Map({shape}, {{{2, 2}, 1}}).compile(); }  // at 16, 16

using Ends = std::pair<std::pair<double, double>, std::pair<double, double>>;

// All pieces that have a length, each once.
std::vector<Ends> pieces(const Terrain& terrain) {
  std::vector<Ends> all;
  for (Cell c; c.y < terrain.height(); ++c.y) {
    for (c.x = 0; c.x < terrain.width(); ++c.x) {
      for (const Piece<double>& p : terrain.pieces_in(c)) {
        const Ends ends{{p.x0, p.y0}, {p.x1, p.y1}};
        if (ends.first != ends.second && std::find(all.begin(), all.end(), ends) == all.end())
          all.push_back(ends);
      }
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

Contact<double> cast(const Terrain& ground, Rect box, Vec2 motion) {
  return cast_box(ground, Cast<double>{box, motion});
}

// ---- Problems ----

TEST(PolygonShape, ValidOnesHaveNoProblem) {
  EXPECT_EQ(problem(polygon(kBox)), "");
  EXPECT_EQ(problem(polygon({{2, 8}, {7, 8}, {7, 3}})), "") << "the other way around";
  EXPECT_EQ(problem(polygon({{0, 0}, {4, 4}, {8, 0}, {8, 8}, {0, 8}})), "") << "not convex";
  EXPECT_EQ(problem(polygon({{-64, -64}, {72, -64}, {72, 72}})), "") << "as far as it may reach";
  EXPECT_EQ(problem(polygon({{0, 0}, {4, 0}, {8, 0}, {8, 8}})), "") << "a point on a straight side";
  EXPECT_EQ(problem(group({polygon(kBox), kSolid, slope(0, 8)})), "");
}

TEST(PolygonShape, ProblemsSayWhy) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(problem(polygon({{0, 0}, {8, 8}})), "needs at least 3 points");
  EXPECT_EQ(problem(polygon(Points(257))), "has more than 256 points");
  EXPECT_EQ(problem(polygon({{0, 0}, {8, 0}, {kNan, 8}})), "has a point that is not a number");
  EXPECT_EQ(problem(polygon({{0, 0}, {72.01, 0}, {8, 8}})),
            "has a point that is further than 8 tiles from its tile");
  EXPECT_EQ(problem(polygon({{0, 0}, {8, -64.01}, {8, 8}})),
            "has a point that is further than 8 tiles from its tile");
  EXPECT_EQ(problem(polygon({{0, 0}, {0.001, 0}, {8, 8}})),
            "has two neighbouring points at the same place, rounded to 1/256 px");
  EXPECT_EQ(problem(polygon({{0, 0}, {4, 4}, {8, 8}})), "has no area");
  EXPECT_EQ(problem(slope(0, 99)), "has a height that is not from 0 to 64 px");
  TileShape shape = kSolid;
  shape.points = kBox;
  EXPECT_EQ(problem(shape), "has points, which only a polygon has");
  shape = polygon(kBox);
  shape.parts = {kSolid};
  EXPECT_EQ(problem(shape), "has parts, which only a group has");
  shape = polygon(kBox);
  shape.heights = {1, 2};
  EXPECT_EQ(problem(shape), "has heights, which only a slope or a profile has");
}

TEST(PolygonShape, SidesMayNotMeet) {
  const std::string crosses = "has sides that cross or touch one another";
  EXPECT_EQ(problem(polygon({{0, 0}, {8, 8}, {8, 0}, {0, 8}})), crosses);
  EXPECT_EQ(problem(polygon({{0, 0}, {8, 0}, {4, 4}, {8, 8}, {0, 8}, {4, 4}})), crosses) << "in a point";
  EXPECT_EQ(problem(polygon({{0, 0}, {8, 0}, {8, 8}, {4, 0}, {0, 8}})), crosses) << "a point on a side";
  EXPECT_EQ(problem(polygon({{0, 0}, {8, 0}, {4, 0}, {4, 8}})), crosses) << "a side that turns back";
}

TEST(PolygonShape, ProblemsOfGroupsSayWhy) {
  EXPECT_EQ(problem(group({})), "has no parts");
  EXPECT_EQ(problem(group(std::vector<TileShape>(65, kSolid))), "has more than 64 parts");
  EXPECT_EQ(problem(group({group({kSolid})})), "has a part that is a group");
  EXPECT_EQ(problem(group({TileShape{}})), "has a part that is nothing");
  EXPECT_EQ(problem(group({kSolid, polygon({})})), "has a part that needs at least 3 points");
  Points circle;
  for (int i = 0; i < 256; ++i)
    circle.push_back({4 + 4 * std::cos(i * 0.02454), 4 + 4 * std::sin(i * 0.02454)});
  EXPECT_EQ(problem(group(std::vector<TileShape>(4, polygon(circle)))), "");
  EXPECT_EQ(problem(group(std::vector<TileShape>(5, polygon(circle)))), "has more than 1024 points");
}

// ---- Ground ----

TEST(PolygonShape, ABoxHasItsFourSides) {
  EXPECT_EQ(pieces(one_tile(polygon(kBox))),
            (std::vector<Ends>{
                {{18, 19}, {18, 24}}, {{18, 19}, {23, 19}}, {{18, 24}, {23, 24}}, {{23, 19}, {23, 24}}}));
}

TEST(PolygonShape, StopsBoxesOnAllSides) {
  const Terrain ground = one_tile(polygon(kBox));
  const auto left = cast(ground, {0, 20, 2, 2}, {40, 0});
  EXPECT_EQ(left.position, (Vec2{16, 20}));
  EXPECT_EQ(left.normal, (Vec2{-1, 0}));
  EXPECT_EQ(cast(ground, {40, 20, 2, 2}, {-40, 0}).position, (Vec2{23, 20}));
  EXPECT_EQ(cast(ground, {20, 0, 2, 2}, {0, 40}).position, (Vec2{20, 17}));
  EXPECT_EQ(cast(ground, {20, 30, 2, 2}, {0, -20}).position, (Vec2{20, 24}));
  EXPECT_FALSE(cast(ground, {16, 0, 2, 2}, {0, 30})) << "beside it";
}

// A notch like a V in a full tile: the cut at its lowest point leaves no seam in the sides.
TEST(PolygonShape, SidesAreOneLineHoweverTheGroundIsCut) {
  const Terrain ground = one_tile(polygon({{0, 0}, {8, 4}, {0, 8}, {6, 4}}));
  EXPECT_EQ(pieces(ground),
            (std::vector<Ends>{
                {{16, 16}, {22, 20}}, {{16, 16}, {24, 20}}, {{16, 24}, {22, 20}}, {{16, 24}, {24, 20}}}));
}

// Where a side comes to the next column its height is rounded: it is no end all the same.
TEST(PolygonShape, ASideGoesOnOverTheBorderOfACell) {
  for (int i = 0; i < 200; ++i) {
    const TileShape shape = polygon({{1.25, 0.5}, {14.5, 5 + i / 256.0}, {1.25, 7.75}});
    for (const Cell cell : {Cell{2, 2}, Cell{3, 2}}) {
      const Terrain terrain = one_tile(shape);
      for (const Piece<double>& piece : terrain.pieces_in(cell)) {
        if (piece.facing != Facing::up) continue;
        EXPECT_TRUE(piece.x1 != 24 || !piece.last1) << i;
        EXPECT_TRUE(piece.x0 != 24 || !piece.last0) << i;
      }
    }
  }
}

TEST(PolygonShape, ReachesOverCellsOnAllSides) {
  const Terrain ground = one_tile(polygon({{-8, -8}, {16, -8}, {16, 12}, {-8, 12}}));
  EXPECT_EQ(cast(ground, {0, 20, 2, 2}, {40, 0}).position, (Vec2{6, 20}));
  EXPECT_EQ(cast(ground, {40, 20, 2, 2}, {-40, 0}).position, (Vec2{32, 20}));
  EXPECT_EQ(cast(ground, {20, 0, 2, 2}, {0, 40}).position, (Vec2{20, 6}));
}

TEST(PolygonShape, NeighboursAreOneOutline) {
  const TileShape half = polygon({{0, 4}, {8, 4}, {8, 8}, {0, 8}});
  const Terrain ground = Map({half, kSolid}, {{{1, 2}, 1}, {{2, 2}, 1}, {{1, 3}, 2}, {{2, 3}, 2}}).compile();
  for (const Ends& ends : pieces(ground)) {
    const bool is_inner = ends.first.first == 16 && ends.second.first == 16;
    EXPECT_FALSE(is_inner) << "a wall between two halves";
    EXPECT_FALSE(ends.first.second == 24 && ends.second.second == 24)
        << "a line between a half and the tile below";
  }
}

TEST(PolygonShape, OneWayOnesStopFromTheirSide) {
  TileShape shape = polygon({{0, 4}, {4, 2}, {8, 4}, {4, 6}});
  shape.one_way = true;
  const Terrain floor = one_tile(shape);
  EXPECT_EQ(cast(floor, {20, 0, 0, 2}, {0, 40}).position, (Vec2{20, 16}));
  EXPECT_FALSE(cast(floor, {20, 30, 0, 2}, {0, -30}));
  EXPECT_FALSE(cast(floor, {0, 20, 2, 1}, {40, 0}));
  EXPECT_FALSE(overlaps_ground(floor, Rect{18, 19, 4, 2}));
  shape.side = TileShape::Side::ceiling;
  const Terrain ceiling = one_tile(shape);
  EXPECT_FALSE(cast(ceiling, {20, 0, 0, 2}, {0, 40}));
  EXPECT_EQ(cast(ceiling, {20, 30, 0, 2}, {0, -30}).position, (Vec2{20, 22}));
}

TEST(PolygonShape, AGroupOfOneIsItsPart) {
  EXPECT_EQ(pieces(one_tile(group({slope(0, 8)}))), pieces(one_tile(slope(0, 8))));
  EXPECT_TRUE(one_tile(group({kSolid})).is_solid({2, 2}));
  EXPECT_FALSE(one_tile(group({kSolid})).is_detailed({2, 2}));
}

TEST(PolygonShape, PartsOfAGroupAreOneOutline) {
  const Terrain ground = one_tile(group({slope(0, 8), polygon({{0, 0}, {8, 0}, {8, 8}})}));
  EXPECT_EQ(pieces(ground), (std::vector<Ends>{{{16, 16}, {20, 20}},
                                               {{16, 16}, {24, 16}},
                                               {{16, 24}, {20, 20}},
                                               {{16, 24}, {24, 24}},
                                               {{24, 16}, {24, 24}}}));
}

// The sides lie on one straight line, but begin at different places on it, so that roundings may differ.
TEST(PolygonShape, SidesOnOneLineLeaveNoSeam) {
  for (const double run : {3, 5, 6, 7, 11}) {
    for (double rise = 1; rise < run; ++rise) {
      const auto on_line = [&](double part) { return Vec2{1 + part * run / 4, part * rise / 4}; };
      const Vec2 a = on_line(-3), b = on_line(4), c = on_line(1), d = on_line(3);
      const TileShape below = polygon({a, b, {a.x, 16}}), above = polygon({c, d, {d.x, -8}});
      for (const Ends& ends : pieces(one_tile(group({above, below})))) {
        const double middle = (ends.first.first + ends.second.first) / 2 - 16;
        EXPECT_FALSE(ends.first.first < ends.second.first && middle > c.x && middle < d.x &&
                     ends.second.second > ends.first.second && ends.second.second < 24)
            << rise << "/" << run << ": " << ends.first.first << " to " << ends.second.first;
      }
    }
  }
}

TEST(PolygonShape, PaintedCellsGiveTheSamePieces) {
  const std::vector<TileShape> shapes = {polygon({{-9, 3}, {3, -9}, {9, 12}}),
                                         group({slope(0, 8), polygon(kBox)}), kSolid};
  const std::vector<std::pair<Cell, int>> tiles = {
      {{2, 2}, 1}, {{3, 2}, 2}, {{4, 1}, 3}, {{1, 1}, 2}, {{5, 3}, 1}};
  Terrain painted = Map(shapes, {}).compile();
  for (const auto& [cell, tile] : tiles) painted.set_cell(cell, static_cast<TileNumber>(tile));
  EXPECT_EQ(pieces(painted), pieces(Map(shapes, tiles).compile()));
  for (const auto& [cell, tile] : tiles) painted.set_cell(cell, 0);
  EXPECT_TRUE(pieces(painted).empty());
}

TEST(PolygonShape, QueriesSeeIt) {
  const Terrain ground = one_tile(polygon({{0, 0}, {8, 4}, {0, 8}}));
  EXPECT_TRUE(overlaps_ground(ground, Rect{17, 19, 2, 2}));
  EXPECT_FALSE(overlaps_ground(ground, Rect{22, 16, 2, 2})) << "in its tile, but not in it";
  EXPECT_EQ(floor_below(ground, Rect{20, 0, 0, 2}, 100)->y, 18);
  EXPECT_EQ(ceiling_above(ground, Rect{20, 30, 0, 1}, 100)->y, 22);
  const auto out = way_out(ground, Rect{22, 19, 4, 2});
  ASSERT_TRUE(out);
  EXPECT_FALSE(overlaps_ground(ground, Rect{22 + out->x, 19 + out->y, 4, 2}));
}

}  // namespace talus::polygon_shape_test
