// Terrain: the ground compiled for collision. Full tiles are bits, 64 to a word. Everything else is pieces of
// one merged outline, without what lies inside of the ground or where two shapes touch.
//
// The pieces of the outline are not linked to chains. Each cell keeps its pieces, and their ends say how the
// outline goes on: it turns away from the open side (convex), no floor goes on (last), or the end is in
// another cell, whose copy of the piece knows (far). So a cell can be compiled from its surroundings alone.
// Free curves are merged with tiles, and with one another, only where their ends meet: a curve that crosses a
// tile stays whole, also inside of the ground.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <talus/collision/piece.h>
#include <talus/collision/shape.h>

namespace talus {

class OutlineCompiler;  // both internal
class TileOutlines;

// The parts of a terrain. Coordinates and heights are rounded to 1/256 px, so that ends which ought to meet
// do meet. The size must be within the limits, each cell must hold the number of a shape, and shapes and
// curves must be usable (see problem_of); asserted.
struct TerrainSource {
  int width = 0;                      // cells; see is_terrain_size
  int height = 0;                     // cells
  TileSize tile = {};                 // of each cell
  std::span<const TileNumber> cells;  // width * height tile numbers, row by row, each one of `shapes`
  // By tile number, 1 to kMaxTiles of them; kind none: air. At first 256 of these.
  std::vector<TileShape> shapes = std::vector<TileShape>(256);
  std::vector<Curve> curves;  // free of the grid, by their numbers
  // Called now and then while the terrain is made, with the share that is done, 0..1. If it returns false,
  // the work ends, and the result is not valid. Empty: the terrain is made without calls.
  std::function<bool(double)> progress = {};
};

// @cond INTERNAL
// A row of a terrain's chunk: bit x of a word is the cell in column x.
struct TerrainRow {
  std::uint64_t solid = 0;     // a full solid tile
  std::uint64_t detailed = 0;  // its outline is in pieces
  // By Facing: a full tile that is not detailed and has no full tile on that side.
  std::array<std::uint64_t, 4> open{};
  // By Facing: a detailed cell with a piece that faces so.
  std::array<std::uint64_t, 4> faced{};
  friend bool operator==(const TerrainRow&, const TerrainRow&) = default;
};
inline constexpr TerrainRow kEmptyRow;
// @endcond

// A terrain is a value: a copy shares the chunks that are equal, and takes time by the number of chunks. The
// const functions may be called by several threads at once. Real: double, or float.
template <class Real>
class BasicTerrain {
 public:
  // @cond INTERNAL
  static constexpr int kChunkSide = 64;  // cells
  static constexpr int kBandRows = 8;    // of a chunk

  // The pieces of some rows of a chunk. Copies of a chunk that differ elsewhere share them.
  struct Band {
    std::array<std::uint32_t, kBandRows * kChunkSide + 1> first{};  // by cell, row by row; and the end
    std::vector<Piece<Real>> pieces;
  };
  struct Chunk {
    std::array<TileNumber, kChunkSide * kChunkSide> tiles{};
    std::array<TerrainRow, kChunkSide> rows{};
    std::array<std::shared_ptr<const Band>, kChunkSide / kBandRows> bands;  // null: no pieces

    // x, y: inside of the chunk.
    std::span<const Piece<Real>> pieces_in(int x, int y) const {
      const Band* band = bands[y / kBandRows].get();
      if (band == nullptr) return {};
      const auto first = band->first.begin() + (y % kBandRows * kChunkSide + x);
      return {band->pieces.data() + first[0], band->pieces.data() + first[1]};
    }
  };

  // @endcond

  BasicTerrain();  // one empty cell
  // Compiles the whole ground, which takes time by its cells and curves. Data that the source refers to is
  // not needed afterwards. If its progress stops the work, the terrain may only be destroyed.
  explicit BasicTerrain(const TerrainSource& source);

