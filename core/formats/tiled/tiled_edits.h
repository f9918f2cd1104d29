// What is to be changed of the tiles and objects of a file of Tiled.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "tiled_map.h"

namespace talus {

struct TiledPropertyEdit {
  std::string name;
  std::optional<decltype(TiledProperty::value)> value = {};  // nothing: the property goes
};

struct TiledObjectEdit {
  int index = -1;        // among the objects of the group; -1: a new one, with all of `object`
  bool removes = false;  // the object goes
  // The place, size and form that the object gets; nothing: it keeps its own. Its name and type are written
  // if they differ from what the file says; its properties are those below.
  std::optional<TiledObject> object = {};
  std::vector<TiledPropertyEdit> properties = {};
  // What it was, with what its template says. Then of `object` only what differs from it is written.
  std::optional<TiledObject> before = {};
  int at = -1;  // of a new one: it comes before the object with this index; -1: behind all others
};

// Of a tile of a tileset.
struct TiledTileEdit {
  std::vector<TiledObjectEdit> objects = {};
  std::vector<TiledPropertyEdit> properties = {};
  std::optional<double> probability = {};  // nothing, also below: it keeps its own
  std::optional<std::string> type = {};    // its class
  std::optional<std::vector<TiledTile::Frame>> animation = {};
};
using TiledTileEdits = std::map<int, TiledTileEdit>;  // by the tile's id in the tileset

enum class TiledLayerKind { tiles, objects, groups };
// A layer in the order that the layers of objects get.
struct TiledLayerSlot {
  int from = -1;  // which layer of the file it is, from 0 among those of its kind; -1: a new, empty one
  std::string name = {};  // of a new one
};
// A layer or a group of them, with what is in it, from the back to the front.
struct TiledLayerNode {
  TiledLayerKind kind = TiledLayerKind::tiles;
  int from = -1;  // which one of the file it is, from 0 among those of its kind; -1: a new, empty one
  std::string name = {};
  int slot = -1;  // for the caller's use
  std::vector<TiledLayerNode> inside = {};
};
using TiledLayerTree = std::vector<TiledLayerNode>;

}  // namespace talus
