// Compiles the outline around each cell, and compares its ends at the borders of columns of cells.
#include "seam_finder.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "slope_fault.h"

namespace talus {
namespace {

constexpr int kPatch = 64;  // side of the patch that is compiled at a time, cells

struct End {
  double y = 0;  // px
  bool floor = true;
  int row = 0;  // row of the cell that the end is in
  Cell tile;    // cell of the tile whose shape it is
  bool one_way = false;
};

class SeamFinder {
 public:
  SeamFinder(const Level& level, const LintTiles& tiles, SeamsAndCracks& out)
      : level_(level),
        tiles_(tiles),
        compiler_(level.map.width(), tiles.outlines(), tiles.curves().pieces, tiles.curves().ends,
                  [&level, &tiles](Cell from, std::span<const TileOutline*> row) {
                    static const TileOutline kNothing;
                    for (Cell c = from; const TileOutline*& outline : row) {
                      outline = level.map.contains(c) ? &tiles.outlines()[level.map.tile_at(c)] : &kNothing;
                      ++c.x;
                    }
                  }),
        out_(out),
        tile_height_(level.map.tile_size().height),
        least_body_(tiles.player() ? std::min(tiles.player()->y, tile_height_) : tile_height_) {}

  void find(std::array<Cell, 2> area) {
    // A floor may go on in the row above or below, and so may the ceiling over it.
    const Cell first{std::max(area[0].x - 1, 0), std::max(area[0].y - 2, 0)};
    const Cell last{std::min(area[1].x + 1, level_.map.width() - 1),
                    std::min(area[1].y + 2, level_.map.height() - 1)};
    compiler_.enter({first, last});
    for (Compiled& known : compiled_) known.cell = {-1, -1};
    around_ = {first, last};
    const std::size_t cells =
        static_cast<std::size_t>(last.x - first.x + 1) * static_cast<std::size_t>(last.y - first.y + 1);
    touched_.assign(cells, false);
    ground_.assign(cells, false);
    for (Cell c = first; c.y <= last.y; ++c.y) {
      for (c.x = first.x; c.x <= last.x; ++c.x)
        ground_[index_of(c)] = tiles_.outlines()[level_.map.tile_at(c)].full;
    }
    compiler_.for_lines([this](Cell c, const TileOutline& shape) {
      const auto& [from, to] = shape.touched;
      mark({c.x + from.x, c.y + from.y}, {c.x + to.x, c.y + to.y}, touched_);
      // The shape touches its neighbours, but does not cover them.
      mark({c.x + from.x + 1, c.y + from.y + 1}, {c.x + to.x - 1, c.y + to.y - 1}, ground_);
    });
    for (Cell c = area[0]; c.y <= area[1].y; ++c.y) {
      for (c.x = area[0].x; c.x <= area[1].x; ++c.x) {
        if (!touched_[index_of(c)]) continue;
        if (c.x + 1 < level_.map.width()) check(c);
        check_crack(c);
      }
    }
  }

 private:
  std::size_t index_of(Cell c) const {  // cell: in or around the area
    return static_cast<std::size_t>(c.y - around_[0].y) *
               static_cast<std::size_t>(around_[1].x - around_[0].x + 1) +
           static_cast<std::size_t>(c.x - around_[0].x);
  }
  void mark(Cell from, Cell to, std::vector<bool>& cells) const {
    for (Cell c{0, std::max(from.y, around_[0].y)}; c.y <= std::min(to.y, around_[1].y); ++c.y) {
      for (c.x = std::max(from.x, around_[0].x); c.x <= std::min(to.x, around_[1].x); ++c.x)
        cells[index_of(c)] = true;
    }
  }

  // Compiled patches are kept, as cells beside and below ask for them again.
  const std::vector<Piece<double>>& pieces_at(Cell cell) {
    for (const Compiled& known : compiled_)
      if (known.cell == cell) return known.pieces;
    Compiled& next = compiled_[next_++ % compiled_.size()];
    next.cell = cell;
    next.pieces.clear();
    compiler_.compile(cell, {}, next.pieces);
    return next.pieces;
  }

