// Scenes: worlds, how long they run, and what is measured of them.
#pragma once

#include <string>
#include <vector>

#include "engines.h"

namespace talus::beside {

// A world whose right answer is known, or a number that must not change.
struct ErrorScene {
  std::string name;
  World world;
  int frames;
  std::vector<std::string> measures;  // what `run` returns, with units
  // Runs a new engine of the world for all frames.
  std::vector<double> (*run)(const World& world, int frames, Engine& engine);
};
std::vector<ErrorScene> error_scenes();

// A stretch of frames.
struct Phase {
  std::string name;  // empty: it is not timed
  int frames;
};
struct SpeedScene {
  World world;
  std::vector<Phase> phases;  // one after the other
};
std::vector<SpeedScene> speed_scenes(int bodies);

// px: how deep the two that overlap most are in one another, of boxes and walls.
double deepest_overlap(const World& world, const Engine& engine);
// How many boxes are off the map, as they went through a wall.
int count_lost(const World& world, const Engine& engine);
// Steps once, and returns how many boxes that moves by more than a hundredth of a px.
int count_moving(const World& world, Engine& engine);

}  // namespace talus::beside