  int width() const { return width_; }                                // cells
  int height() const { return height_; }                              // cells
  TileSize tile_size() const { return tile_; }                        // of all its tiles
  Real x_of(int column) const { return Real(column) * tile_width_; }  // px, of its left side
  Real y_of(int row) const { return Real(row) * tile_height_; }       // px, of its top
  Real columns_per_px() const { return columns_per_px_; }  // rounded: a product may be off by an ulp
  Real rows_per_px() const { return rows_per_px_; }        // the same
  // Whether a cell is one of the terrain's.
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }
  // Whether its outline has pieces: those of slopes, profiles, one-way tiles or curves.
  bool has_pieces() const { return pieces_ != 0; }
  // Whether one of its shapes, used or not, or one of its curves stops what comes from one side alone.
  bool has_one_way() const { return one_way_; }
  // Whether one of its shapes, used or not, or one of its curves is a conveyor.
  bool has_conveyors() const { return conveyors_; }

  // Gives a cell of the terrain another tile, by the number of one of its shapes (both asserted). Only its
  // surroundings are compiled anew.
  void set_cell(Cell cell, TileNumber tile);
  TileNumber tile_at(Cell cell) const;  // 0 outside
  // The shape of the tile there; outside of the terrain, that of tile 0. Valid as long as the terrain or a
  // copy of it lives.
  const TileShape& shape_at(Cell cell) const;
  // px/frame, as TileShape::conveyor: that of the tile or the curve with this Piece::origin.
  double conveyor_of(std::int32_t origin) const;
  // @cond INTERNAL
  const TileOutlines& outlines() const;  // by tile number

  // The content of a few columns of a row. Bit i is the cell in the window's column + i; it is 0 outside of
  // the terrain.
  class RowWindow {
   public:
    RowWindow() = default;
    RowWindow(const TerrainRow& row, int shift) : row_(&row), shift_(shift) {}
    std::uint64_t solid() const { return row_->solid >> shift_; }
    std::uint64_t detailed() const { return row_->detailed >> shift_; }
    std::uint64_t open(Facing f) const { return row_->open[static_cast<int>(f)] >> shift_; }
    std::uint64_t faced(Facing f) const { return row_->faced[static_cast<int>(f)] >> shift_; }

   private:
    const TerrainRow* row_ = &kEmptyRow;
    int shift_ = 0;
  };

  // Reads a few columns, row by row. Bits beyond `count` have no meaning.
  class Window {
   public:
    // column: any; count: 1..64. The terrain must not change meanwhile.
    Window(const BasicTerrain& terrain, int column, int count)
        : terrain_(terrain),
          chunk_column_(column >> 6),  // rounds down for negative columns too
          shift_(column & 63),
          is_split_(shift_ + count > kChunkSide) {}
    // Valid until the next call.
    RowWindow row(int row);
    std::span<const Piece<Real>> pieces(int bit, int row) const {
      return terrain_.pieces_in({chunk_column_ * kChunkSide + shift_ + bit, row});
    }

   private:
    const BasicTerrain& terrain_;
    const int chunk_column_, shift_;
    const bool is_split_;
    TerrainRow joined_;  // of two chunks
  };

  // The same for a window within one chunk, the usual case: quicker.
  class OneChunk {
   public:
    static bool covers(int column, int count, int first_row, int last_row) {
      return (column & 63) + count <= kChunkSide && first_row >> 6 == last_row >> 6 && column >= 0 &&
             first_row >= 0;
    }
    // The window's column, and any of its rows; must be in the terrain.
    OneChunk(const BasicTerrain& terrain, int column, int row)
        : shift_(column & 63), chunk_(terrain.chunk_at(column >> 6, row >> 6)) {}
    explicit operator bool() const { return chunk_ != nullptr; }  // false: nothing in it
    RowWindow row(int row) const { return {chunk_->rows[row & 63], shift_}; }
    std::span<const Piece<Real>> pieces(int bit, int row) const {
      return chunk_->pieces_in(shift_ + bit, row & 63);
    }

