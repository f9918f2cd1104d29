// The layers of objects and of pictures that a level's map has beside its layers of tiles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>
#include <talus/level/picture_part.h>

namespace talus {

// A thing that is drawn on the map, free of its grid. Its fields mean what those of Tiled's objects mean.
struct MapObject {
  // What it looks like.
  enum class Form : std::uint8_t {
    box,       // of `size`; a point if that is 0
    ellipse,   // within a box
    polygon,   // the inside of `points`
    polyline,  // lines from point to point
    tile,      // a picture of a tile
    other      // what Talus does not draw
  };
  Form form = Form::box;          // what it looks like
  std::string name = {};          // for people; may be empty or repeated
  std::string type = {};          // its class; may be empty
  Vec2 position = {};             // px, each at most kMaxObjectPlace to either side
  Vec2 size = {};                 // px, 0 to kMaxObjectPlace; not of polygons and polylines
  double rotation = 0;            // degrees clockwise about `position`, any finite number
  bool visible = true;            // whether it is drawn
  std::vector<Vec2> points = {};  // px from `position`; of polygons and polylines, else empty
  bool one_way = false;           // whether it stops only what comes from above, if its layer is ground
  std::uint32_t tile = 0;         // of a tile: its number in the cells of the file that it came from
  PicturePart picture = {};       // of a tile: what is drawn in a box of `size`
  Vec2 anchor = {0, 1};           // of a tile: where `position` is in that box, shares of its size, each 0..1
  std::string properties = {};    // JSON object of what its user wrote there, or empty
  friend bool operator==(const MapObject&, const MapObject&) = default;
};

// The picture of a layer that is one, in its own size.
struct LayerImage {
  std::string path = {};   // of its file, relative to the level's folder; may be empty
  PicturePart part = {};   // the whole picture; without one, nothing is drawn
  bool repeats_x = false;  // whether it is repeated to the left and to the right without end
  bool repeats_y = false;  // whether it is repeated upwards and downwards without end
  friend bool operator==(const LayerImage&, const LayerImage&) = default;
};

inline constexpr int kInFront = std::numeric_limits<int>::max();  // of all layers of tiles

// Objects that are shown and hidden together, or a picture. Its fields mean what those of Tiled's layers
// mean.
struct ObjectLayer {
  std::string name = {};   // for people; may be empty or repeated
  bool is_ground = false;  // whether areas and lines among its objects are ground
  bool visible = true;     // whether it is drawn
  bool locked = false;     // whether tools leave it alone
  double opacity = 1;      // 0..1
  Vec2 offset = {};        // px, of all that is in it, also of its ground; each within kMaxLayerOffset
  Vec2 parallax = {1, 1};  // by how much it moves with the camera, each within kMaxParallax; not its ground
  Rgb tint = {255, 255, 255};  // multiplies the colours of its pictures
  int group = -1;              // the group that it is in, an index in TileLayers::groups; -1: none
  // How many layers of tiles are behind it, from 0; more than there are: it is in front of all. Of those with
  // the same number, the later ones in Level::objects are in front.
  int place = kInFront;
  bool by_y = false;                     // whether objects are drawn in the order of their y; else as listed
  std::vector<MapObject> objects = {};   // from the back to the front
  std::optional<LayerImage> image = {};  // of a layer of a picture, which has no objects
  std::string extra = {};                // JSON object of keys that this version does not know, or empty
  friend bool operator==(const ObjectLayer&, const ObjectLayer&) = default;
};

inline constexpr double kMaxLayerOffset = 1'000'000;        // px, to either side
inline constexpr double kMaxParallax = 100;                 // to either side
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
