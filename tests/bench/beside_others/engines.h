// The same worlds of boxes and circles for Talus, Box2D and Chipmunk. Lengths are px, times are frames, and y
// goes down.
#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>

namespace talus::beside {

inline constexpr double kFramesPerSecond = 60;
inline constexpr double kCell = 8;  // px; walls are made of whole tiles of this size

// What bodies and walls are made of. In Talus, friction belongs to the kind of a body, so there are only
// these: boxes are elastic or crates, circles are elastic or discs.
struct Material {
  double friction, bounce;
  friend bool operator==(const Material&, const Material&) = default;
};
inline constexpr Material kElastic{0, 1};
inline constexpr Material kCrate{0.5, 0.1};
inline constexpr Material kDisc{0.5, 0.3};

// A body at the start. It weighs by the area of its box, also if it is a circle. Boxes do not turn. Circles
// do, as full discs.
struct Body {
  Rect at;                // a square if it is round
  Vec2 velocity = {};     // px/frame
  bool is_round = false;  // the circle in `at`
};
// A line from left to right that stops what comes from above.
struct Incline {
  Vec2 from, to;
};
// Half of a circle that stops what comes from above. Box2D and Chipmunk know no arcs: segments take its place
// there.
struct HalfCircle {
  Vec2 center;
  double radius;
  bool is_hill;  // the upper half, else the lower one: a bowl
};
inline constexpr int kSegments = 256;
// The ends of the segments, from left to right.
inline std::vector<Vec2> points_of(const HalfCircle& half) {
  std::vector<Vec2> points;
  for (int i = 0; i <= kSegments; ++i) {
    const double angle = std::numbers::pi * i / kSegments;
    const Vec2 off = Vec2{-std::cos(angle), std::sin(angle) * (half.is_hill ? -1 : 1)} * half.radius;
    points.push_back(half.center + off);
  }
  return points;
}

struct World {
  double width = 0, height = 0;  // px, of the map that holds all walls
  double gravity = 0;            // px/frame^2
  Material material = kElastic;
  std::vector<Rect> walls = {};
  std::vector<Incline> inclines = {};
  std::vector<HalfCircle> half_circles = {};
  std::vector<Body> bodies = {};
};

// A world that goes on frame by frame.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual void step() = 0;
  virtual Rect box(std::size_t index) const = 0;       // px, around the body
  virtual Vec2 velocity(std::size_t index) const = 0;  // px/frame
  virtual double spin(std::size_t index) const = 0;    // px/frame, of the rim of a circle, clockwise
};

// An engine with its settings.
struct Contestant {
  std::string name;  // "Box2D usual"
  std::function<std::unique_ptr<Engine>(const World&)> make;
};

// The sub-steps of a frame that `best` settings have.
inline constexpr int kBestSubsteps = 4;

std::vector<Contestant> talus_engines();
std::vector<Contestant> box2d_engines();
std::vector<Contestant> chipmunk_engines();

}  // namespace talus::beside
