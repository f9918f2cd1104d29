// Keeps a terrain's chunks, and compiles them from their tiles.
#include <talus/collision/terrain.h>

#include <algorithm>
#include <cassert>

#include "outline_compiler.h"

namespace talus {
namespace {

constexpr int kSide = BasicTerrain<double>::kChunkSide;

template <class Real>
Piece<Real> narrow(const Piece<double>& p) {
  Piece<Real> n;
  n.x0 = static_cast<Real>(p.x0), n.y0 = static_cast<Real>(p.y0);
  n.x1 = static_cast<Real>(p.x1), n.y1 = static_cast<Real>(p.y1);
  n.base_x = static_cast<Real>(p.base_x), n.base_y = static_cast<Real>(p.base_y);
  n.slope = static_cast<Real>(p.slope);
  n.slope_rest = static_cast<Real>(p.slope - static_cast<double>(n.slope) + p.slope_rest);
  n.origin = p.origin, n.stretch = p.stretch, n.facing = p.facing;
  n.convex0 = p.convex0, n.convex1 = p.convex1, n.last0 = p.last0, n.last1 = p.last1, n.one_way = p.one_way,
  n.far0 = p.far0, n.far1 = p.far1, n.covered0 = p.covered0, n.covered1 = p.covered1;
  return n;
}

template <class Real>
CurveStretch<Real> narrow(const CurveStretch<double>& s) {
  CurveStretch<Real> n;
  n.kind = static_cast<typename CurveStretch<Real>::Kind>(s.kind);
  n.sign = static_cast<Real>(s.sign);
  std::transform(std::begin(s.c), std::end(s.c), std::begin(n.c),
                 [](double c) { return static_cast<Real>(c); });
  n.bends_down = s.bends_down;
  return n;
}

// The columns, or the rows, that a stretch from a to b lies in. A stretch on a border lies in both. side: px,
// of each column or row.
struct Range {
  int first, last;
};
Range cells_between(double a, double b, int side, int count) {
  const auto within = [&](double cell) {
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(count - 1)));
  };
  return {within(std::ceil(std::min(a, b) / side) - 1), within(std::floor(std::max(a, b) / side))};
}

// The bits from the first to the last.
std::uint64_t columns_mask(int first, int last) {
  return (~std::uint64_t{0} >> (63 - last)) & (~std::uint64_t{0} << first);
}

int index_in_chunk(Cell cell) { return (cell.y % kSide) * kSide + cell.x % kSide; }

// Fills a band of a chunk whose cells know where their pieces begin: of the area, from `made`, the others
// from the old band, which may be null. All are copied once, into no more memory than they need.
template <class Band, class Pieces>
void join_pieces(const Band* old, const Pieces& made, std::array<Cell, 2> area, int rows, Band& band) {
  band.pieces.reserve(band.first.back());
  const auto keep = [&](int from, int to) {
    if (old == nullptr) return;
    const auto begin = old->pieces.begin();
    band.pieces.insert(band.pieces.end(), begin + old->first[from], begin + old->first[to]);
  };
  auto next = made.begin();
  int kept_to = 0;  // the cell up to which the band is full
  for (int y = area[0].y; y <= area[1].y; ++y) {
    const int from = y * kSide + area[0].x, to = y * kSide + area[1].x + 1;
    keep(kept_to, from);
    const auto end = next + (band.first[to] - band.first[from]);
    band.pieces.insert(band.pieces.end(), next, end);
    next = end;
    kept_to = to;
  }
  keep(kept_to, rows * kSide);
}

TerrainSource empty_source() {
  static constexpr std::array<TileNumber, 1> kNothing{};
  TerrainSource source;
  source.width = source.height = 1;
  source.cells = kNothing;
  return source;
}

}  // namespace

