// State: everything that changes from frame to frame, and the input that changes it.
#pragma once

#include <cstdint>
#include <vector>

#include <talus/sim/scene.h>

namespace talus {

// What a player remembers from step to step. Of a ball only `grounded` is used.
struct Gait {
  bool grounded = false;   // stood on level ground after the last step
  bool jumping = false;    // rises from a jump that letting go of the key would cut
  bool jump_held = false;  // the key was down in the last step
  int coyote = 0;          // frames left in which it may jump though it stands on nothing
  friend bool operator==(const Gait&, const Gait&) = default;
};

// A body that moves.
struct Body {
  int id = 0;         // from 1, in scene order at the start; never reused
  BodyOrigin origin;  // where it started
  Rect box;           // px
  Vec2 velocity;      // px/frame
  Vec2 previous;      // px, top-left corner before the last dragged frame; its throw is measured from here
  BodyKind kind = BodyKind::ball;  // what moves it
  Foot foot = Foot::box;           // what of it stands on slopes
  Gait gait;                       // what it remembers
  // Of a body that is a circle where bodies meet; 0 of others.
  double spin = 0;        // px/frame, of its rim; over 0: clockwise, as it rolls to the right
  double turn = 0;        // radians, 0 up to a whole turn: how far it is turned, clockwise
  bool is_clear = false;  // the exact solver has put it where no ground is; the scene has not changed since
  friend bool operator==(const Body&, const Body&) = default;
};

// A plain value: a copy of it is a snapshot, and giving the copy to a solver of the same scene goes on from
// there.
struct State {
  std::int64_t frame = 0;          // steps made so far
  std::vector<Body> bodies;        // by id
  int grabbed = 0;                 // id of the body that the mouse holds; 0: none
  int next_id = 1;                 // id of the next new body
  const Body* find(int id) const;  // null when there is none
  friend bool operator==(const State&, const State&) = default;
};

// What is held down in one step. A default one holds nothing.
struct Input {
  Vec2 mouse;               // px, in the level; finite
  bool mouse_down = false;  // the left button
  bool left = false;        // the key with which players run to the left
  bool right = false;       // the same to the right; both together: neither
  bool jump = false;        // the key with which players jump
  int grab = 0;  // id of the body that the button took when it went down; 0, or an unknown id: the body under
                 // the mouse
  friend bool operator==(const Input&, const Input&) = default;
};

// The state of frame 0: every body of the scene at its start.
State initial_state(const Scene& scene);

// The state that continues in an edited scene. A body keeps its place and velocity while its origin exists,
// and gets the kind and the foot that the origin has now. A new origin makes a new body with the next free
// id. A body whose origin is gone is removed. `exact`: a body that the edited ground buries deeper than
// the body is large is lifted straight up out of it, if a place within 16 cells is free.
State carry_over(const State& state, const Scene& edited);

// 64-bit FNV-1a over the frame and the bits of every body, equal on every machine.
std::uint64_t state_hash(const State& state);

}  // namespace talus
