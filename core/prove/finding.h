// Finding: something that a body did in a trial, and that the geometry of the ground does not explain.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <talus/sim/solver.h>
#include "level/recording.h"

namespace talus {

enum class FindingKind : std::uint8_t {
  stops,          // it stopped, though it could have gone on
  slows,          // it lost speed, though nothing is in its way
  leaves_floor,   // it left the floor, though it goes on
  jumps,          // it rose more than its floor does
  floats,         // it is said to stand, where no floor is at its feet
  inside,         // it came into the ground
  falls_through,  // it came through a floor from above
  ghost,          // it was stopped by something that is not there
  gains,          // it got speed or height from nothing
  lip,            // an edge stopped it that is too low to be meant
  gap,            // its floor has a gap that is narrower than it is
  wedged          // it is between two grounds too steep to stand on, and comes back there from every jump
};

struct FindingInfo {
  std::string_view word;     // in JSON: "leaves-floor"
  std::string_view label;    // on screen: "leaves the floor"
  bool of_level;             // a fault of the level; else of the solver
  std::string_view by_hand;  // what to do, a sentence with a full stop
};
// The row of a kind.
const FindingInfo& info_of(FindingKind kind);

// One run of one body: how it starts, and which keys are held.
struct Trial {
  Body body;            // at its start, alone in the level
  double speed = 1.5;   // px/frame, the run_speed of its tuning
  int direction = 0;    // key that is held: -1 left, 1 right, 0 none
  int run_from = 1;     // the frame from which that key is held, 1 or later
  int jump_frames = 0;  // frames, from the start, in which the jump key is held
  int frames = 0;       // the most steps that it takes
};

// What is held down in the step to a frame of a trial, from 1.
Input input_of(const Trial& trial, int frame);
// The start of a trial, to play it again.
LoneBody lone_body_of(const Trial& trial);

struct Finding {
  FindingKind kind = FindingKind::stops;
  SolverKind solver = SolverKind::exact;
  Trial trial;    // plays it again
  int frame = 0;  // step of the trial, from 1, after which it was found
  Cell cell;      // of the place; of a lip that of the higher ground; on the map
  Vec2 place;     // px, the middle of the body's bottom then; of a lip the top of the edge, of a gap where
                  // the floor ends
  // px: of a lip its height, of a gap its width, of stops, slows and jumps how much; of gains the fall that
  // gives as much speed. Of bodies that meet, too: of inside and falls-through the depth, of a ghost how far
  // the way is free, up to 8; of others these are 0.
  double amount = 0;
  Obstacle met;   // what stopped it; of other kinds what it met last
  int count = 1;  // trials of this body, direction and kind with a finding in this cell
};

// Counts another finding of the same kind, body and cell. The trial that shows more of the way there is kept,
// as its recording is what people look at.
void add_alike(Finding& finding, const Finding& other);

// A sentence without a full stop: "a player of 8x8 px stops at the place 12.5, 40 px, though its way is
// free".
std::string message_of(const Finding& finding);
// The same without its place and its solver.
std::string placeless_message_of(const Finding& finding);

}  // namespace talus
