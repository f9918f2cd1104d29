// What the lint has to know of each tile, worked out once for all its cells.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "collision/outline_compiler.h"
#include "lint.h"

namespace talus {

class LintTiles {
 public:
  struct Tile {
    TileRole role = TileRole::none;
    bool solid = false;      // its shape is a full tile, from all sides
    bool own_shape = false;  // not given by its flags
    bool line = false;       // its shape is a slope or the like that can be used
    bool shapeless = true;   // nothing to the physics, and no ball
    bool blank = true;       // all pixels have colour 0
    int like = -1;           // the flagged slope that it is drawn like, without being one; -1: none
    int half_of = -1;        // the flagged slope whose right half it is drawn as; -1: of none
    // Of a line: the cells that it reaches over, from its own, which is {0, 0}.
    std::array<Cell, 2> covered{};
    // And those of them, but its own, that it fills or goes through so far that a picture has to show it.
    std::vector<Cell> to_draw;
    friend bool operator==(const Tile&, const Tile&) = default;
  };

  LintTiles(const Level& level, const LintOptions& options);

  const Tile& operator[](std::size_t tile) const { return tiles_[tile]; }
  bool is_slope(std::size_t tile) const {
    return tiles_[tile].role == TileRole::up_slope || tiles_[tile].role == TileRole::down_slope;
  }
  // Neither drawn nor anything to the physics.
  bool is_empty(std::size_t tile) const {
    return tiles_[tile].shapeless && (tile == 0 || tiles_[tile].blank);
  }
  // The shape of a tile, 0..255; of kind none where it cannot be used.
  const TileShape& shape(int tile) const { return shapes_[static_cast<std::size_t>(tile)]; }
  bool has_pictures() const { return has_pictures_; }  // not all tiles are blank
  const TileOutlines& outlines() const { return outlines_; }
  const CurveOutline& curves() const { return curves_; }
  double seam() const { return options_.seam; }
  int slope_cells() const { return slope_cells_; }  // width of a flagged slope's box
  int slope_rows() const { return slope_rows_; }    // and its height
  // px: the least width and the least height of the players that are placed; none: there is no player.
  const std::optional<Vec2>& player() const { return player_; }
  // Cells in x and y: problems depend on nothing that is further from their own cell.
  int reach() const;

  // Whether they make the same problems of the same map.
  friend bool operator==(const LintTiles& a, const LintTiles& b);

  static constexpr int kLongestGap = 8;  // cells: a longer gap is taken for one that leads somewhere

 private:
  void note_masks(const Level& level);
  void note_likeness();

  LintOptions options_;
  std::array<TileShape, kTileCount> shapes_;  // those that can be used
  std::array<Tile, kTileCount> tiles_;
  std::array<std::uint64_t, kTileCount>
      masks_{};  // by pixel, row by row: whether it has another colour than 0
  bool has_pictures_ = false;
  TileOutlines outlines_;
  std::vector<Curve> sources_;
  CurveOutline curves_;
  int slope_cells_ = 2, slope_rows_ = 1;
  std::optional<Vec2> player_;
};

}  // namespace talus
