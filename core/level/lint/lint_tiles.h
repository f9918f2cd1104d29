// What the lint needs to know of each tile, computed once for all its cells.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "../ground_names.h"
#include "collision/outline_compiler.h"
#include "lint.h"

namespace talus {

class LintTiles {
 public:
  struct Tile {
    TileRole role = TileRole::none;
    bool solid = false;      // its shape is a full tile, from all sides
    bool own_shape = false;  // not the shape of its flags
    bool line = false;       // its shape is a valid slope or profile
    bool shapeless = true;   // neither ground nor a ball
    bool blank = true;       // nothing is seen of it
    int like =
        -1;  // the flagged slope that it is drawn like, without being a slope; -1: it looks like no slope
    int half_of = -1;  // the flagged slope whose right half it is drawn as; -1: it is no right half
    // For a line: the first and the last cell that it reaches over, relative to its own cell.
    std::array<Cell, 2> covered{};
    // The cells of `covered`, except its own, that the ground fills so far that a picture has to show it.
    std::vector<Cell> to_draw;
    friend bool operator==(const Tile&, const Tile&) = default;
  };

  // names: of the tiles.
  LintTiles(const Level& level, const LintOptions& options, GroundNames names = {});

  const Tile& operator[](std::size_t tile) const { return tiles_[tile]; }
  bool is_slope(std::size_t tile) const {
    return tiles_[tile].role == TileRole::up_slope || tiles_[tile].role == TileRole::down_slope;
  }
  // Whether a tile is blank and no ground.
  bool is_empty(std::size_t tile) const {
    return tiles_[tile].shapeless && (tile == 0 || tiles_[tile].blank);
  }
  std::size_t count() const { return tiles_.size(); }                   // of the level's tiles
  std::string text_of(int tile) const { return names_.text_of(tile); }  // "tile 12"
  const GroundNames& names() const { return names_; }
  // The shape of a tile. Its kind is none if it is invalid.
  const TileShape& shape(int tile) const { return shapes_[static_cast<std::size_t>(tile)]; }
  bool has_pictures() const { return has_pictures_; }  // whether a tile has a drawn pixel
  const TileOutlines& outlines() const { return outlines_; }
  const CurveOutline& curves() const { return curves_; }
  double seam() const { return options_.seam; }
  int slope_cells() const { return slope_cells_; }  // height of a flagged slope's box
  int slope_rows() const { return slope_rows_; }    // and its height
  // The least width and the least height of the level's players, px; empty if there is no player.
  const std::optional<Vec2>& player() const { return player_; }
  // The distance in x and y in cells within which other cells matter to the problems of a cell.
  int reach() const;

  // Whether both find the same problems on the same map.
  friend bool operator==(const LintTiles& a, const LintTiles& b);

  static constexpr int kLongestGap = 8;  // cells; a longer gap counts as one that leads somewhere

 private:
  void note_masks(const Level& level);
  void note_likeness();

  LintOptions options_;
  GroundNames names_;
  TileSize tile_;                     // of the map
  std::vector<TileShape> shapes_;     // by tile; only valid ones
  std::vector<Tile> tiles_;           // by tile
  std::vector<std::uint64_t> masks_;  // by tile: see drawn_pixels()
  bool has_pictures_ = false;
  TileOutlines outlines_;
  std::vector<Curve> sources_;
  CurveOutline curves_;
  int slope_cells_ = 2, slope_rows_ = 1;
  std::optional<Vec2> player_;
};

}  // namespace talus
