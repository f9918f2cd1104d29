// The solver of the article "Slopes in AABB collision systems" (A. Listopadov, 2026), to the last bit,
// defects included: blocks snag at seams, the slope's floor is rounded, and only the body's centre is on it.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "../collision/world.h"
#include "solver.h"

namespace talus {

class ArticleSolver final : public Solver {
 public:
  explicit ArticleSolver(std::shared_ptr<const Scene> scene);
  void step(State& state, const Input& input, StepRecord* record) override;

 private:
  // An item of the world: what it is, and, of a ball, which body.
  struct Entry {
    Obstacle what;
    double direction = 0;  // of a slope: +1 rises to the right, -1 to the left
    bool is_slope() const { return direction != 0; }
  };
  // Where the world believes that a body is. Balls that pass through each other are no items of the world,
  // and then `item` is null: nobody can meet them.
  struct Placed {
    int id;
    ItemId item;
    Rect box;
  };

  void rebuild(const State& state);
  void synchronise(const State& state);
  void take_mouse(State& state, const Input& input);
  void fall(Body& body, Placed& placed);
  void drag(Body& body, Placed& placed, const Input& input);
  int body_at(const State& state, Vec2 point);
  void move(Body& body, Placed& placed, Vec2 wanted);
  Vec2 run(const Body& body, const Placed& placed, Vec2 goal);
  void place(Placed& placed, const Rect& box);
  std::optional<SlopeProbe> probe_slope(const Body& body, const Placed& placed, double speed);
  std::optional<SlopeProbe> settle_on_slope(Body& body, Placed& placed, double speed, ContactRecord* contact);

  Obstacle obstacle(ItemId item) const;
  void note_test(int body, ItemId other);
  void note_contacts(int body);
  ContactRecord* contact_of_hit(std::size_t i);  // null when nobody records

  std::shared_ptr<const Scene> scene_;
  World world_;
  std::vector<Entry> entries_;  // by ItemId::index
  std::vector<Placed> placed_;  // as State::bodies
  std::vector<Collision> hits_;
  std::vector<Collision> slope_hits_;
  std::vector<ItemId> under_mouse_;
  bool balls_block_;
  std::vector<std::uint64_t> tested_marks_;  // by ItemId::index: the last mark under which it was noted
  std::uint64_t test_mark_ = 0;              // one for each body and step
  StepRecord* record_ = nullptr;             // of the step under way; null when nobody wants it
};

}  // namespace talus
