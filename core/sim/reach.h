// ReachSearch: finds where a player gets to from its start by letting the solver play. Marked cells have been
// reached: way_to() returns the keys. Other cells may still be reachable: by keys that change more often than
// every ReachOptions::hold frames, or through states that the search took for the same.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <talus/sim/solver.h>

namespace talus {

struct ReachOptions {
  int hold = 4;                         // frames, 1..60: keys are held so long before they may change
  double grain = 4;                     // px, 1..64: two places in one grain count as the same
  std::size_t most_states = 1'000'000;  // the search ends at this number; at least 1
};

// Breadth-first over the states of one player: all that is reached in n * hold frames comes before what takes
// longer. Two states count as the same if they are in the same grain of x and y, have speeds in the same
// sixths of the fastest speed, and the same feet: on the ground, able to jump, rising, key held. Only the
// first of them is followed. The order of keys decides which is first, so a search has the same result on
// every machine.
class ReachSearch {
 public:
  // scene: of the exact solver; only its ground and tuning count, as if `player` were alone. player: one of
  // the bodies at the start (must be a player, asserted).
  ReachSearch(const Scene& scene, const Body& player, ReachOptions options = {});

  // Follows so many states. Returns true if there are no more to follow, or too many are known.
  bool advance(int states);
  bool finished() const { return next_ == nodes_.size() || is_full(); }
  bool is_full() const { return nodes_.size() >= options_.most_states; }

  std::size_t known() const { return nodes_.size(); }  // number of states found
  std::size_t followed() const { return next_; }       // number of those that were followed
  std::size_t cells() const { return visits_.size(); }
  int frames() const {
    return nodes_[next_ - (next_ == nodes_.size() ? 1 : 0)].frames;
  }  // in all ways so far

  // Whether its box was in the cell.
  bool reached(Cell cell) const { return visits_.contains(index_of(cell)); }
  // Whether its feet stood in the cell.
  bool stood_at(Cell cell) const { return stood_.contains(index_of(cell)); }
  // The input of each frame that leads to the cell; empty for the start, and for cells that were not reached.
  std::vector<Input> way_to(Cell cell) const;

 private:
  struct Node {
    Vec2 position, velocity;
    Gait gait;
    bool is_clear = false;
    std::uint8_t keys = 0;     // held on the way here
    std::uint32_t parent = 0;  // the parent of the first node is the node itself
    int frames = 0;            // from the start
  };
  struct Visit {
    std::uint32_t node = 0;  // the node from which it was reached
    std::uint8_t keys = 0;   // held from there on
    std::uint8_t frames = 0;
  };

  std::int64_t index_of(Cell cell) const {  // -1: outside of the map
    const bool on_map = cell.x >= 0 && cell.y >= 0 && cell.x < width_ && cell.y < height_;
    return on_map ? std::int64_t{cell.y} * width_ + cell.x : -1;
  }
  std::uint64_t key_of(const Body& body) const;
  bool is_lost(const Body& body) const;
  void follow(std::uint32_t from, std::uint8_t keys);
  void mark(const Body& body, const Visit& visit);

  ReachOptions options_;
  std::shared_ptr<const Scene> scene_;  // with only the player
  std::unique_ptr<Solver> solver_;
  State state_;                   // the state under test
  int width_, height_;            // cells
  TileSize tile_;                 // of the cells
  double fastest_x_, fastest_y_;  // px/frame
  std::vector<Node> nodes_;       // in the order of finding
  std::size_t next_ = 0;          // the next node to follow
  std::unordered_set<std::uint64_t> seen_;
  std::unordered_map<std::int64_t, Visit> visits_;  // by cell of the map
  std::unordered_set<std::int64_t> stood_;
};

}  // namespace talus
