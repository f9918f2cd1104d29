// The stages of a body's step, in order: what it wanted, what was in its way, what it met, where it was put,
// and what was left of its motion.
#pragma once

#include <string>
#include <vector>

#include "../collision/cast_trace.h"
#include "frame.h"

namespace talus {

enum class StageKind {
  wanted,    // the whole motion that the body asked for
  searched,  // the cells and sides that were candidates for a contact
  met,       // the first contact among them
  placed,    // put on the thing it met
  went_on,   // the motion that was left, turned by what it met
  snapped,   // moved onto the floor below, as it walks
  arrived    // the place at the end of the step
};

struct Stage {
  StageKind kind = StageKind::wanted;
  Rect box;              // px, of the body at this stage
  Vec2 motion;           // px, still to be made
  int contact = -1;      // index into the record's contacts; -1: the stage is about no contact
  std::string sentence;  // what happened, without a full stop
  std::string numbers;   // numbers of the contact, as Explanation::numbers
  // For `searched`. Only exact tests cells; article and bump test only boxes of tiles and bodies.
  std::vector<Cell> cells;                // that were tested
  std::vector<CastCandidate> candidates;  // sides that were tested, with the time of each
  std::vector<Obstacle> tested;           // things whose boxes were tested; for exact, only bodies
};

// In order. Empty at frame 0, and for a body that did not move in this step.
std::vector<Stage> stages_of(const Frame& frame, int body);

}  // namespace talus
