// Where the outline of the ground jumps from one column of cells to the next: a side of a tile is exposed
// there, and stops what runs along.
#include <algorithm>
#include <cmath>

#include "lint_parts.h"
#include "lint_text.h"

namespace talus {
namespace {

constexpr int kPatch = 64;  // cells, side of what is compiled at a time

struct End {
  double y = 0;  // px
  bool floor = true;
  int row = 0;  // of the cell that it is in
  Cell tile;    // whose shape it is
};

class SeamFinder {
 public:
  SeamFinder(const Level& level, const LintTiles& tiles, std::vector<Seam>& out)
      : level_(level),
        tiles_(tiles),
        compiler_(level.map.width(), tiles.outlines(), tiles.curves().pieces, tiles.curves().ends,
                  [&level, &tiles](Cell c) -> const TileOutline& {
                    static const TileOutline kNothing;
                    return level.map.contains(c) ? tiles.outlines()[level.map.at(c)] : kNothing;
                  }),
        out_(out) {}

  void find(std::array<Cell, 2> area) {
    const Cell first{std::max(area[0].x - 1, 0), std::max(area[0].y - 1, 0)};
    const Cell last{std::min(area[1].x + 1, level_.map.width() - 1),
                    std::min(area[1].y + 1, level_.map.height() - 1)};
    compiler_.enter({first, last});
    around_ = {first, last};
    const std::size_t cells =
        static_cast<std::size_t>(last.x - first.x + 1) * static_cast<std::size_t>(last.y - first.y + 1);
    touched_.assign(cells, false);
    ground_.assign(cells, false);
    for (Cell c = first; c.y <= last.y; ++c.y) {
      for (c.x = first.x; c.x <= last.x; ++c.x)
        ground_[index_of(c)] = tiles_.outlines()[level_.map.at(c)].full;
    }
    compiler_.for_lines([this](Cell c, const TileOutline& shape) {
      const auto& [from, to] = shape.touched;
      mark({c.x + from.x, c.y + from.y}, {c.x + to.x, c.y + to.y}, touched_);
      // Its neighbours are touched, but not covered.
      mark({c.x + from.x + 1, c.y + from.y + 1}, {c.x + to.x - 1, c.y + to.y - 1}, ground_);
    });
    for (Cell c = area[0]; c.y <= area[1].y; ++c.y) {
      for (c.x = area[0].x; c.x <= area[1].x; ++c.x) {
        if (touched_[index_of(c)] && c.x + 1 < level_.map.width()) check(c);
      }
    }
  }

 private:
  std::size_t index_of(Cell c) const {  // of a cell around the area
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

  // The exposed ends of floors and ceilings at one side of a cell.
  void ends_of(Cell cell, bool right, std::vector<End>& ends) {
    if (!ground_[index_of(cell)]) return;
    pieces_.clear();
    compiler_.compile(cell, {}, pieces_);
    const double x = (cell.x + (right ? 1.0 : 0.0)) * kTileSize;
    const double row0 = cell.y * 1.0 * kTileSize, row1 = row0 + kTileSize;
    for (const Piece<double>& piece : pieces_) {
      const bool ends_here = right ? piece.x1 == x : piece.x0 == x;
      if (piece.is_wall() || !ends_here) continue;
      // A steep piece is in several cells: its end counts in one of them.
      const double y = right ? piece.y1 : piece.y0;
      const bool floor = piece.facing == Facing::up;
      const bool lower = y > std::min(piece.y0, piece.y1) || (!floor && piece.y0 == piece.y1);
      const bool in_row = lower ? y > row0 && y <= row1 : y >= row0 && y < row1;
      if (in_row)
        ends.push_back(
            {y, floor, cell.y, {piece.origin % level_.map.width(), piece.origin / level_.map.width()}});
    }
  }

  void check(Cell cell) {
    here_.clear();
    ends_of(cell, true, here_);
    if (here_.empty()) return;
    there_.clear();
    const int last = std::min(cell.y + 1, level_.map.height() - 1);
    for (Cell other{cell.x + 1, std::max(cell.y - 1, 0)}; other.y <= last; ++other.y)
      ends_of(other, false, there_);
    for (const End& end : here_) find_jump(cell, end);
  }

  void find_jump(Cell cell, const End& end) {
    double jump = kTileSize;  // the least, below that
    Seam seam{cell, {}, end.y, 0, end.tile, {}, end.floor};
    for (const End& next : there_) {
      const double by = std::abs(next.y - end.y);
      if (next.floor != end.floor || by >= jump) continue;
      jump = by;
      seam.right = {cell.x + 1, next.row};
      seam.right_y = next.y;
      seam.right_tile = next.tile;
    }
    if (jump == kTileSize || jump <= tiles_.seam() || is_on_curve(cell, end)) return;
    // Slopes that lack a half are told of as such.
    if (!has_fault(seam.left_tile) && !has_fault(seam.right_tile)) out_.push_back(seam);
  }

  bool has_fault(Cell slope) const { return slope_fault_at(level_, tiles_, slope).has_value(); }

  // Whether a curve goes on where a floor or a ceiling ends.
  bool is_on_curve(Cell cell, const End& end) const {
    const double x = (cell.x + 1.0) * kTileSize;
    const auto ends = tiles_.curves().ends.at({x, end.y}, true);
    return std::any_of(ends.begin(), ends.end(), [&](const CurveEnds::End& curve) {
      return (tiles_.curves().pieces[curve.piece].facing == Facing::up) == end.floor;
    });
  }

  const Level& level_;
  const LintTiles& tiles_;
  OutlineCompiler compiler_;
  std::vector<Seam>& out_;
  std::array<Cell, 2> around_{};  // the area and its neighbours
  // By cell around the area: whether a slope or the like may change the outline; and whether there is ground.
  std::vector<bool> touched_, ground_;
  std::vector<Piece<double>> pieces_;
  std::vector<End> here_, there_;
};

bool has_lines(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area) {
  const int reach = tiles.reach();
  const int x0 = std::max(area[0].x - reach, 0), x1 = std::min(area[1].x + reach, level.map.width() - 1);
  const int y0 = std::max(area[0].y - reach, 0), y1 = std::min(area[1].y + reach, level.map.height() - 1);
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      if (tiles[level.map.at({x, y})].line) return true;
    }
  }
  return false;
}

}  // namespace

std::vector<Seam> seams_in(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area) {
  std::vector<Seam> seams;
  if (!tiles.outlines().has_lines()) return seams;
  SeamFinder finder(level, tiles, seams);
  for (int y = area[0].y; y <= area[1].y; y += kPatch) {
    for (int x = area[0].x; x <= area[1].x; x += kPatch) {
      const std::array<Cell, 2> patch = {
          Cell{x, y}, Cell{std::min(x + kPatch - 1, area[1].x), std::min(y + kPatch - 1, area[1].y)}};
      if (has_lines(level, tiles, patch)) finder.find(patch);
    }
  }
  return seams;
}

void lint_seams(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area,
                std::vector<Problem>& out) {
  for (const Seam& seam : seams_in(level, tiles, area)) {
    const std::string jump = px_text(std::abs(seam.left_y - seam.right_y));
    out.push_back({Severity::warning, seam.floor ? "seam" : "seam-ceiling",
                   std::string(seam.floor ? "floor" : "ceiling") + " jumps " + jump + " px between " +
                       cell_text(seam.left) + " and " + cell_text(seam.right),
                   seam.left, -1, -1});
  }
}

}  // namespace talus
