// What of a level is shown first.
#pragma once

#include <talus/collision/geometry.h>
#include <talus/level/level.h>
#include <talus/sim/state.h>

namespace talus {

inline Vec2 size_in_pixels(const TileMap& map) { return {map.px_width(), map.px_height()}; }
// px of the level: as large as TIC-80's in cells, and at most the map.
Vec2 size_of_screen(const TileMap& map);

// A part of the level that should be seen at once.
struct OpeningArea {
  Rect area;                // px of the level, on the map
  bool may_be_cut = false;  // whether whole pixels are worth more than its edges
  // Beyond which nothing is shown if the canvas has room for it: the map, or, without a body that the keys
  // steer, the part of a map of one layer that tiles and bodies take. px of the level.
  Rect bounds;
};

// The body that the view goes with: the chosen one, else the first that the keys steer; null if there is
// none.
const Body* followed_body(const State& state, int chosen);
// A screen around the body that the keys steer, which is a little below its middle; else what the bodies
// take, or a screen around the first one if they are far from each other; else what the tiles of ground take,
// or the first screen that has some; else the first screen.
OpeningArea opening_area(const Level& level, const State& state);
// A screen, px of the level, that goes with the followed body, or else shows the opening area. It is the
// first screen of the map, moved as little as that needs.
Rect screen_with_bodies(const Level& level, const State& state, int chosen);

}  // namespace talus
