// StepRecord: what a step did. Recording changes no result; but bodies that meet and use up the work of a
// step may stop elsewhere, as none of them sleeps then.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <talus/collision/world.h>
#include <talus/sim/scene.h>

namespace talus {

// The other side of a contact: a tile of the map, or another body.
struct Obstacle {
  TileRole role = TileRole::solid;  // ball: a body of any kind
  Cell cell;                        // its tile; for a body, the tile it started from
  int body = 0;                     // id; 0 for a tile
  Rect box;                         // px
  int curve = -1;                   // number of a curve of the level; -1: not a curve
};

// How a body met a slope. For the article it is the correction, for which the floor is interpolated at the
// body's centre. For the other solvers, which do not round, it is the contact with a sloped line.
struct SlopeProbe {
  Obstacle slope;          // the slope that the probe found, not always that of the contact
  double delta = 0;        // how far along the slope the centre is, 0 at its left end to 1 at its right end
  double floor_y = 0;      // px, where the body's feet are put, before rounding; at a ceiling, its top
  double placed_y = 0;     // px, the body's top; for the article after its floor()
  Vec2 normal;             // unit, out of the slope
  bool corrected = false;  // the body was put at placed_y; false only if the article found it above
};

// A body met something.
struct ContactRecord {
  int body = 0;                         // id
  int order = 0;                        // from 0, within the body's step
  Obstacle other;                       // what it met
  Response response = Response::slide;  // how it reacted
  bool overlaps = false;                // the boxes overlapped before the move
  double ti = 0;  // time of impact, fraction of `move`; minus the overlap area if overlaps
  Vec2 move;      // px, what the body wanted when this contact was found
  Vec2 normal;    // unit, out of the obstacle; along an axis, except on slopes of exact and bump
  Vec2 touch;     // px, the body's top-left corner at the contact
  std::optional<SlopeProbe> slope;  // set if the contact led to a search for the slope's floor
  bool handled = false;             // false: found, but the solver did nothing more with it
  std::optional<Vec2> after = {};   // px, the motion that it went on with; only for exact
  double impulse = 0;  // mass times px/frame, along the normal, 0 if it changed no speed; only for exact
};

// A candidate of the broad phase whose box was tested against the body's path. Only the solvers on World,
// article and bump, record them.
struct TestedBox {
  int body = 0;    // id
  Obstacle other;  // what was tested
};

// How a body moved in this step.
struct BodyPath {
  int body = 0;            // id
  Rect from;               // px, its box before the step
  Vec2 goal;               // px, where it wanted its top-left corner
  Rect to;                 // px, its box after the step
  bool limited = false;    // its way or speed was cut to kMaxBodySpeed or kMaxBodyDistance
  bool capped = false;     // it met more contacts than the solver handles; the rest of its motion was dropped
  bool cut_short = false;  // it used up the work that it may take in a step, and stopped there
};

// What a game may want to hear or show. Only `exact` finds events.
struct StepEvent {
  // What happened.
  enum class Kind : std::uint8_t {
    hit,     // it was stopped or thrown back, faster than its pull or its keys change its speed in two steps
    landed,  // it stands, and did not after the step before
    left     // it stands no longer
  };
  Kind kind = Kind::hit;  // what happened
  int body = 0;           // id
  int other = 0;          // of a hit: id of the body that it hit; 0: the ground
  Vec2 normal;            // of a hit: unit, out of what it hit
  double impulse = 0;     // of a hit: mass times px/frame, along the normal
};

// "hit", "landed" or "left", as files, Lua and C have it; a literal.
std::string_view word_of(StepEvent::Kind kind);

// One step. A record may be used again for the next one, which keeps its memory.
struct StepRecord {
  std::vector<BodyPath> paths;          // by body id
  std::vector<ContactRecord> contacts;  // by body id; of one body in the order in which they were handled
  // Each once for a body, in the order of testing; the first 2,097,152.
  std::vector<TestedBox> tested;
  // Hits in the order in which they were handled. A body has landed or left after its own hits; bodies that
  // meet after those of all.
  std::vector<StepEvent> events;
  // The cells, lines and boxes that all bodies tested, in units of about 20 ns.
  std::int64_t work = 0;
  // Set before a step: only `events` is filled, which costs next to nothing. Not changed by clear().
  bool only_events = false;
  void clear();  // forgets the step
};

}  // namespace talus
