// Maps and tilesets of Tiled, `.tmx`, `.tmj`, `.tsx` and `.tsj`. A tileset becomes a
// level with a map of its tiles. A level is written back into the file that it came from, of which only what
// was edited changes (tiled_save.cpp). core/export writes new maps.
//
// Files of tilesets and pictures are found by relative paths from the folder of the file that names them.
// Without a folder, tilesets are an error, and pictures are left out.
#pragma once

#include <span>

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
// The same with tilesets that stand for those in their files.
FormatResult<Level> read_tiled_again(std::string_view bytes, const FormatContext& context,
                                     std::span<const TiledOrigin::File> tilesets);

// Writes the file that the level came from, with what was edited, and the files of its tilesets; `held` is
// the level that they give. It is an error if the level came from no such file, or from one in another
// folder, or if the file cannot hold its cells or the pictures of its tiles.
FormatResult<WrittenLevel> write_tiled(const Level& level, const FormatContext& context);

}  // namespace talus
