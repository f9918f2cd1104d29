// ReachSearch: where a player gets to from its start, found by letting the solver play. What is marked has
// been reached: way_to() tells the keys. What is not marked may still be reachable, by keys that change more
// often than each ReachOptions::hold frames, or by a way through states so alike that only one was followed.
#pragma once

#include <cstdint>
#include <memory>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <talus/sim/solver.h>

namespace talus {

struct ReachOptions {
  int hold = 4;                         // frames for which keys are held before they may change, 1..60
  double grain = 4;                     // px, 1..64: two places of one grain are alike
  std::size_t most_states = 1'000'000;  // at which the search ends, >= 1
};

// Breadth-first over states of the one player: all that is reached in n * hold frames before what takes
// longer. Two states are alike in the same grain of x and y, with speeds in the same sixth of the fastest,
// and with the same feet: on the ground, able to jump, rising, the key held. The first one found is followed,
// which the order of the keys decides; so a search has the same result on every machine.
class ReachSearch {
 public:
  // scene: of the exact solver; only its ground and its tuning count, as if `player` were alone. player: one
  // of the bodies at the start (asserted to be a player).
  ReachSearch(const Scene& scene, const Body& player, ReachOptions options = {});

  // Follows so many states; true when there are none left to follow, or too many are known.
  bool advance(int states);
  bool finished() const { return next_ == nodes_.size() || is_full(); }
  bool is_full() const { return nodes_.size() >= options_.most_states; }

  std::size_t known() const { return nodes_.size(); }  // states
  std::size_t followed() const { return next_; }       // of them
  std::size_t cells() const { return visits_.size(); }
  int frames() const {
    return nodes_[next_ - (next_ == nodes_.size() ? 1 : 0)].frames;
  }  // of all ways so far

  bool reached(Cell cell) const { return visits_.contains(index_of(cell)); }  // its box was in the cell
  bool stood_at(Cell cell) const { return stood_.contains(index_of(cell)); }  // its feet were, on the ground
  // What to hold in each frame to get to the cell; empty where it starts, and of cells that are not reached.
  std::vector<Input> way_to(Cell cell) const;

 private:
  struct Node {
    Vec2 position, velocity;
    Gait gait;
    bool is_clear = false;
    std::uint8_t keys = 0;     // held on the way here
    std::uint32_t parent = 0;  // the first node is its own
    int frames = 0;            // from the start
  };
  struct Visit {
    std::uint32_t node = 0;  // from which it was reached
    std::uint8_t keys = 0;   // held from there
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
  std::shared_ptr<const Scene> scene_;  // of the player alone
  std::unique_ptr<Solver> solver_;
  State state_;  // whose body is the one under way
  int width_, height_;
  double fastest_x_, fastest_y_;  // px/frame
  std::vector<Node> nodes_;       // in the order in which they were found
  std::size_t next_ = 0;          // to be followed
  std::unordered_set<std::uint64_t> seen_;
  std::unordered_map<std::int64_t, Visit> visits_;  // by cell of the map
  std::unordered_set<std::int64_t> stood_;
};

}  // namespace talus
