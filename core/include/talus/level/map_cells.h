// What the cells of a layer hold: the number of a tile, and how it is turned.
#pragma once

#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <talus/collision/shape.h>

namespace talus {

// How a tile is turned in its cell: which of Tiled's three flips it has, as a sum of their bits. The diagonal
// flip, which lets x and y change places, comes first.
enum class TileTurn : std::uint8_t { none = 0, diagonal = 1, up_down = 2, left_right = 4 };
inline constexpr int kTileTurns = 8;  // different turns, 0 to 7

// Whether a turn has this one of the three flips.
constexpr bool has_flip(TileTurn turn, TileTurn flip) {
  return (static_cast<int>(turn) & static_cast<int>(flip)) != 0;
}
// The turn with these flips.
constexpr TileTurn turn_of(bool diagonal, bool left_right, bool up_down) {
  return static_cast<TileTurn>((diagonal ? 1 : 0) | (up_down ? 2 : 0) | (left_right ? 4 : 0));
}
// The turn with which a tile looks as one with `turn` does after another turn, `next`.
constexpr TileTurn after_turn(TileTurn turn, TileTurn next) {
  const bool x = has_flip(turn, TileTurn::left_right), y = has_flip(turn, TileTurn::up_down);
  const bool swaps = has_flip(next, TileTurn::diagonal);
  return turn_of(has_flip(turn, TileTurn::diagonal) != swaps,
                 (swaps ? y : x) != has_flip(next, TileTurn::left_right),
                 (swaps ? x : y) != has_flip(next, TileTurn::up_down));
}
// A quarter turn clockwise.
inline constexpr TileTurn kTurnRight = turn_of(true, true, false);
// A quarter turn the other way.
inline constexpr TileTurn kTurnLeft = turn_of(true, false, true);

// A tile in a cell. A tile number stands for the tile as it is drawn.
struct MapCell {
  TileNumber tile = 0;             // of the level
  TileTurn turn = TileTurn::none;  // how it is turned
  constexpr MapCell() = default;
  // number: of the tile; turned: as `turn`.
  constexpr MapCell(TileNumber number, TileTurn turned = TileTurn::none) : tile(number), turn(turned) {}
  friend constexpr auto operator<=>(const MapCell&, const MapCell&) = default;
};

// The cells of a layer, row by row. Turns take no memory as long as no cell is turned.
class MapCells {
 public:
  MapCells() = default;
  explicit MapCells(std::size_t count) : tiles_(count) {}                        // empty cells
  MapCells(std::vector<TileNumber> tiles) : tiles_(std::move(tiles)) {}          // none of them turned
  MapCells(std::vector<TileNumber> tiles, const std::vector<TileTurn>& turns) {  // as many of both (asserted)
    assert(tiles.size() == turns.size());
    tiles_ = std::move(tiles);
    for (std::size_t i = 0; i < turns.size(); ++i) set_turn(i, turns[i]);
  }

  std::size_t size() const { return tiles_.size(); }               // how many there are
  bool has_turned() const { return turned_ > 0; }                  // whether a cell is turned
  const std::vector<TileNumber>& tiles() const { return tiles_; }  // by cell
  std::vector<TileNumber>& tiles() { return tiles_; }              // keep its size; turns stay
  const std::vector<TileTurn>& turns() const { return turns_; }    // by cell; empty if none is turned
  TileTurn turn_of(std::size_t i) const {                          // of a cell
    return turns_.empty() ? TileTurn::none : turns_[i];
  }
  MapCell operator[](std::size_t i) const { return {tiles_[i], turn_of(i)}; }  // a cell
  // Puts something into a cell.
  void set(std::size_t i, MapCell cell) {
    tiles_[i] = cell.tile;
    set_turn(i, cell.turn);
  }
  friend bool operator==(const MapCells&, const MapCells&) = default;

 private:
  void set_turn(std::size_t i, TileTurn turn) {
    const TileTurn before = turn_of(i);
    if (before == turn) return;
    if (turns_.empty()) turns_.resize(tiles_.size());
    turns_[i] = turn;
    if (before == TileTurn::none) ++turned_;
    if (turn == TileTurn::none && --turned_ == 0) turns_ = {};
  }
  std::vector<TileNumber> tiles_;
  std::vector<TileTurn> turns_;
  std::size_t turned_ = 0;  // cells that are
};

}  // namespace talus
