// ProveScene: a level made ready to be proved. Immutable, so that several threads may read it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <talus/level/level.h>
#include "meet_judge.h"

namespace talus {

// A kind of body that is tried.
struct ProveBody {
  BodyKind kind = BodyKind::player;
  Vec2 size = {8, 8};  // px
  Foot foot = Foot::centre;
  // px/frame, the fastest speed of a body that takes no keys. One that does not roll it over a cell is raised
  // to one that does. Bodies that take keys have their speed from the tuning.
  double speed = 0;
  friend bool operator==(const ProveBody&, const ProveBody&) = default;
};

struct ProveOptions {
  // Empty: those of the level, each kind, size and foot once, and the first kMaxBodies of them; of a level
  // without bodies: a player.
  std::vector<ProveBody> bodies = {};
  // px; higher edges are meant as walls, or as steps to jump on. 0: a quarter of a tile's height.
  double lip = 0;
};
inline constexpr std::size_t kMaxBodies = 8;

// Squares of so many cells are proved one by one. What is found in one depends on it and its surroundings
// alone.
inline constexpr int kProveBlock = 32;

class ProveScene {
 public:
  // The level must have no ground_problem() (asserted).
  ProveScene(const Level& level, const ProveOptions& options);

  // Whether what is found in a block is the same as in another scene: all that matters is the same there.
  bool is_same_in(const ProveScene& other, int block) const;

  const RawGround& ground() const { return ground_; }
  const std::vector<ProveBody>& bodies() const { return bodies_; }
  std::size_t left_out() const { return left_out_; }   // kinds of bodies of the level that are not tried
  bool assumes_body() const { return assumes_body_; }  // whether the level has none, and a player is tried
  SolverKind solver() const { return speeds_.front().scene->tuning.solver; }

  // The same level for players of several speeds, from that of the level to the slowest.
  struct Speed {
    double share;  // of the level's run_speed, and of the fastest other body
    std::shared_ptr<const Scene> scene;
    std::unique_ptr<const Judge> judge;
  };
  const std::vector<Speed>& speeds() const { return speeds_; }

  int block_columns() const { return (ground_.columns() + kProveBlock - 1) / kProveBlock; }
  int block_rows() const { return (ground_.rows() + kProveBlock - 1) / kProveBlock; }
  int blocks() const { return block_columns() * block_rows(); }
  // Whether a kind of body is tried as one that meets others: by the scene and the judge below.
  bool meets(BodyKind kind) const { return meeting_ != nullptr && !traits_of(kind).takes_keys; }
  const std::shared_ptr<const Scene>& meeting() const { return meeting_; }
  const MeetJudge& meet_judge() const { return *meet_judge_; }

  // All blocks, those near a cell first.
  std::vector<int> blocks_around(Cell cell) const;
  Cell first_cell(int block) const {
    return {block % block_columns() * kProveBlock, block / block_columns() * kProveBlock};
  }

 private:
  RawGround ground_;
  std::vector<ProveBody> bodies_;
  std::size_t left_out_ = 0;
  bool assumes_body_ = false;
  double lip_;  // px
  std::vector<Speed> speeds_;
  std::shared_ptr<const Scene> meeting_;  // null: no bodies meet
  std::unique_ptr<const MeetJudge> meet_judge_;
};

}  // namespace talus
