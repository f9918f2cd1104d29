// The same worlds of boxes for Talus, Box2D and Chipmunk. Lengths are px, times are frames, and y goes down.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>

namespace talus::beside {

inline constexpr double kFramesPerSecond = 60;
inline constexpr double kCell = 8;  // px; walls are made of whole tiles of this size

// What boxes and walls are made of. In Talus, friction belongs to the kind of a body, so there are only these
// two.
struct Material {
  double friction, bounce;
  friend bool operator==(const Material&, const Material&) = default;
};
inline constexpr Material kElastic{0, 1};
inline constexpr Material kCrate{0.5, 0.1};

// A box at the start. Boxes weigh by their area, and do not turn.
struct Box {
  Rect at;
  Vec2 velocity = {};  // px/frame
};
// A line from left to right that stops what comes from above.
struct Incline {
  Vec2 from, to;
};

struct World {
  double width = 0, height = 0;  // px, of the map that holds all walls
  double gravity = 0;            // px/frame^2
  Material material = kElastic;
  std::vector<Rect> walls = {};
  std::vector<Incline> inclines = {};
  std::vector<Box> boxes = {};
};

// A world that goes on frame by frame.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual void step() = 0;
  virtual Rect box(std::size_t index) const = 0;       // px
  virtual Vec2 velocity(std::size_t index) const = 0;  // px/frame
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
