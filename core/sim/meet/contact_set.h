// ContactSet: contacts that bodies have at one time, and what they do to the bodies, all at once.
#pragma once

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

// What a set of contacts needs to know of a body.
struct Inertia {
  Vec2 velocity;            // px/frame
  Vec2 pull;                // px/frame^2
  double inverse_mass = 1;  // 0: nothing moves it
  double strain = 0;        // px/frame^2: the most that one contact gives it
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
  bool is_held = false;    // its bodies stay together until something else parts them
  bool is_caught = false;  // it ends all motion along its normal, also of bodies that part
  // px/frame; slower than this is rounding.
  double still() const { return b == kGround ? kStillOnGround : kStill; }
  Vec2 along() const { return {-normal.y, normal.x}; }
};

class ContactSet {
 public:
  // px/frame: how fast the other one goes away from the body along a direction; less than 0: it comes nearer.
  static double speed(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction);
  // The same for their pulls, px/frame^2.
  static double gain(const Touch& touch, std::span<const Inertia> bodies, Vec2 direction);

  // Reflects the velocities over all these contacts at once: those that approach bounce, and no contact is
  // left that is pressed together by the others. (Smith, Kaufman, Vouga, Tamstorf and Grinspun 2012,
  // "Reflections on Simultaneous Impact".) Friction is an impulse, too.
  void reflect(std::span<Inertia> bodies, std::span<Touch> touches);

  // Changes the pulls of bodies that touch and neither approach nor part: nothing is pulled into anything,
  // and friction stops what can be stopped.
  void support(std::span<Inertia> bodies, std::span<Touch> touches);

  // The work since the last call, in units of about 20 ns.
  std::int64_t take_work();

 private:
  // A number of the system: one direction of a contact.
  struct Row {
    std::size_t touch;
    Vec2 direction;
  };
  template <class Value>
  void set_up(std::span<const Inertia> bodies, std::span<const Touch> touches, Value value);
  bool solve(bool rubs);
  void bound_friction(std::span<const Inertia> bodies, std::span<const Touch> touches, std::size_t normals);

  BoundedSystem system_;
  std::vector<Row> rows_;
  std::vector<double> before_;  // the pressures of the last try
};

}  // namespace talus
