// What scenes are made of.
#pragma once

#include <random>

#include "engines.h"
#include "measures.h"
#include "same_scenes.h"

namespace talus::beside {

using Values = std::vector<double>;

inline constexpr double kGravity = 0.2;  // px/frame^2
inline constexpr double kWall = 64;      // px, so thick that nothing passes it within a frame

// Measures of several scenes.
inline const char* const kEnergy = "energy, share";
inline const char* const kOverlap = "overlap, px";
inline const char* const kPlace = "place, px";

// Numbers that look random, and are the same on every machine.
class Random {
 public:
  explicit Random(unsigned seed) : bits_(seed) {}
  double operator()(double low, double high) {
    return low + (high - low) * (static_cast<double>(bits_()) / 4294967296.0);
  }

 private:
  std::mt19937 bits_;
};

// A world with walls on all sides around a space of this size.
inline World room(double width, double height) {
  World world;
  world.width = width + 2 * kWall;
  world.height = height + 2 * kWall;
  world.walls = {{0, 0, world.width, kWall},
                 {0, kWall + height, world.width, kWall},
                 {0, kWall, kWall, height},
                 {kWall + width, kWall, kWall, height}};
  return world;
}

// A world of 256x256 px with a floor.
inline World floor_world(Material material) {
  World world{.width = 256, .height = 256, .gravity = kGravity, .material = material};
  world.walls = {{0, 256 - kWall, 256, kWall}};
  return world;
}

}  // namespace talus::beside
