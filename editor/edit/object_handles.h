// Where objects are grabbed on the map, in px of their layer, which may be moved by an offset, and what
// becomes of them when they are dragged. Nothing here changes a level.
#pragma once

#include <string_view>
#include <vector>

#include "object_tools.h"

namespace talus {

// What the object tool draws.
enum class ObjectKind { rectangle, ellipse, polygon, point };
inline constexpr int kObjectKindCount = 4;
std::string_view label_of(ObjectKind kind);  // "rectangle"

// Places of an object that can be dragged, px of the map: the corners of a box or an ellipse, from the top
// left one clockwise, and the points of a polygon or a polyline. Points and pictures of tiles have none.
std::vector<Vec2> handles_of(const MapObject& object);
// The object with a handle at another place. The opposite corner of a box stays where it is, and a corner
// that is dragged beyond it turns the box inside out. handle: its index (asserted). Places are rounded to
// 1/256 px.
MapObject with_handle(MapObject object, int handle, Vec2 place);
// The object at another place.
MapObject moved_object(MapObject object, Vec2 by);

// The corners of a picture of a tile, px of the map; empty for others.
std::vector<Vec2> frame_of(const MapObject& object);

// The middles of the sides of a polygon or of the lines of a polyline, where new points can be pulled out.
std::vector<Vec2> middles_of(const MapObject& object);
// A new point behind that with the index `side`, at a place. side: an index of middles_of() (asserted).
MapObject with_point_after(MapObject object, int side, Vec2 place);
// Without a point; unchanged if too few would be left. point: its index (asserted).
MapObject without_point(MapObject object, int point);

// The offset of a layer of objects, px; none if the level has no such layer.
Vec2 offset_of_layer(const Level& level, int layer);
// point: px of the map. The frontmost object of a layer that can be changed, whose area has the point, or
// whose outline or place is within `reach` px of it; no object if there is none.
ObjectRef object_at(const Level& level, Vec2 point, double reach);

// A new object between two corners; of size 0 if it is a point.
MapObject object_between(MapObject::Form form, Vec2 from, Vec2 to);
// A polygon with these corners, px of the map, whose place is the first of them. At least 1 corner
// (asserted).
MapObject polygon_through(const std::vector<Vec2>& corners);

}  // namespace talus
