// Maps and tilesets of Tiled, `.tmx`, `.tmj`, `.tsx` and `.tsj`. They are only read here. A tileset becomes a
// level with an empty map.
//
// Files of tilesets and pictures are found by relative paths from the folder of the file that names them.
// Without a folder, tilesets are an error, and pictures are left out. core/export writes maps.
#pragma once

#include <talus/formats/format.h>

namespace talus {

bool accepts_tiled_json(std::string_view bytes, const FormatContext& context);
bool accepts_tiled_xml(std::string_view bytes, const FormatContext& context);
// A tile layer of a map.
struct TiledLayerName {
  std::string name;       // may be empty, or the same as that of others
  std::size_t cells = 0;  // number of cells that are not empty
};
// The tile layers in their order, as ImportChoices::layer_number counts them. Empty if the file is not a
// readable map, or if `progress` stopped the work.
std::vector<TiledLayerName> tiled_layers_of_file(const std::string& path, const Progress& progress = {});

// Reads either form. The content says which it is.
FormatResult<Level> read_tiled(std::string_view bytes, const FormatContext& context);

}  // namespace talus
