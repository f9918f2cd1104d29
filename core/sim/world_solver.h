// WorldSolver: what the solvers that move bodies in a World share: the items, the mouse, the order of bodies
// and the records. A subclass says what a body does in a step.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <talus/collision/world.h>
#include <talus/sim/solver.h>
#include "slope.h"
#include "step_limits.h"

namespace talus {

class WorldSolver : public Solver {
 public:
  void step(State& state, const Input& input, StepRecord* record) final;

 protected:
  // Groups of items in the world.
  enum Group { kSolidGroup, kSlopeGroup, kBallGroup };

  // An item of the world: what it is and, for a ball, which body.
  struct Entry {
    Obstacle what;
    Slope slope;  // for a slope
    Group group = kSolidGroup;
    bool is_slope() const { return group == kSlopeGroup; }
  };
  // Where the world has a body. Balls that pass through each other are not in the world, as nothing can meet
  // them: then `item` is null.
  struct Placed {
    int id;
    ItemId item;
    Rect box;
  };

  // slope_response: how a moving body reacts to slopes; nothing: it crosses them. It slides along everything
  // else.
  explicit WorldSolver(std::shared_ptr<const Scene> scene, World::ResponseFunction slope_response = {});

  // One step of a body that is free, or that the mouse holds. Each calls move() once.
  virtual void fall(Body& body, Placed& placed) = 0;
  virtual void drag(Body& body, Placed& placed, const Input& input) = 0;

  // The world is only a cache of the state: everything that differs is brought up to date, so that a step
  // depends only on its arguments. The budget is filled again.
  void synchronise(const State& state);
  void pull(Body& body) const;                         // gravity and drag change the velocity
  void move(Body& body, Placed& placed, Vec2 wanted);  // fills hits_, and the record
  // Returns where a search for contacts ends, and takes its work from the step's budget. Returns nothing, and
  // no hits, if the budget is used up.
  std::optional<Vec2> check(const Placed& placed, Vec2 goal, const World::GroupResponses& responses,
                            std::vector<Collision>& hits);
  void place(Placed& placed, const Rect& box);
  void limit_velocity(Body& body);
  ContactRecord* contact_of_hit(std::size_t i);  // null if the step is not recorded

  const SharedTuning& tuning() const { return scene_->tuning.shared; }
  const std::vector<SceneItem>& items() const { return scene_->items; }
  const Entry& entry(ItemId item) const { return entries_[item.index]; }
  const World::GroupResponses& moving() const { return moving_; }
  const std::vector<Placed>& placed() const { return placed_; }

  std::vector<Collision> hits_;  // of the last move

 private:
  void rebuild(const State& state);
  ItemId add(const Rect& box, const Entry& entry);
  int body_at(const State& state, Vec2 point);
  std::optional<Vec2> run(const Placed& placed, Vec2 goal);
  template <class Look>
  std::optional<Vec2> within_budget(std::vector<Collision>& hits, Look look);
  Obstacle obstacle(ItemId item) const;
  void note_test(int body, ItemId other);
  void note_contacts(int body);

  std::shared_ptr<const Scene> scene_;
  double cell_size_;  // px
  World world_;
  StepBudget budget_;  // of the step under way
  World::ResponseFunction slope_response_;
  World::GroupResponses moving_;  // how a moving body reacts to each group
  std::vector<Entry> entries_;    // by ItemId::index
  std::vector<Placed> placed_;    // in the order of State::bodies
  std::vector<ItemId> under_mouse_;
  bool bodies_block_;
  std::vector<std::uint64_t> tested_marks_;  // by ItemId::index: the last mark under which it was recorded
  std::uint64_t test_mark_ = 0;              // one for each body and step
  StepRecord* record_ = nullptr;             // of the current step; null: it is not recorded
};

}  // namespace talus
