// Shapes, bodies and curves as objects of Tiled, and back.
#pragma once

#include <optional>

#include "tiled_map.h"

namespace talus {

inline constexpr double kTiledTolerance = 0.125;  // px, from a curve to its polyline

// By flag, the name of the bool that a tile with it has: the flag's own name, without one that of its role
// ("up_slope"), else "flag5". One that is taken by another flag or property gives way to "flag5" too.
std::array<std::string, kFlagCount> tiled_flag_names(const Level& level);

// The shape's outline about its tile; nothing for a shape of kind none or one that cannot be used. Of one-way
// shapes the whole outline too, though only its line stops bodies.
std::vector<TiledObject> tiled_objects(const TileShape& shape);
// What a tile with the shape says of it in words: `shape`, "solid", "slope" or "profile"; where they are not
// so, `shape_side`, "floor", and `shape_one_way`, false; `shape_heights`, "0 8", in px; none for no shape.
TiledProperties tiled_properties(const TileShape& shape);

TiledObject tiled_object(const Spawn& spawn);
// Of an object of the type "ball" or "player"; nothing for others. A point gets a box of 8x8 px.
std::optional<Spawn> spawn_of(const TiledObject& object);

// A polyline from the first point of the curve on; of curves that cannot be used nothing.
std::optional<TiledObject> tiled_object(const LevelCurve& curve);
// A polyline of two points is a segment, a longer one a polyline where its points go to the right at equal
// distances, and else as many segments as it has lines. Of anything else none. It faces up, or where the
// property `faces` says.
std::vector<LevelCurve> curves_of(const TiledObject& object);

// How far off, in either direction, a number may be that Tiled has written.
double tiled_slack(double number);

// Whether two objects are the same place and outline, to the six digits that Tiled keeps of a number.
bool is_same_outline(const TiledObject& a, const TiledObject& b);

}  // namespace talus
