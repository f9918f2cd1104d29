// What is measured of a world that an engine runs.
#pragma once

#include "engines.h"

namespace talus::beside {

double length(Vec2 v);
double mass(const World& world, std::size_t index);
// Of motion and of turning.
double energy(const World& world, const Engine& engine);
// px: how deep the two that overlap most are in one another, of bodies and walls.
double deepest_overlap(const World& world, const Engine& engine);
// How many bodies are off the map, as they went through a wall.
int count_lost(const World& world, const Engine& engine);
// Steps once, and returns how many bodies that moves by more than a hundredth of a px.
int count_moving(const World& world, Engine& engine);

}  // namespace talus::beside