  // Collects the exposed ends of floors and ceilings at one side of a cell.
  void ends_of(Cell cell, bool right, std::vector<End>& ends) {
    if (!ground_[index_of(cell)]) return;
    const double x = level_.map.x_of(right ? cell.x + 1 : cell.x);
    const double row0 = level_.map.y_of(cell.y), row1 = level_.map.y_of(cell.y + 1);
    for (const Piece<double>& piece : pieces_at(cell)) {
      const bool ends_here = right ? piece.x1 == x : piece.x0 == x;
      if (piece.is_wall() || !ends_here) continue;
      // A steep piece is in several cells. Its end counts in only one of them.
      const double y = right ? piece.y1 : piece.y0;
      const bool floor = piece.facing == Facing::up;
      const bool lower = y > std::min(piece.y0, piece.y1) || (!floor && piece.y0 == piece.y1);
      const bool in_row = lower ? y > row0 && y <= row1 : y >= row0 && y < row1;
      if (in_row)
        ends.push_back({y,
                        floor,
                        cell.y,
                        {piece.origin % level_.map.width(), piece.origin / level_.map.width()},
                        piece.one_way});
    }
  }

  // The same of the cell and those above and below it.
  void ends_around(Cell cell, bool right, std::vector<End>& ends) {
    const int last = std::min(cell.y + 1, level_.map.height() - 1);
    for (int row = std::max(cell.y - 1, 0); row <= last; ++row) ends_of({cell.x, row}, right, ends);
  }

  void check(Cell cell) {
    here_.clear();
    ends_of(cell, true, here_);
    if (here_.empty()) return;
    there_.clear();
    ends_around({cell.x + 1, cell.y}, false, there_);
    for (const End& end : here_) find_jump(cell, end);
  }

  // The floor at a side of a cell, with a ceiling so close above it that no body fits between them.
  struct Slit {
    double floor = 0, ceiling = 0;  // px
    double gap() const { return floor - ceiling; }
    friend bool operator==(const Slit&, const Slit&) = default;
  };
  std::optional<Slit> slit_at(Cell cell, bool right) {
    slit_ends_.clear();
    ends_of(cell, right, slit_ends_);
    const std::size_t here = slit_ends_.size();
    if (cell.y > 0) ends_of({cell.x, cell.y - 1}, right, slit_ends_);
    std::optional<Slit> found;
    for (std::size_t i = 0; i < here; ++i) {
      const End& floor = slit_ends_[i];
      if (!floor.floor || floor.one_way) continue;
      for (const End& ceiling : slit_ends_) {
        const double gap = floor.y - ceiling.y;
        if (ceiling.floor || ceiling.one_way || gap <= 0 || gap >= least_body_) continue;
        if (!found || gap < found->gap()) found = Slit{floor.y, ceiling.y};
      }
    }
    return found;
  }

  // Whether the slit continues in the next cell with the same floor and ceiling, or at the map's edge. A slit
  // that narrows from a place where bodies are is the corner of a cave, and no crack.
  bool goes_on(Cell cell, bool right, const Slit& slit) {
    const int x = cell.x + (right ? 1 : -1);
    if (x < 0 || x >= level_.map.width()) return true;
    for (int y = std::max(cell.y - 1, 0); y <= std::min(cell.y + 1, level_.map.height() - 1); ++y)
      if (slit_at({x, y}, !right) == slit) return true;
    return false;
  }

  // Reports a crack at a cell in which it begins or ends.
  void check_crack(Cell cell) {
    if (cell.y == 0 || !ground_[index_of(cell)] || !ground_[index_of({cell.x, cell.y - 1})]) return;
    const auto left = slit_at(cell, false), right = slit_at(cell, true);
    if (!left || !right) return;
    const bool begins = !goes_on(cell, false, *left);
    if (begins || !goes_on(cell, true, *right))
      out_.cracks.push_back({cell, begins ? left->gap() : right->gap()});
  }