template <class Real>
struct BasicTerrain<Real>::Parts {
  explicit Parts(const TerrainSource& source)
      : shapes(source.shapes), outlines(source.shapes, source.tile), curves(source.curves) {}
  std::vector<TileShape> shapes;
  TileOutlines outlines;  // of the shapes
  std::vector<Curve> curves;
  std::vector<Piece<double>> curve_pieces;
  CurveEnds curve_ends;
  std::vector<CurveStretch<Real>> stretches;
  std::vector<CurveInCell> cells_of_curves;  // by cell, then by piece
};

template <class Real>
BasicTerrain<Real>::BasicTerrain() : BasicTerrain(empty_source()) {}

template <class Real>
BasicTerrain<Real>::BasicTerrain(const TerrainSource& source)
    : width_(source.width),
      height_(source.height),
      tile_(source.tile),
      tile_width_(Real(source.tile.width)),
      tile_height_(Real(source.tile.height)),
      columns_per_px_(1 / Real(source.tile.width)),
      rows_per_px_(1 / Real(source.tile.height)),
      chunk_columns_((source.width + kSide - 1) / kSide) {
  assert(is_terrain_size(width_, height_, tile_));
  assert(source.cells.size() == static_cast<std::size_t>(width_) * height_);
  assert(!source.shapes.empty() && source.shapes.size() <= kMaxTiles);
  assert(std::all_of(source.cells.begin(), source.cells.end(),
                     [&](TileNumber tile) { return tile < source.shapes.size(); }));
  assert(std::none_of(source.shapes.begin(), source.shapes.end(),
                      [&](const TileShape& s) { return problem_of(s, source.tile); }));
  assert(std::none_of(source.curves.begin(), source.curves.end(), [](auto& c) { return problem_of(c); }));
  one_way_ = std::any_of(source.shapes.begin(), source.shapes.end(), [](auto& s) { return s.one_way; }) ||
             std::any_of(source.curves.begin(), source.curves.end(),
                         [](auto& c) { return c.faces != Curve::Faces::both; });
  const auto is_conveyor = [](const auto& part) { return part.conveyor != 0; };
  conveyors_ = std::any_of(source.shapes.begin(), source.shapes.end(), is_conveyor) ||
               std::any_of(source.curves.begin(), source.curves.end(), is_conveyor);
  auto parts = std::make_shared<Parts>(source);
  CurveOutline curves = cut_curves(source.curves);
  for (const auto& stretch : curves.stretches) parts->stretches.push_back(narrow<Real>(stretch));
  parts->curve_pieces = std::move(curves.pieces);
  parts->curve_ends = std::move(curves.ends);
  parts->cells_of_curves = cells_of(parts->curve_pieces, curves.stretches);
  stretches_ = parts->stretches;
  parts_ = std::move(parts);

  chunks_.resize(static_cast<std::size_t>(chunk_columns_) * ((height_ + kSide - 1) / kSide));
  for (int y = 0; y < height_; y += kSide) {
    for (int x = 0; x < width_; x += kSide) {
      std::shared_ptr<Chunk> chunk;
      for (Cell c{x, y}; c.y < std::min(y + kSide, height_); ++c.y) {
        for (c.x = x; c.x < std::min(x + kSide, width_); ++c.x) {
          const TileNumber tile = source.cells[static_cast<std::size_t>(c.y) * width_ + c.x];
          const TileOutline& outline = parts_->outlines[tile];
          if (tile == 0 && !outline.full && !outline.line) continue;
          if (chunk == nullptr) chunk = std::make_shared<Chunk>();
          chunk->tiles[index_in_chunk(c)] = tile;
          if (outline.full) chunk->rows[c.y % kSide].solid |= std::uint64_t{1} << c.x % kSide;
        }
      }
      chunks_[chunk_index({x, y})] = std::move(chunk);
    }
  }
  compile({Cell{0, 0}, Cell{width_ - 1, height_ - 1}}, source.progress);
}

