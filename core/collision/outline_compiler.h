// Finds the pieces of the ground's outline in one cell: what of the shapes there and around is exposed.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "piece.h"
#include "shape.h"

namespace talus {

// Where the pieces of curves end, walls apart, so that what goes on at a point is found without a scan of
// all.
class CurveEnds {
 public:
  struct End {
    Vec2 point;
    std::uint32_t piece;
  };
  CurveEnds() = default;
  explicit CurveEnds(std::span<const Piece<double>> pieces);
  // The pieces, by number, that begin (`first`) or that end exactly there.
  std::span<const End> at(Vec2 point, bool first) const;

 private:
  std::vector<End> begins_, ends_;  // by x, y, then piece
};

// Cuts the curves into their stretches and lines. Curve n has the pieces whose origin is -1 - n.
struct CurveOutline {
  std::vector<Piece<double>> pieces;
  CurveEnds ends;  // of the pieces
  std::vector<CurveStretch<double>> stretches;
};
CurveOutline cut_curves(std::span<const Curve> curves);

// A full tile, all of whose sides are ground.
bool is_full(const TileShape& shape);
// A shape that is neither none nor a full tile: its outline is in pieces.
bool is_line_shape(const TileShape& shape);
// The first and the last of the cells whose outline such a shape may change.
std::array<Cell, 2> cells_touched_by(const TileShape& shape, Cell cell);

class OutlineCompiler {
 public:
  using ShapeAt = std::function<const TileShape&(Cell)>;  // any cell; a shape of kind none outside of the map

  // width: of the map, cells, for Piece::origin. curve_ends: those of `curves`. The spans and the ends must
  // outlive the compiler.
  OutlineCompiler(int width, std::span<const TileShape> shapes, std::span<const Piece<double>> curves,
                  const CurveEnds& curve_ends, ShapeAt shape_at);

  // The cells whose outline depends on what the given cell is, from the first to the last.
  std::array<Cell, 2> reach_of(Cell cell) const;
  // The cells that the outline of the area's cells depends on.
  std::array<Cell, 2> sources_of(std::array<Cell, 2> area) const;
  // Appends the pieces in the cell: of its own shapes, and those of `curve_numbers`, indices into the curves.
  void compile(Cell cell, std::span<const std::uint32_t> curve_numbers, std::vector<Piece<double>>& out);

 private:
  // The line of a slope or profile between two of its heights, or a flat side of a body.
  struct Line {
    double x0, y0, x1, y1;
    double base_x, base_y, slope, slope_rest;
    double at(double x) const;
  };
  // What covers a strip one cell wide, from its top down to its bottom; or a one-way line, which covers
  // nothing.
  struct Body {
    std::int32_t origin = 0;
    bool one_way = false;
    bool is_floor = true;                    // the top is the shape's line, not the bottom
    bool has_top = true, has_bottom = true;  // of a one-way line the side that stops
    std::vector<Line> top, bottom;           // left to right
  };
  struct Interval {
    double from, to;
  };
  using Strip = std::vector<Body>;

  static Line line_between(double x0, double y0, double x1, double y1);
  static double height_at(const std::vector<Line>& lines, double x, bool to_the_right);
  Body body_of(const TileShape& shape, Cell anchor, int column) const;
  void gather(Cell cell);
  Strip strip_of(int column, int row) const;

  void compile_surface(std::size_t body, bool top, Cell cell, std::vector<Piece<double>>& out) const;
  std::vector<Interval> hidden_parts(std::size_t body, bool top, const Line& line, double x0,
                                     double x1) const;
  void compile_wall(Cell cell, bool left, std::vector<Piece<double>>& out) const;
  void compile_tips(Cell cell, std::vector<Piece<double>>& out) const;
  static bool is_thick(const Body& body, double x, bool to_the_right);
  static Piece<double> wall_at(double x, double y0, double y1, bool left, std::int32_t origin, bool convex0,
                               bool convex1);
  void mark_ends(Piece<double>& piece, Cell cell) const;
  bool goes_on(const Piece<double>& piece, bool first, bool only_outward) const;

  int width_;
  std::span<const Piece<double>> curves_;
  const CurveEnds& curve_ends_;
  ShapeAt shape_at_;
  int most_tiles_ = 1, most_up_ = 0, most_down_ = 0;  // reach of the shapes in cells, beside their own

  struct Anchor {
    Cell cell;
    const TileShape* shape;
  };
  std::vector<Anchor> anchors_;  // slopes and the like that touch the cell under way
  Strip before_, here_, after_;  // the strips of the cell under way and to both sides
};

}  // namespace talus
