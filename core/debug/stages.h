// The stages of a body's step, one after another: what it wanted, what was in its way, what it met, where it
// was put, and what was left of its motion.
#pragma once

#include <string>
#include <vector>

#include "../collision/cast_trace.h"
#include "frame.h"

namespace talus {

enum class StageKind {
  wanted,    // the whole motion that it asked for
  searched,  // the cells and sides that were candidates for a contact
  met,       // the first of them
  placed,    // put on what it met
  went_on,   // the motion that was left, turned by what it met
  snapped,   // moved onto the floor below, as it walks there
  arrived    // where the step left it
};

struct Stage {
  StageKind kind = StageKind::wanted;
  Rect box;              // px, the body's at this stage
  Vec2 motion;           // px, that it has before it
  int contact = -1;      // index into the record's contacts; -1: it is about none
  std::string sentence;  // what happened, without a full stop
  std::string numbers;   // of a contact, as Explanation::numbers
  // Of `searched`. Only exact looks at cells; article and bump test boxes alone, of tiles and of bodies.
  std::vector<Cell> cells;                // looked at
  std::vector<CastCandidate> candidates;  // sides that were tested, with the time of each
  std::vector<Obstacle> tested;           // whose boxes were tested; of exact bodies alone
};

// In order; none at frame 0, and of a body that did not move in this step.
std::vector<Stage> stages_of(const Frame& frame, int body);

}  // namespace talus