template <class Real>
std::vector<typename BasicTerrain<Real>::CurveInCell> BasicTerrain<Real>::cells_of(
    std::span<const Piece<double>> pieces, std::span<const CurveStretch<double>> stretches) const {
  std::vector<CurveInCell> cells;
  for (std::uint32_t n = 0; n < pieces.size(); ++n) {
    const Piece<double>& p = pieces[n];
    const Range columns = cells_between(p.x0, p.x1, tile_.width, width_);
    for (Cell c{columns.first, 0}; c.x <= columns.last; ++c.x) {
      const double left = static_cast<double>(c.x) * tile_.width;
      const Range rows = cells_between(p.y_at(left, stretches), p.y_at(left + tile_.width, stretches),
                                       tile_.height, height_);
      for (c.y = rows.first; c.y <= rows.last; ++c.y) cells.push_back({index_of(c), n});
    }
  }
  std::sort(cells.begin(), cells.end(), [](const CurveInCell& a, const CurveInCell& b) {
    return a.cell != b.cell ? a.cell < b.cell : a.piece < b.piece;
  });
  return cells;
}

template <class Real>
const TileShape& BasicTerrain<Real>::shape_at(Cell cell) const {
  return parts_->shapes[tile_at(cell)];
}

template <class Real>
double BasicTerrain<Real>::conveyor_of(std::int32_t origin) const {
  if (origin < 0) return parts_->curves[static_cast<std::size_t>(-1 - origin)].conveyor;
  return shape_at(cell_at(origin)).conveyor;
}

template <class Real>
const TileOutlines& BasicTerrain<Real>::outlines() const {
  return parts_->outlines;
}

template <class Real>
void BasicTerrain<Real>::set_cell(Cell cell, TileNumber tile) {
  assert(contains(cell) && tile < parts_->shapes.size());
  const TileNumber old = tile_at(cell);
  if (old == tile) return;
  auto chunk = writable_chunk(cell);
  chunk->tiles[index_in_chunk(cell)] = tile;
  const std::uint64_t bit = std::uint64_t{1} << cell.x % kSide;
  std::uint64_t& word = chunk->rows[cell.y % kSide].solid;
  word = parts_->outlines[tile].full ? word | bit : word & ~bit;
  chunks_[chunk_index(cell)] = std::move(chunk);
  compile(parts_->outlines.reach_of(cell));
}

template <class Real>
OutlineCompiler BasicTerrain<Real>::compiler() const {
  static const TileOutline kNothing;
  return OutlineCompiler(width_, parts_->outlines, parts_->curve_pieces, parts_->curve_ends,
                         [this](Cell from, std::span<const TileOutline*> tiles) {
                           std::fill(tiles.begin(), tiles.end(), &kNothing);
                           if (from.y < 0 || from.y >= height_) return;
                           const int end = std::min(from.x + static_cast<int>(tiles.size()), width_);
                           for (Cell c{std::max(from.x, 0), from.y}; c.x < end;) {
                             const Chunk* chunk = chunks_[chunk_index(c)].get();
                             const int chunk_end = std::min(c.x / kSide * kSide + kSide, end);
                             for (; c.x < chunk_end; ++c.x) {
                               const TileNumber tile =
                                   chunk == nullptr ? TileNumber{0} : chunk->tiles[index_in_chunk(c)];
                               tiles[static_cast<std::size_t>(c.x - from.x)] = &parts_->outlines[tile];
                             }
                           }
                         });
}

