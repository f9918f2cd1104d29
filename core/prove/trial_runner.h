// TrialRunner: tries how bodies move over a block of a level, with the solver itself.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <memory>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "prove_scene.h"

namespace talus {

// What was tried.
struct ProveCounts {
  std::int64_t places = 0;  // where a body can stand
  std::int64_t alike =
      0;  // of those: whose surroundings are those of another one in its block, which was tried
  std::int64_t trials = 0;
  std::int64_t steps = 0;  // of the solver
  void add(const ProveCounts& other);
};

// What was found in one block: of each kind of finding, body and direction the first one in a cell.
struct BlockProof {
  ProveCounts counts;
  std::vector<Finding> findings;
};

// Keeps solvers, so each thread needs its own.
class TrialRunner {
 public:
  explicit TrialRunner(const ProveScene& scene);  // refers to it
  BlockProof prove(int block);

  // Plays a trial until something is found, or nothing more can be.
  std::optional<Finding> play(const Trial& trial);

 private:
  // A place in a cell from which a body is tried, and what is tried there.
  struct Start {
    double share = 0;    // of the cell's width at which the middle of the body is,
    double px = 0;       // and so far to the right of that
    bool walks = false;  // to both sides, at the full speed
    bool walks_slower = false;
    bool from_rest = false;  // walks that begin at rest
    bool jumps = false;
    bool jumps_onto_sides = false;  // straight up, and then to a side
    bool drops = false;
    int slowest = 0;  // -1 or 1: the side to which it goes at the slowest speed
  };
  static const std::array<Start, 5> kStarts;
  // A place where a body stands on the ground, or would if that were not too steep, in the cell of the
  // ground.
  struct Place {
    Cell cell;
    std::size_t body;  // index
    const Start& start;
    Rect box;  // px
  };
  // A top of the ground.
  struct Top {
    double y;  // px
    bool is_steep;
    friend auto operator<=>(const Top&, const Top&) = default;
  };
  // The keys of a jump, as those of a Trial.
  struct Jump {
    int direction = 0;
    int run_from = 1;
    int held = 0;  // frames
  };
  // By which columns and rows trials may go away from their cell.
  struct Reach {
    int columns, up, down;
  };

  void try_cell(Cell cell, std::size_t body);
  void try_top(Place place, double x, Top top);
  void try_place(const Place& place);
  bool stand(Body& body);
  void try_meeting(Place place, double x, Top top);
  void walk_from(const Place& place, const Trial& standing);
  void walk(const Place& place, Trial trial, std::size_t speed, int direction, bool at_rest);
  double way_past_joint(const Start& start, int direction) const;
  void jump(const Place& place, Trial trial, Jump jump);
  void drop(const Place& place, const Body* standing);
  void run(Trial trial, const Place& place, std::size_t speed);
  std::optional<Finding> play(const Trial& trial, std::size_t speed, const Place* place);
  std::optional<Finding> play_meeting(const Trial& trial, const Place* place);
  void begin(const Trial& trial);
  bool is_beyond(const Reach& reach, const Place& place) const;
  Finding finding_of(const Trial& trial, int frame, const Verdict& verdict) const;
  bool is_wedged(const State& state, std::size_t speed);
  std::vector<Top> tops_at(Cell cell, double x) const;
  std::string surroundings_of(Cell cell, std::size_t body) const;
  Reach reach_of(const ProveBody& body) const;
  double held(double px) const;  // rounded as the solver's numbers are

  const ProveScene& scene_;
  const bool is_single_;                          // whether the solver takes single precision
  std::vector<std::unique_ptr<Solver>> solvers_;  // by speed
  std::unique_ptr<Solver> meeting_;               // of bodies that meet; null: there are none
  State state_;                                   // working storage
  StepRecord record_;
  BlockProof proof_;  // of the block under trial
  std::map<std::tuple<int, int, FindingKind, std::size_t, int>, std::size_t> found_;  // indices of findings
  // Of cells that were tried in this block, and whether a body can stand there.
  std::unordered_map<std::string, bool> surroundings_;
};

}  // namespace talus
