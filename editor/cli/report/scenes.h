// The levels of the report's scenes, made by code, and the questions about them.
#pragma once

#include <vector>

#include <talus/level/level.h>
#include "reference.h"
#include "setup.h"

namespace talus {

// The ground of a row's scene with its tuning, without bodies. Scenes with walls of bodies have no ground.
Level report_level(const Setup& setup);

// The same ground for the reference; not for walls.
TrueFloor true_floor(const Setup& setup);

// The corner of a scene's ground, on the grid: near (scale, scale). Beyond kMaxSquareScale, where a map that
// is both long and high would be too large, near (scale, 0), or near (0, scale) if only heights are measured.
inline constexpr double kMaxSquareScale = 1e4;
Vec2 report_origin(const Setup& setup);

// The number in the precision of the row.
double stored(const Setup& setup, double value);
Vec2 stored(const Setup& setup, Vec2 value);

// One move, with the exact answer to it.
struct Drop {
  Rect start;
  Vec2 motion;        // px, downwards
  Wide impact = 0;    // fraction of the motion, 0..1; above 1: it meets nothing
  Wide x = 0, y = 0;  // px, top-left corner at the impact, or else at the end of the motion
};
// The same moves for each solver and each scale, except for translation and rounding.
std::vector<Drop> report_drops(const Setup& setup, std::size_t count);

// px, the left side of the wall of tiles.
double wall_x(const Setup& setup);

// Adds a body to a level.
void add_body(Level& level, const Rect& box, Vec2 velocity);

}  // namespace talus