// Compiles the cells from the first to the last. These may lie outside of the terrain.
template <class Real>
void BasicTerrain<Real>::compile(std::array<Cell, 2> area, const std::function<bool(double)>& progress) {
  OutlineCompiler outlines = compiler();
  const Cell first{std::max(area[0].x, 0), std::max(area[0].y, 0)};
  const Cell last{std::min(area[1].x, width_ - 1), std::min(area[1].y, height_ - 1)};
  for (int y = first.y / kSide * kSide; y <= last.y; y += kSide) {
    for (int x = first.x / kSide * kSide; x <= last.x; x += kSide) {
      const double chunk = static_cast<double>(y / kSide) * chunk_columns_ + x / kSide;
      if (progress && !progress(chunk / static_cast<double>(chunks_.size()))) return;
      compile_chunk({x, y},
                    {Cell{std::max(first.x, x), std::max(first.y, y)},
                     Cell{std::min(last.x, x + kSide - 1), std::min(last.y, y + kSide - 1)}},
                    outlines);
    }
  }
}

// The cells of an area within one chunk whose outline cannot be described by bits.
template <class Real>
typename BasicTerrain<Real>::Words BasicTerrain<Real>::details_in(std::array<Cell, 2> area,
                                                                  const OutlineCompiler& compiler) const {
  Words words{};
  const auto mark = [&](Cell from, Cell to) {
    for (Cell c{0, std::max(from.y, area[0].y)}; c.y <= std::min(to.y, area[1].y); ++c.y) {
      for (c.x = std::max(from.x, area[0].x); c.x <= std::min(to.x, area[1].x); ++c.x) {
        words[c.y % kSide] |= std::uint64_t{1} << c.x % kSide;
      }
    }
  };
  if (parts_->outlines.has_lines()) {
    compiler.for_lines([&](Cell c, const TileOutline& shape) {
      const auto& [from, to] = shape.touched;
      mark({c.x + from.x, c.y + from.y}, {c.x + to.x, c.y + to.y});
    });
  }
  for (int y = area[0].y; y <= area[1].y; ++y) {
    for (const CurveInCell& c : curves_between({area[0].x, y}, {area[1].x, y})) {
      const Cell cell = cell_at(c.cell);
      mark(cell, cell);
    }
  }
  return words;
}

template <class Real>
std::span<const typename BasicTerrain<Real>::CurveInCell> BasicTerrain<Real>::curves_between(
    Cell first, Cell last) const {
  const std::vector<CurveInCell>& all = parts_->cells_of_curves;
  const auto before = [](const CurveInCell& c, std::int32_t cell) { return c.cell < cell; };
  const auto begin = std::lower_bound(all.begin(), all.end(), index_of(first), before);
  return {begin, std::lower_bound(begin, all.end(), index_of(last) + 1, before)};
}

// Whether neither a chunk nor its neighbours, from which shapes may reach over, have a tile; and no curve is
// in the area.
// curve.
template <class Real>
bool BasicTerrain<Real>::is_bare(Cell corner, std::array<Cell, 2> area) const {
  for (int y = corner.y / kSide - 1; y <= corner.y / kSide + 1; ++y) {
    for (int x = corner.x / kSide - 1; x <= corner.x / kSide + 1; ++x) {
      if (chunk_at(x, y) != nullptr) return false;
    }
  }
  for (int y = area[0].y; y <= area[1].y; ++y) {
    if (!curves_between({area[0].x, y}, {area[1].x, y}).empty()) return false;
  }
  return true;
}

template <class Real>
void BasicTerrain<Real>::compile_chunk(Cell corner, std::array<Cell, 2> area, OutlineCompiler& compiler) {
  if (is_bare(corner, area)) return;
  const auto& old = chunks_[chunk_index(corner)];
  compiler.enter(area);
  const Words details = details_in(area, compiler);
  const std::uint64_t columns = columns_mask(area[0].x % kSide, area[1].x % kSide);
  const std::array<TerrainRow, kSide> before = old == nullptr ? std::array<TerrainRow, kSide>{} : old->rows;
  std::array<TerrainRow, kSide> rows = before;
  std::uint64_t has_pieces = 0;  // by row
  for (int y = area[0].y; y <= area[1].y; ++y) {
    TerrainRow& row = rows[y % kSide];
    if (((row.detailed & columns) | details[y % kSide]) != 0) has_pieces |= std::uint64_t{1} << y % kSide;
    row.detailed = (row.detailed & ~columns) | details[y % kSide];
    row.open = open_sides(row, {corner.x, y});
  }
  if (has_pieces == 0 && rows == before) return;

  auto chunk = writable_chunk(corner);
  chunk->rows = rows;
  constexpr std::uint64_t kBand = (std::uint64_t{1} << kBandRows) - 1;
  for (int band = 0; band < kSide / kBandRows; ++band) {
    if ((has_pieces >> band * kBandRows & kBand) != 0) compile_band(*chunk, corner, band, area, compiler);
  }
  chunks_[chunk_index(corner)] = std::move(chunk);
}

