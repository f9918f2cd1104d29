// Shapes, bodies and curves as objects of Tiled, and back.
#pragma once

#include <optional>
#include <span>

#include "tiled_map.h"

namespace talus {

inline constexpr double kTiledTolerance = 0.125;  // px, from a curve to its polyline

// Returns the outline of a shape on its tile of that size; nothing for kind none, or for a shape that cannot
// be used. One-way shapes get the whole outline, too, though only their line stops bodies.
std::vector<TiledObject> tiled_objects(const TileShape& shape, TileSize tile);
// Returns the properties that describe a tile's shape: `shape`, "solid", "slope", "profile", "polygon" or
// "group", whose outlines are the objects; unless
// default, `shape_side`, "floor", and `shape_one_way`, false; `shape_heights`, "0 8", in px; unless 0,
// `shape_conveyor`, in px/frame. Empty for no shape.
TiledProperties tiled_properties(const TileShape& shape);

// px/frame: the speed of a conveyor, as a property of this name says; nothing if it does not, or if a
// conveyor cannot be as fast.
std::optional<double> conveyor_of(const TiledProperties& properties, std::string_view name);

TiledObject tiled_object(const Spawn& spawn);
// type: that of the object, or of the tile that it shows. Returns nothing unless that is the word of a kind
// of body and the object is a box, a point or a tile. A point gets the size of a new body of the kind among
// tiles of that size. anchor: of a tile, see TiledTileset.
std::optional<Spawn> spawn_of(const TiledObject& object, std::string_view type, TileSize tile, Vec2 anchor);
// The place that an object has in the file if it is this body.
Vec2 tiled_position(const Spawn& spawn, const TiledObject& object, Vec2 anchor);

// A polyline from the first point of the curve on; nothing for a curve that cannot be used.
std::optional<TiledObject> tiled_object(const LevelCurve& curve);
// A polyline of two points becomes a segment. A longer one becomes a polyline if its points go to the right
// at equal distances; if not, one segment for each line, of which those are left out that no level could
// hold, beyond kMaxCurves + 1. Other objects become nothing. The result faces up, or where the property
// `faces` says, and is a conveyor as `conveyor` says.
std::vector<Curve> curves_of(const TiledObject& object);

// The curve that the properties of a polyline give (see tiled_object): `kind` and its numbers, moved to where
// the polyline is, as other programs move that alone. Nothing if they do not, or if the polyline does not run
// along that curve.
std::optional<Curve> curve_of_numbers(const TiledObject& object);
// The names of all properties that tell the form of a curve, `faces` and `conveyor`.
std::span<const std::string_view> curve_properties();

// How far off a number may be that Tiled has written, in either direction.
double tiled_slack(double number);

// Whether two objects have the same place and outline, to the six digits that Tiled keeps of a number.
bool is_same_outline(const TiledObject& a, const TiledObject& b);

}  // namespace talus
