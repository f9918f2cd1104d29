// Terrain: the ground compiled for collision. Full tiles are bits, 64 to a word; everything else is pieces of
// one merged outline: what lies inside the ground, or where two shapes touch, is gone.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "outline_compiler.h"
#include "piece.h"
#include "shape.h"

namespace talus {

inline constexpr int kTileKinds = 256;

// What a terrain is made of. Coordinates and heights are rounded to 1/256 px, so that ends which ought to
// meet do meet. Shapes and curves must be good (see problem_of; asserted).
struct TerrainSource {
  int width = 0, height = 0;            // cells, 1 to 4096 each
  std::span<const std::uint8_t> cells;  // width * height tile numbers, row by row
  std::array<TileShape, kTileKinds> shapes;
  std::vector<Curve> curves;
};

// What of the features a terrain has; a sweep is built for these alone.
struct TerrainFeatures {
  bool pieces = false;  // slopes, profiles, one-way tiles or curves
  bool curves = false;  // any that are not straight
  friend bool operator==(const TerrainFeatures&, const TerrainFeatures&) = default;
};

// A terrain is a value: a copy shares the chunks that are equal, and takes time by the number of chunks.
template <class Real>
class BasicTerrain {
 public:
  static constexpr int kChunkSide = 64;  // cells

  struct Chunk {
    std::array<std::uint8_t, kChunkSide * kChunkSide> tiles{};
    std::array<std::uint64_t, kChunkSide> solid{};     // bit x of word y: the cell is a full solid tile
    std::array<std::uint64_t, kChunkSide> detailed{};  // the cell's outline is in `pieces`, not in `solid`
    std::array<std::uint16_t, kChunkSide> rank{};      // detailed cells in the rows above
    std::vector<std::uint32_t> first{0};  // by detailed cell: where its pieces begin; and the end
    std::vector<Piece<Real>> pieces;
  };

  BasicTerrain();  // one empty cell
  explicit BasicTerrain(const TerrainSource& source);

  int width() const { return width_; }
  int height() const { return height_; }
  bool contains(Cell c) const { return c.x >= 0 && c.y >= 0 && c.x < width_ && c.y < height_; }
  const TerrainFeatures& features() const { return features_; }

  // Gives a cell of the terrain (asserted) another tile. Only its surroundings are compiled anew.
  void set_cell(Cell cell, std::uint8_t tile);
  std::uint8_t tile_at(Cell cell) const;  // 0 outside
  const TileShape& shape_at(Cell cell) const { return parts_->shapes[tile_at(cell)]; }

  // Bit i tells of the cell (column + i, row); 0 outside of the terrain. Any column and row.
  std::uint64_t solid_bits(int column, int row) const { return bits(column, row, &Chunk::solid); }
  std::uint64_t detailed_bits(int column, int row) const { return bits(column, row, &Chunk::detailed); }

  // The outline in a detailed cell; none for other cells. A piece longer than a cell is in each that it
  // meets.
  std::span<const Piece<Real>> pieces_in(Cell cell) const;
  std::span<const CurveStretch<Real>> stretches() const { return parts_->stretches; }

  // The same cells, shapes and curves. Quick where chunks are shared.
  friend bool operator==(const BasicTerrain& a, const BasicTerrain& b) { return a.equals(b); }

 private:
  using Words = std::array<std::uint64_t, kChunkSide>;
  struct CurveInCell {
    std::int32_t cell;    // y * width + x
    std::uint32_t piece;  // into curve_pieces
  };
  // What all copies share, whatever their cells are.
  struct Parts {
    std::array<TileShape, kTileKinds> shapes;
    std::vector<Curve> curves;
    bool has_lines = false;  // any slope or the like among them
    std::vector<Piece<double>> curve_pieces;
    std::vector<CurveStretch<Real>> stretches;
    std::vector<CurveInCell> cells_of_curves;  // by cell, then by piece
  };

  std::int32_t index_of(Cell c) const { return c.y * width_ + c.x; }
  Cell cell_at(std::int32_t index) const { return {index % width_, index / width_}; }
  std::size_t chunk_index(Cell c) const {
    return static_cast<std::size_t>(c.y / kChunkSide) * chunk_columns_ + c.x / kChunkSide;
  }
  bool equals(const BasicTerrain& other) const;
  std::uint64_t bits(int column, int row, Words Chunk::*words) const;
  std::uint64_t word_at(int chunk_column, int row, Words Chunk::*words) const;

  std::vector<CurveInCell> cells_of(std::span<const Piece<double>> pieces,
                                    std::span<const CurveStretch<double>> stretches) const;
  std::span<const CurveInCell> curves_between(Cell first, Cell last) const;
  OutlineCompiler compiler() const;
  void compile(std::array<Cell, 2> area);
  void compile_chunk(Cell corner, std::array<Cell, 2> area, OutlineCompiler& compiler);
  Words details_in(std::array<Cell, 2> area, const OutlineCompiler& compiler) const;
  std::shared_ptr<Chunk> writable_chunk(Cell cell) const;
  static std::span<const Piece<Real>> pieces_of(const Chunk& chunk, Cell cell);

  int width_ = 1, height_ = 1;
  int chunk_columns_ = 1;
  TerrainFeatures features_;
  std::shared_ptr<const Parts> parts_;
  std::vector<std::shared_ptr<const Chunk>> chunks_;  // row by row; null: nothing in it
};

template <class Real>
inline std::uint64_t BasicTerrain<Real>::word_at(int chunk_column, int row, Words Chunk::*words) const {
  if (chunk_column < 0 || chunk_column >= chunk_columns_) return 0;
  const Chunk* chunk =
      chunks_[static_cast<std::size_t>(row / kChunkSide) * chunk_columns_ + chunk_column].get();
  return chunk == nullptr ? 0 : (chunk->*words)[row % kChunkSide];
}

template <class Real>
inline std::uint64_t BasicTerrain<Real>::bits(int column, int row, Words Chunk::*words) const {
  if (row < 0 || row >= height_) return 0;
  const int chunk_column = column >> 6, shift = column & 63;  // rounds down for negative columns too
  const std::uint64_t low = word_at(chunk_column, row, words) >> shift;
  return shift == 0 ? low : low | word_at(chunk_column + 1, row, words) << (64 - shift);
}

using Terrain = BasicTerrain<double>;

extern template class BasicTerrain<double>;
extern template class BasicTerrain<float>;

}  // namespace talus