// The pieces of a band. Those in the area are compiled anew, the others stay as they were.
template <class Real>
void BasicTerrain<Real>::compile_band(Chunk& chunk, Cell corner, int band, std::array<Cell, 2> area,
                                      OutlineCompiler& compiler) {
  const std::shared_ptr<const Band> old = chunk.bands[band];
  const int top = corner.y + band * kBandRows;
  const std::array<Cell, 2> inside = {Cell{area[0].x, std::max(area[0].y, top)},
                                      Cell{area[1].x, std::min(area[1].y, top + kBandRows - 1)}};
  auto fresh = std::make_shared<Band>();
  if (old != nullptr) fresh->first = old->first;
  std::vector<Piece<Real>> made;  // of the area, row by row
  std::vector<Piece<double>> exact;
  std::vector<std::uint32_t> curves;
  const bool has_curves = !parts_->cells_of_curves.empty();
  const std::uint64_t columns = columns_mask(inside[0].x - corner.x, inside[1].x - corner.x);
  std::int64_t more = 0;  // pieces than before, up to the current cell
  for (Cell c{0, top}; c.y < top + kBandRows; ++c.y) {
    TerrainRow& row = chunk.rows[c.y - corner.y];
    const bool is_row_inside = c.y >= inside[0].y && c.y <= inside[1].y;
    if (is_row_inside) {
      for (std::uint64_t& faced : row.faced) faced &= ~columns;
    }
    for (c.x = corner.x; c.x < corner.x + kSide; ++c.x) {
      const std::uint64_t bit = std::uint64_t{1} << (c.x - corner.x);
      const auto i = static_cast<std::size_t>((c.y - top) * kSide + c.x - corner.x);
      if (is_row_inside && (columns & bit) != 0) {
        exact.clear();
        curves.clear();
        if (has_curves) {
          for (const CurveInCell& curve : curves_between(c, c)) curves.push_back(curve.piece);
        }
        if ((row.detailed & bit) != 0) compiler.compile(c, curves, exact);
        for (const Piece<double>& piece : exact) {
          made.push_back(narrow<Real>(piece));
          row.faced[static_cast<int>(piece.facing)] |= bit;
        }
        const std::size_t before = old == nullptr ? 0 : old->first[i + 1] - old->first[i];
        more += static_cast<std::int64_t>(exact.size()) - static_cast<std::int64_t>(before);
      }
      fresh->first[i + 1] = static_cast<std::uint32_t>(fresh->first[i + 1] + more);
    }
  }
  const std::array<Cell, 2> in_band = {Cell{inside[0].x - corner.x, inside[0].y - top},
                                       Cell{inside[1].x - corner.x, inside[1].y - top}};
  join_pieces(old.get(), made, in_band, kBandRows, *fresh);
  pieces_ += fresh->pieces.size() - (old == nullptr ? 0 : old->pieces.size());
  chunk.bands[band] = std::move(fresh);
}

