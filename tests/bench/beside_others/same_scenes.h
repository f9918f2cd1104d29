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
// By theme; one file each.
std::vector<ErrorScene> impact_scenes();
std::vector<ErrorScene> ground_scenes();
std::vector<ErrorScene> pile_scenes();

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

}  // namespace talus::beside
