// Track: what a circle rolls or slides along in a part of a step, so that it neither leaves what is bent nor
// falls behind on it. A box slides along a curve with one of its corners, a circle without a radius.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "round_ground.h"

namespace talus {

// px: only what is further past an end has left it. Putting a body on its track may move it by rounding.
inline constexpr double kPast = 1e-9;

// Paths are parabolas. One that has the bend of the track stays near it; at its end the circle is put back on
// it, and gets the speed that its way down or up gives it.
struct Track {
  bool is_on = false;
  bool is_ground = true;          // else a body that stands still
  std::vector<GroundSide> sides;  // of the ground, which touch it and stop nothing; the first are followed
  std::size_t followed = 0;       // of those: one, or all that meet in the end that it goes round
  std::uint32_t other = 0;        // index of the body
  std::uint32_t version = 0;      // of its path
  Form form;                      // of the body
  double gap = 0;                 // px, which it keeps
  std::optional<Vec2> centre;     // px, of an end, a corner, a circle or an arc that it goes round
  bool on_end = false;            // it goes round a corner, or the end of a side
  bool is_alone = false;          // nothing else touches the circle
  double conveyor = 0;            // px/frame, as Touch::conveyor
  double rolls = 1;               // share of a pull along the track that moves it; the rest turns it
  Vec2 corner;                    // px, of a box, from its top-left corner: what slides along a curve
  // Of a box that is about to leave a curve, which stops it no longer: rounding would. Null: none.
  const Piece<double>* leaves = nullptr;
  Vec2 pull;         // px/frame^2, without the track
  double drive = 0;  // px/frame^2, along the track, beside that share: friction, and others

  // Radians: a path that turns no more is near to its track.
  static double most_turn(bool is_round) { return is_round ? 1.0 / 8 : 1.0 / 32; }
  // frames, for a path that turns by so many radians a frame.
  static double longest(double turn, bool is_round) { return most_turn(is_round) / std::abs(turn); }
  // Called when it is known what a circle follows.
  void begin(const Form& circle) { centre = centre_for(circle); }
  // Takes a circle on it to a time, and returns the direction of the track there.
  Vec2 take(MovingBox& circle, double time) const;
  // The time before `most` at which a circle comes to another part of it, or leaves it; `most` if it does
  // not.
  double end(const MovingBox& circle, double most) const;

 private:
  Nearness near(const Form& circle) const;
  std::optional<Vec2> centre_for(const Form& circle) const;
  Vec2 way_along(const MovingBox& circle, double time, const Nearness& there) const;
  // Whether a circle touches the same part of it still: not one behind an end.
  bool goes_on(const Form& circle) const;
  static bool is_near_to(Vec2 begin, Vec2 now, bool is_round);
  void go_down(MovingBox& circle, Vec2 onward, double missing) const;
};

}  // namespace talus