// The full tiles of a row that are open on a side, by Facing. begin: the first cell of the row.
template <class Real>
std::array<std::uint64_t, 4> BasicTerrain<Real>::open_sides(const TerrainRow& row, Cell begin) const {
  const int column = begin.x / kSide;
  const std::uint64_t plain = row.solid & ~row.detailed;
  const std::uint64_t left = row.solid << 1 | solid_word(column - 1, begin.y) >> (kSide - 1);
  const std::uint64_t right = row.solid >> 1 | solid_word(column + 1, begin.y) << (kSide - 1);
  std::array<std::uint64_t, 4> open;
  open[static_cast<int>(Facing::up)] = plain & ~solid_word(column, begin.y - 1);
  open[static_cast<int>(Facing::down)] = plain & ~solid_word(column, begin.y + 1);
  open[static_cast<int>(Facing::left)] = plain & ~left;
  open[static_cast<int>(Facing::right)] = plain & ~right;
  return open;
}

// 0 outside of the terrain
template <class Real>
std::uint64_t BasicTerrain<Real>::solid_word(int chunk_column, int row) const {
  const Chunk* chunk = chunk_at(chunk_column, row >> 6);
  return chunk == nullptr ? 0 : chunk->rows[row & 63].solid;
}

template <class Real>
typename BasicTerrain<Real>::RowWindow BasicTerrain<Real>::Window::row(int row) {
  const Chunk* left = terrain_.chunk_at(chunk_column_, row >> 6);
  const Chunk* right = is_split_ ? terrain_.chunk_at(chunk_column_ + 1, row >> 6) : nullptr;
  if (right == nullptr) return left == nullptr ? RowWindow() : RowWindow(left->rows[row & 63], shift_);
  const TerrainRow& a = left == nullptr ? kEmptyRow : left->rows[row & 63];
  const TerrainRow& b = right->rows[row & 63];
  const auto join = [this](std::uint64_t first, std::uint64_t next) {
    return first >> shift_ | next << (kChunkSide - shift_);  // split: shift_ > 0
  };
  joined_.solid = join(a.solid, b.solid);
  joined_.detailed = join(a.detailed, b.detailed);
  for (std::size_t f = 0; f < a.open.size(); ++f) {
    joined_.open[f] = join(a.open[f], b.open[f]);
    joined_.faced[f] = join(a.faced[f], b.faced[f]);
  }
  return {joined_, 0};
}

template <class Real>
std::shared_ptr<typename BasicTerrain<Real>::Chunk> BasicTerrain<Real>::writable_chunk(Cell cell) const {
  const auto& chunk = chunks_[chunk_index(cell)];
  return chunk == nullptr ? std::make_shared<Chunk>() : std::make_shared<Chunk>(*chunk);
}

template <class Real>
std::span<const Piece<Real>> BasicTerrain<Real>::pieces_in(Cell cell) const {
  if (!contains(cell)) return {};
  const Chunk* chunk = chunks_[chunk_index(cell)].get();
  if (chunk == nullptr) return {};
  return chunk->pieces_in(cell.x % kSide, cell.y % kSide);
}

template <class Real>
TileNumber BasicTerrain<Real>::tile_at(Cell cell) const {
  if (!contains(cell)) return 0;
  const Chunk* chunk = chunks_[chunk_index(cell)].get();
  return chunk == nullptr ? 0 : chunk->tiles[index_in_chunk(cell)];
}

// The outline follows from the cells, the shapes and the curves.
template <class Real>
bool BasicTerrain<Real>::equals(const BasicTerrain& other) const {
  if (width_ != other.width_ || height_ != other.height_ || tile_ != other.tile_) return false;
  if (parts_ != other.parts_ &&
      (parts_->shapes != other.parts_->shapes || parts_->curves != other.parts_->curves))
    return false;
  static const Chunk kEmpty;
  return std::equal(chunks_.begin(), chunks_.end(), other.chunks_.begin(), [](const auto& a, const auto& b) {
    return a == b || (a ? *a : kEmpty).tiles == (b ? *b : kEmpty).tiles;
  });
}

template class BasicTerrain<double>;
template class BasicTerrain<float>;

}  // namespace talus
