// ContactSet: contacts that bodies have at one time, and what they do to the bodies, all at once.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <talus/collision/geometry.h>
#include "bounded_system.h"

namespace talus {

// px/frame, and px/frame^2; slower than this is rounding.
inline constexpr double kStill = 1e-11;
// The same for a body and the ground, which it may slide along for long.
inline constexpr double kStillOnGround = 1e-12;
// Unit, along what has a unit normal: to the right on a floor.
inline Vec2 along(Vec2 normal) { return {-normal.y, normal.x}; }
inline bool is_still(Vec2 v) { return std::abs(v.x) <= kStill && std::abs(v.y) <= kStill; }

// What a set of contacts needs to know of a body.
struct Inertia {
  Vec2 velocity;            // px/frame
  Vec2 pull;                // px/frame^2
  double inverse_mass = 1;  // 0: nothing moves it
  double spin = 0;          // px/frame, of a circle's rim, clockwise
  double spin_pull = 0;     // px/frame^2
  // px/frame that an impulse of 1 along the rim changes its spin by; 0: nothing turns it
  double inverse_spin = 0;
  double strain = 0;  // px/frame^2: the most that one contact gives it
};

// Two bodies that touch, or a body and the ground.
struct Touch {
  static constexpr int kGround = -1;
  int a = 0;               // index of a body
  int b = kGround;         // index of the other one
  Vec2 normal;             // unit, out of the other one
  double bounce = 0;       // share of the approaching speed that is left, reversed
  double friction = 0;     // Coulomb's number: friction is at most so many times as strong as the pressure
  double impulse = 0;      // mass times px/frame that it has given along its normal so far
  double pressure = 0;     // mass times px/frame^2 along its normal
  double parts = 0;        // px/frame^2: the gap that straight ways would open, as the other one is bent
  bool is_held = false;    // its bodies stay together until something else parts them
  bool is_caught = false;  // it ends all motion along its normal, also of bodies that part
  double room = 0;         // px/frame that they may approach with, for stop()
  double rubbing = 0;      // mass times px/frame^2, of friction
  // px/frame: what parts or slides more slowly is held as if it did not. Circles that roll on one another
  // part slowly, as their contacts go round them.
  double slow = 0;
  double conveyor = 0;  // px/frame, of the other one's surface along the contact
  // px/frame; slower than this is rounding.
  double still() const { return b == kGround ? kStillOnGround : kStill; }
  Vec2 along() const { return talus::along(normal); }
};

class ContactSet {
 public:
  // px/frame: how fast the other one goes away from the body along a direction; less than 0: it comes nearer.
  static double speed(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction);
  // px/frame^2: how fast the gap of two that touch opens by their pulls.
  static double gain(const Touch& touch, std::span<const Inertia> bodies);
  // px/frame: how fast the surface of the body slides on that of the other one, along the contact.
  static double slip(const Touch& touch, std::span<const Inertia> bodies);

  // Reflects the velocities over all these contacts at once: those that approach bounce, and no contact is
  // left that is pressed together by the others. (Smith, Kaufman, Vouga, Tamstorf and Grinspun 2012,
  // "Reflections on Simultaneous Impact".) Friction is an impulse, too.
  void reflect(std::span<Inertia> bodies, std::span<Touch> touches);

  // Changes the pulls of bodies that touch and neither approach nor part: nothing is pulled into anything,
  // and friction stops what can be stopped.
  void support(std::span<Inertia> bodies, std::span<Touch> touches);

  // Ends all approaches that are faster than their room, without any bounce; nearly, but at a cost that grows
  // with the contacts alone. `pressure` and `rubbing` of each get its impulses, mass times px/frame; a call
  // goes on from those of the last one. still: px/frame, it ends when a turn changes nothing by more.
  void stop(std::span<Inertia> bodies, std::span<Touch> touches, double still, int most_turns);

  // Ends the slow motion of contacts that hold after support().
  // Returns whether one that slid has ended, so that its friction is another now.
  bool settle(std::span<Inertia> bodies, std::span<const Touch> touches);

  // The work since the last call, in units of about 20 ns.
  std::int64_t take_work();

 private:
  // A number of the system: one direction of a contact.
  struct Row {
    std::size_t touch;
    Vec2 direction;
    bool rubs = false;  // friction: along the contact
  };
  // A contact in stop(). x: across it; y: along it.
  struct Stop {
    std::size_t touch = 0;
    int a = 0, b = 0;  // as in Touch
    Vec2 normal;
    double room = 0, friction = 0, conveyor = 0;
    double yields = 0, rim_yields = 0;  // px/frame that an impulse of 1 changes it by, across and along
    Vec2 given;                         // impulses so far
    Vec2 tried;                         // the same, as this turn began
    Vec2 last;                          // the same, as the last turn ended
  };
  void take_stops(std::span<const Inertia> bodies, std::span<const Touch> touches);
  static void push_stop(std::span<Inertia> bodies, Stop& stop, Vec2 change);
  static void stop_one(std::span<Inertia> bodies, Stop& stop);
  template <class Value>
  void set_up(std::span<const Inertia> bodies, std::span<const Touch> touches, Value value);
  bool solve(bool rubs);
  void set_up_speeds(std::span<const Inertia> bodies, std::span<const Touch> touches);
  static void push(std::span<Inertia> bodies, const Touch& touch, const Row& row, double impulse);
  void push_all(std::span<Inertia> bodies, std::span<const Touch> touches);
  void add_friction(std::span<const Touch> touches);
  void rub(std::span<Inertia> bodies, std::span<Touch> touches, std::span<const double> given);
  void bound_friction(std::span<const Inertia> bodies, std::span<const Touch> touches, std::size_t normals,
                      bool is_impact);
  void hurry(std::span<const double> change, std::span<const double> last_change, std::vector<double>& last);
  void solve_with_friction(std::span<const Inertia> bodies, std::span<const Touch> touches,
                           std::size_t normals, bool is_impact);

  BoundedSystem system_;
  std::vector<Row> rows_;
  std::vector<Stop> stops_;
  std::vector<double> before_;  // the pressures of the last try
  std::int64_t work_ = 0;       // as of take_work(), beside that of the system
};

}  // namespace talus
