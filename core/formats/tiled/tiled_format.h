// Maps and tilesets of Tiled, `.tmx`, `.tmj`, `.tsx` and `.tsj`, which are read alone. A tileset without a
// map becomes a level with an empty one.
//
// Tilesets and pictures in files of their own are looked for in the folder of the file that names them, by
// relative paths; without a folder tilesets are an error, and pictures are left out. core/export writes maps.
#pragma once

#include <talus/formats/format.h>

namespace talus {

bool accepts_tiled_json(std::string_view bytes, const FormatContext& context);
bool accepts_tiled_xml(std::string_view bytes, const FormatContext& context);
// A layer of tiles of a map.
struct TiledLayerName {
  std::string name;       // may be empty, and that of others too
  std::size_t cells = 0;  // that are not empty
};
// In their order, as ImportChoices::layer_number counts them. None of a file that is no readable map, or
// where `progress` said that it ends.
std::vector<TiledLayerName> tiled_layers_of_file(const std::string& path, const Progress& progress = {});

// Of either form, by content.
FormatResult<Level> read_tiled(std::string_view bytes, const FormatContext& context);

}  // namespace talus
