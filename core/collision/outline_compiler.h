// OutlineCompiler: finds the pieces of the ground's outline in one cell, the exposed parts of the shapes
// there and around it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include <talus/collision/piece.h>
#include <talus/collision/shape.h>
#include "tile_outlines.h"

namespace talus {

// The ends of the pieces of curves, except walls. What goes on at a point is found without a scan of all
// pieces.
class CurveEnds {
 public:
  struct End {
    Vec2 point;
    std::uint32_t piece;
  };
  CurveEnds() = default;
  explicit CurveEnds(std::span<const Piece<double>> pieces);
  // The numbers of the pieces that begin (`first`) or end exactly there.
  std::span<const End> at(Vec2 point, bool first) const;

 private:
  std::vector<End> begins_, ends_;  // sorted by x, y, then piece
};

// Cuts the curves into their stretches and lines. Curve n has the pieces whose origin is -1 - n.
struct CurveOutline {
  std::vector<Piece<double>> pieces;
  CurveEnds ends;  // ends of the pieces
  std::vector<CurveStretch<double>> stretches;
};
CurveOutline cut_curves(std::span<const Curve> curves);

// It keeps what it knows of cells, so compiling a row cell by cell is the cheapest order. The map must not
// change meanwhile.
class OutlineCompiler {
 public:
  // Puts the outlines of the tiles in a row of cells into `tiles`, from a cell on; those outside of the map
  // have no shape.
  using TilesAt = std::function<void(Cell from, std::span<const TileOutline*> tiles)>;

  // width: of the map in cells, for Piece::origin. curve_ends: the ends of `curves`. The tiles, the curves
  // and their ends must outlive the compiler.
  OutlineCompiler(int width, const TileOutlines& tiles, std::span<const Piece<double>> curves,
                  const CurveEnds& curve_ends, TilesAt tiles_at);

  // The cells that are compiled next are in this area, from the first to the last. Both must be on the map.
  void enter(std::array<Cell, 2> area);
  // Calls use(cell, tile) for each sloped tile that may be on the outline of the area's cells.
  template <class Use>
  void for_lines(Use use) const {
    for (const auto& [cell, tile] : lines_) use(cell, *tile);
  }
  // Appends the pieces in the cell: those of its own shapes, and those of the curves with these indices.
  void compile(Cell cell, std::span<const std::uint32_t> curve_numbers, std::vector<Piece<double>>& out);

 private:
  struct Interval {
    double from, to;
  };
  // A body covers a strip one cell wide from its top down to its bottom, or, if it is of a polygon, a part of
  // that width. A one-way line covers nothing.
  struct Body {
    const TileColumn* column;  // of the tile's outline
    Vec2 corner;               // px, of the tile's own cell
    std::int32_t origin;
    bool is_full;        // of a full tile
    double left, right;  // x of its ends
    // px, its y are within this range, which is a little larger, as its ends are rounded unlike its lines
    double highest, lowest;
    Interval at_left, at_right;  // from its top to its bottom, just inside of its left and right end

