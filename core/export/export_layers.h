// Layers of objects and of pictures, as maps of Tiled have them, and the files of their pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "../formats/tiled/tiled_map.h"
#include "exporter.h"

namespace talus {

struct ExportedLayers {
  // Those of the level, without pixels. An object with a picture has its position at the bottom left, and the
  // size in which the picture is drawn. One whose picture is missing, and one that Talus does not draw, is a
  // box.
  std::vector<ObjectLayer> level;
  std::vector<TiledLayer> layers;  // of the map, in the same order
  std::optional<TiledTileset>
      tileset;  // the pictures of objects, turned as they are drawn; none: there are none
  std::vector<ExportedFile> pictures;  // of objects and layers, each once
  std::vector<std::string> dropped;    // what is not in them, one phrase each
};

// first_gid: number of the first tile of the tileset.
ExportedLayers export_layers(const Level& level, const ExportRequest& request, std::uint32_t first_gid);

}  // namespace talus
