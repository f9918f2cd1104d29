// The layers of tiles that a level's map consists of.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <talus/collision/shape.h>
#include <talus/level/tileset.h>

namespace talus {

inline constexpr double kMaxLayerOffset = 1'000'000;  // px, to either side
inline constexpr double kMaxParallax = 100;           // to either side

// A layer of tiles, as large as the map. Its fields mean what those of Tiled's layers mean.
struct TileLayer {
  std::string name = {};  // for people; may be empty or repeated
  bool is_ground = true;  // whether its tiles are ground and bodies; else it is only drawn
  bool visible = true;    // whether it is drawn
  bool locked = false;    // whether tools leave it alone
  double opacity = 1;     // 0..1
  Vec2 offset = {};  // px, of its picture, each at most kMaxLayerOffset to either side; not of its ground
  Vec2 parallax = {1, 1};      // by how much its picture moves with the camera, each within kMaxParallax
  Rgb tint = {255, 255, 255};  // multiplies the colours
  std::string extra = {};      // JSON object of keys that this version does not know, or empty
  // Tiles row by row, as many as the map has cells; null for the chosen layer, whose cells are in Level::map.
  std::shared_ptr<const std::vector<TileNumber>> cells = nullptr;
};
// The same content; cells are compared by their tiles.
bool operator==(const TileLayer& a, const TileLayer& b);

// The layers of a level, from the back to the front, and the one that tools work on.
struct TileLayers {
  std::vector<TileLayer> list = {TileLayer()};  // 1 to kMaxLayers
  int chosen = 0;                               // index of the layer that has its cells in Level::map
  // How many there are, at least 1.
  int count() const { return static_cast<int>(list.size()); }
  // Whether there is one layer, which is drawn as it is and is ground: what each level had once. Its name
  // does not matter.
  bool is_plain() const;
  friend bool operator==(const TileLayers&, const TileLayers&) = default;
};

}  // namespace talus
