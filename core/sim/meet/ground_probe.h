// The ground as bodies that meet see it: what a box touches, and when its path leads into the ground.
#pragma once

#include <optional>

#include "../exact_mover.h"
#include "pair_time.h"

namespace talus {

// A box comes to a piece of the ground.
struct GroundMeeting {
  double time = 0;          // frames since the step began
  Vec2 normal;              // unit, out of the ground
  Vec2 place;               // px, top-left corner of the box then
  Contact<double> contact;  // what it met
};

class GroundProbe {
 public:
  explicit GroundProbe(const Terrain& ground) : ground_(ground) {}

  // What a box touches that would go along `way`, any length but 0. It is lifted over edges of a curve's end.
  std::optional<Contact<double>> touched(Rect& box, Vec2 way, CastBudget& budget) const;

  // Moves a box, by a little more than rounding, off a crest that only its very corner is on. There it slides
  // down the slope below it, as it does anywhere else on that slope. Returns whether it was so.
  bool moves_off_crest(const Contact<double>& contact, Rect& box, CastBudget& budget) const;

  // The first time on its path, before `to`, at which a box meets the ground. along: a piece that stops
  // nothing, as it goes along it; null: none.
  std::optional<GroundMeeting> next_meeting(const MovingBox& box, double to, const Piece<double>* along,
                                            CastBudget& budget) const;

  // Puts a box that neither approaches nor leaves a straight piece of the ground exactly on it, and its
  // velocity along it, so that rounding does not lead it into the ground. stays: its pull, too.
  void align(const Contact<double>& contact, bool stays, MovingBox& box, CastBudget& budget) const;

  const Terrain& ground() const { return ground_; }

 private:
  std::optional<Contact<double>> touched_there(const Rect& box, Vec2 way, const Piece<double>* along,
                                               CastBudget& budget) const;

  const Terrain& ground_;
};

}  // namespace talus