  void find_jump(Cell cell, const End& end) {
    double jump = tile_height_;  // the smallest jump below a whole tile
    Seam seam{cell, {}, end.y, 0, end.tile, {}, end.floor};
    for (const End& next : there_) {
      const double by = std::abs(next.y - end.y);
      if (next.floor != end.floor || by >= jump) continue;
      jump = by;
      seam.right = {cell.x + 1, next.row};
      seam.right_y = next.y;
      seam.right_tile = next.tile;
    }
    if (jump == tile_height_ || jump <= tiles_.seam() || is_on_curve(cell, end)) return;
    if (end.floor && seam.right_y < end.y && has_floor_to(cell, seam.right_y)) return;
    // Cracks and slopes that lack a half have rules of their own.
    if (is_in_slit({cell.x, end.row}, true, end.y, end.floor) ||
        is_in_slit(seam.right, false, seam.right_y, end.floor))
      return;
    if (!has_fault(seam.left_tile) && !has_fault(seam.right_tile)) out_.seams.push_back(seam);
  }

  // Whether a floor leads to this height at the right side of a cell, as a one-way slope over another floor
  // does.
  bool has_floor_to(Cell cell, double y) {
    over_.clear();
    ends_around(cell, true, over_);
    return std::any_of(over_.begin(), over_.end(),
                       [&](const End& end) { return end.floor && std::abs(end.y - y) <= tiles_.seam(); });
  }

  // Whether the floor or the ceiling that ends at this side of a cell is in a slit. The slit of a ceiling is
  // listed in the row of its floor.
  bool is_in_slit(Cell cell, bool right, double y, bool floor) {
    const int last = std::min(cell.y + (floor ? 0 : 1), level_.map.height() - 1);
    for (int row = cell.y; row <= last; ++row) {
      const auto slit = slit_at({cell.x, row}, right);
      if (slit && (floor ? slit->floor : slit->ceiling) == y) return true;
    }
    return false;
  }
  bool has_fault(Cell slope) const { return slope_fault_at(level_, tiles_, slope).has_value(); }

  // Whether a curve continues where a floor or a ceiling ends.
  bool is_on_curve(Cell cell, const End& end) const {
    const double x = level_.map.x_of(cell.x + 1);
    const auto ends = tiles_.curves().ends.at({x, end.y}, true);
    return std::any_of(ends.begin(), ends.end(), [&](const CurveEnds::End& curve) {
      return (tiles_.curves().pieces[curve.piece].facing == Facing::up) == end.floor;
    });
  }

  const Level& level_;
  const LintTiles& tiles_;
  OutlineCompiler compiler_;
  SeamsAndCracks& out_;
  const double tile_height_;      // px
  const double least_body_;       // height of the lowest body, px
  std::array<Cell, 2> around_{};  // the area and its neighbours
  // For each cell around the area: whether a line may change the outline there, and whether there is ground.
  std::vector<bool> touched_, ground_;
  struct Compiled {
    Cell cell{-1, -1};
    std::vector<Piece<double>> pieces;
  };
  std::array<Compiled, 16> compiled_;  // the last compiled patches
  std::size_t next_ = 0;               // index of the patch that is replaced next
  std::vector<End> here_, there_, over_, slit_ends_;
};

bool has_lines(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area) {
  const int reach = tiles.reach();
  const int x0 = std::max(area[0].x - reach, 0), x1 = std::min(area[1].x + reach, level.map.width() - 1);
  const int y0 = std::max(area[0].y - reach, 0), y1 = std::min(area[1].y + reach, level.map.height() - 1);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (tiles[level.map.tile_at({x, y})].line) return true;
    }
  }
  return false;
}

}  // namespace

SeamsAndCracks find_seams(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area) {
  SeamsAndCracks found;
  if (!tiles.outlines().has_lines()) return found;
  SeamFinder finder(level, tiles, found);
  for (int y = area[0].y; y <= area[1].y; y += kPatch) {
    for (int x = area[0].x; x <= area[1].x; x += kPatch) {
      const std::array<Cell, 2> patch = {
          Cell{x, y}, Cell{std::min(x + kPatch - 1, area[1].x), std::min(y + kPatch - 1, area[1].y)}};
      if (has_lines(level, tiles, patch)) finder.find(patch);
    }
  }
  return found;
}

}  // namespace talus
