// The layers of objects that a level's map has beside its layers of tiles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>

namespace talus {

// A thing that is drawn on the map, free of its grid. Its fields mean what those of Tiled's objects mean.
struct MapObject {
  // What it looks like.
  enum class Form : std::uint8_t {
    box,       // of `size`; a point if that is 0
    ellipse,   // within a box
    polygon,   // the inside of `points`
    polyline,  // lines from point to point
    tile,      // a picture of a tile, whose bottom left corner is at `position`
    other      // what Talus does not draw
  };
  Form form = Form::box;          // what it looks like
  std::string name = {};          // for people; may be empty or repeated
  std::string type = {};          // its class; may be empty
  Vec2 position = {};             // px, each at most kMaxObjectPlace to either side
  Vec2 size = {};                 // px, 0 to kMaxObjectPlace; not of polygons and polylines
  double rotation = 0;            // degrees clockwise about `position`, any finite number
  std::vector<Vec2> points = {};  // px from `position`; of polygons and polylines, else empty
  bool one_way = false;           // whether it stops only what comes from above, if its layer is ground
  std::uint32_t tile = 0;         // of a tile: its number in the cells of the file that it came from
  std::string properties = {};    // JSON object of what its user wrote there, or empty
  friend bool operator==(const MapObject&, const MapObject&) = default;
};

// Objects that are shown and hidden together.
struct ObjectLayer {
  std::string name = {};                // for people; may be empty or repeated
  bool is_ground = false;               // whether areas and lines among its objects are ground
  bool visible = true;                  // whether it is drawn
  std::vector<MapObject> objects = {};  // from the back to the front
  std::string extra = {};               // JSON object of keys that this version does not know, or empty
  friend bool operator==(const ObjectLayer&, const ObjectLayer&) = default;
};

inline constexpr double kMaxObjectPlace = 16'777'216;       // px
inline constexpr std::size_t kMaxObjectLayers = 4096;       // of a level
inline constexpr std::size_t kMaxMapObjects = 262'144;      // of all layers together
inline constexpr std::size_t kMaxObjectPoints = 2'097'152;  // of all objects together
// Bytes of names, classes and properties of all objects together.
inline constexpr std::size_t kMaxObjectBytes = std::size_t{16} << 20;

// The outline of an object that has an area, around it in either direction, in px of the map; empty for
// others. No side of an ellipse is further than 1/256 px from it, unless it needs more than 1024 sides.
std::vector<Vec2> outline_of(const MapObject& object);
// The points of a polyline, in px of the map; empty for others.
std::vector<Vec2> line_of(const MapObject& object);

}  // namespace talus