    Body(const TileOutlines& tiles, const TileColumn& of, Cell cell, bool is_full, int map_width);
    bool one_way() const { return column->one_way; }
    // A one-way line stops with one side alone.
    bool has(bool top) const { return !column->one_way || column->is_floor == top; }
    bool is_of_polygon() const { return column->polygon >= 0; }
    // No side of a polygon is inside of it.
    bool is_of_polygon_of(const Body& other) const {
      return is_of_polygon() && column->polygon == other.column->polygon && origin == other.origin;
    }
    // Whether it covers a place just right (or left) of x.
    bool is_beside(double x, bool to_the_right) const {
      return to_the_right ? left <= x && x < right : left < x && x <= right;
    }
    const std::vector<OutlineLine>& lines(bool top) const { return top ? column->top : column->bottom; }
    double height_at(bool top, double x, bool to_the_right) const;
    Interval range_at(double x, bool to_the_right) const;  // as at_left, just right (or left) of x
    // Whether the body has any height right (or left) of x; a line has none.
    bool is_thick(double x, bool to_the_right) const;
  };
  // A part of one side of a strip that is ground.
  struct Cover {
    Interval part;
    std::int32_t origin;  // origin of its uppermost body
  };
  // What is known about the column around a cell.
  struct Strip {
    Cell cell{-2, -2};
    std::vector<Body> bodies;
    std::vector<Cover> left, right;  // from the top
    bool has_polygons = false;
    std::vector<double> cuts;  // x between its sides where a body begins or ends; of polygons alone
  };
  // A part of a sloped tile, in the column of cells that it is in.
  struct Part {
    const TileColumn* column;
    Cell cell;                // of the tile
    int first_row, last_row;  // whose outline it may change
  };
  // What continues at the end of a piece.
  struct Next {
    bool any = false;      // whether another line that faces the same way continues
    bool outward = false;  // whether one of these does not fall back from the open side
    // Whether lines alone that bodies from below pass rise from the end of a solid floor.
    bool covers = false;
  };

  const TileOutline& tile(Cell cell) const {
    return *tiles_here_[static_cast<std::size_t>(cell.y - sources_[0].y) * sources_width_ +
                        (cell.x - sources_[0].x)];
  }
  void note_lines(std::array<Cell, 2> area);
  const Strip& strip_at(int column, int row);
  const Strip& strip_beside(double x, bool to_the_right) const;
  static void cut(Strip& strip, double left, double right);
  static void cover(const Strip& strip, double x, bool to_the_right, std::vector<Cover>& covers);

  bool may_be_in_row(double y0, double y1, bool top, double row0) const;
  void compile_surface(const Body& body, bool top, Cell cell, std::vector<Piece<double>>& out);
  void find_open(const Body& body, bool top, const OutlineLine& line, const Interval& part);
  void take_out_hidden(const Body& body, bool top, const OutlineLine& line, double x0, double x1);
  static void take_out(std::vector<Interval>& parts, double from, double to);
  void compile_walls(Cell cell, std::vector<Piece<double>>& out);
  void compile_wall(double x, bool left, Cell cell, std::span<const Cover> ground,
                    std::span<const Cover> beside, std::vector<Piece<double>>& out);
  void compile_tips(Cell cell, std::vector<Piece<double>>& out) const;
  void compile_tip(const Body& body, Vec2 at, bool first, Cell cell, std::vector<Piece<double>>& out) const;
  bool goes_on_at(double x, double y, bool to_the_right) const;
  static Piece<double> wall_at(double x, double y0, double y1, bool left, std::int32_t origin, bool convex0,
                               bool convex1);
  void mark_ends(Piece<double>& piece, Cell cell) const;
  Next next_of(const Piece<double>& piece, bool first) const;

  int width_;
  const TileOutlines& tiles_;
  std::span<const Piece<double>> curves_;
  const CurveEnds& curve_ends_;
  TilesAt tiles_at_;

  std::array<Cell, 2> sources_{};  // the area that the sources are in
  int sources_width_ = 0;
  std::vector<const TileOutline*> tiles_here_;              // tiles of the sources, row by row
  std::vector<std::pair<Cell, const TileOutline*>> lines_;  // the sloped ones among them
  std::vector<std::vector<Part>> parts_of_columns_;         // by column from first_column_ on, row by row
  int first_column_ = 0;                                    // the one left of the area
  std::array<Strip, 3> strips_;  // the three columns last looked at, each in its place modulo 3
  const Strip *before_ = nullptr, *here_ = nullptr, *after_ = nullptr;  // strips around the current cell

  // Kept for their memory: the open parts of a line, those of a part of it, and the places where they may
  // change.
  std::vector<Interval> open_, parts_;
  std::vector<double> ends_;
  std::vector<Cover> before_cut_, after_cut_;  // left and right of a cut
};

}  // namespace talus
