// The layers of tiles that a level's map consists of.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <talus/collision/shape.h>
#include <talus/level/layer_group.h>
#include <talus/level/map_cells.h>
#include <talus/level/object_layer.h>
#include <talus/level/tileset.h>

namespace talus {

// In which order the cells of a layer are drawn, which counts where tiles reach beyond their cells: row by
// row in the second direction, each row in the first.
enum class RenderOrder : std::uint8_t { right_down, right_up, left_down, left_up };

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
  int group = -1;              // the group that it is in, an index in TileLayers::groups; -1: none
  std::string extra = {};      // JSON object of keys that this version does not know, or empty
  // As many as the map has cells; null for the chosen layer, whose cells are in Level::map.
  std::shared_ptr<const MapCells> cells = nullptr;
};
// The same content; cells are compared by what they hold.
bool operator==(const TileLayer& a, const TileLayer& b);

// The layers of a level, from the back to the front, and the one that tools work on.
struct TileLayers {
  std::vector<TileLayer> list = {TileLayer()};  // 1 to kMaxLayers
  int chosen = 0;                               // index of the layer that has its cells in Level::map
  RenderOrder order = RenderOrder::right_down;  // of the cells of each
  // Of layers of all kinds, at most kMaxLayerGroups, each with a layer. See tidy_groups() for their order.
  LayerGroups groups = {};
  // How many there are, at least 1.
  int count() const { return static_cast<int>(list.size()); }
  // Whether there is one layer, which is in no group, drawn as it is and ground: what each level had once.
  // Its name does not matter.
  bool is_plain() const;
  friend bool operator==(const TileLayers&, const TileLayers&) = default;
};

// How a layer looks with all groups that it is in: visible only if they all are, locked if one of them is;
// opacity, parallax and tint are multiplied, offsets added, and each is brought into its range. A group that
// does not exist counts as none.
LayerLooks shown_looks(const LayerGroups& groups, const TileLayer& layer);
// The same of a layer of objects or of a picture.
LayerLooks shown_looks(const LayerGroups& groups, const ObjectLayer& layer);
// The same of a group, with the groups that it is in.
LayerLooks shown_looks(const LayerGroups& groups, const LayerGroup& group);
// Brings the groups into the order in which their first layers are drawn, each before those in it, so that
// equal levels have equal groups. Groups without layers go, and so do links to groups that are not there, and
// a link of each ring. objects: the layers besides those of tiles.
void tidy_groups(TileLayers& layers, std::vector<ObjectLayer>& objects);

}  // namespace talus