   private:
    int shift_;
    const Chunk* chunk_;
  };

  // @endcond

  // Whether the cell is a full solid tile; false outside.
  bool is_solid(Cell c) const { return (Window(*this, c.x, 1).row(c.y).solid() & 1) != 0; }
  // Whether the outline in the cell is in pieces, as that of a slope or a curve is; false outside.
  bool is_detailed(Cell c) const { return (Window(*this, c.x, 1).row(c.y).detailed() & 1) != 0; }

  // The outline in a detailed cell; empty for other cells. A piece longer than a cell is in each cell that it
  // meets. Valid until the terrain changes.
  std::span<const Piece<Real>> pieces_in(Cell cell) const;
  // Of all curves; Piece::stretch counts them from 1. Valid as long as the terrain or a copy of it lives.
  std::span<const CurveStretch<Real>> stretches() const { return stretches_; }

  // Whether cells, shapes and curves are the same. Quick if chunks are shared.
  friend bool operator==(const BasicTerrain& a, const BasicTerrain& b) { return a.equals(b); }

 private:
  using Words = std::array<std::uint64_t, kChunkSide>;  // by row of a chunk
  struct CurveInCell {
    std::int32_t cell;    // y * width + x
    std::uint32_t piece;  // into curve_pieces
  };
  struct Parts;  // what all copies share, whatever their cells are

  std::int32_t index_of(Cell c) const { return c.y * width_ + c.x; }
  Cell cell_at(std::int32_t index) const { return {index % width_, index / width_}; }
  std::size_t chunk_index(Cell c) const {
    return static_cast<std::size_t>(c.y / kChunkSide) * chunk_columns_ + c.x / kChunkSide;
  }
  bool equals(const BasicTerrain& other) const;
  // Null: outside of the terrain, or an empty chunk.
  const Chunk* chunk_at(int chunk_column, int chunk_row) const {
    if (chunk_column < 0 || chunk_column >= chunk_columns_ || chunk_row < 0) return nullptr;
    if (chunk_row * kChunkSide >= height_) return nullptr;
    return chunks_[static_cast<std::size_t>(chunk_row) * chunk_columns_ + chunk_column].get();
  }

  std::vector<CurveInCell> cells_of(std::span<const Piece<double>> pieces,
                                    std::span<const CurveStretch<double>> stretches) const;
  std::span<const CurveInCell> curves_between(Cell first, Cell last) const;
  OutlineCompiler compiler() const;
  void compile(std::array<Cell, 2> area, const std::function<bool(double)>& progress = {});
  bool is_bare(Cell corner, std::array<Cell, 2> area) const;
  void compile_chunk(Cell corner, std::array<Cell, 2> area, OutlineCompiler& compiler);
  Words details_in(std::array<Cell, 2> area, const OutlineCompiler& compiler) const;
  void compile_band(Chunk& chunk, Cell corner, int band, std::array<Cell, 2> area, OutlineCompiler& compiler);
  std::array<std::uint64_t, 4> open_sides(const TerrainRow& row, Cell begin) const;
  std::uint64_t solid_word(int chunk_column, int row) const;
  std::shared_ptr<Chunk> writable_chunk(Cell cell) const;

  int width_ = 1, height_ = 1;
  TileSize tile_;
  Real tile_width_ = 0, tile_height_ = 0;  // px, so that a cast converts no integers
  Real columns_per_px_ = 0, rows_per_px_ = 0;
  int chunk_columns_ = 1;
  std::shared_ptr<const Parts> parts_;
  std::span<const CurveStretch<Real>> stretches_;     // of the parts
  std::vector<std::shared_ptr<const Chunk>> chunks_;  // row by row; null: nothing in it
  std::size_t pieces_ = 0;                            // in all of them
  bool one_way_ = false;
  bool conveyors_ = false;
};

using Terrain = BasicTerrain<double>;  // in double precision

extern template class BasicTerrain<double>;
extern template class BasicTerrain<float>;

}  // namespace talus
