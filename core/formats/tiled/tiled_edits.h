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
};

// Of a tile of a tileset.
struct TiledTileEdit {
  std::vector<TiledObjectEdit> objects = {};
  std::vector<TiledPropertyEdit> properties = {};
};
using TiledTileEdits = std::map<int, TiledTileEdit>;  // by the tile's id in the tileset

}  // namespace talus
