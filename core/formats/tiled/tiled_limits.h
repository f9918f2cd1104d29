// What the map of Tiled that a level came from cannot hold of it: found before saving, so that it can be
// asked about before it is made.
#pragma once

#include <optional>
#include <vector>

#include <talus/formats/format.h>
#include "tiled_document.h"

namespace talus {

enum class TiledLimit { layers, size, tiles };

// A part of a level that is beyond a limit of its map.
struct BeyondTiled {
  TiledLimit limit = TiledLimit::layers;  // which one
  FormatError error;                      // what is wrong with the level: "has other layers of tiles ..."
};

// Each limit at most once; none for a level that did not come from Tiled. Takes time by the size of the file,
// if the level has other layers or another size.
std::vector<BeyondTiled> beyond_tiled(const Level& level);

// The limits one by one. level: one that came from Tiled. The result is nothing if the map holds it.
// document: the map, as the level came from it.
std::optional<FormatError> layers_beyond_tiled(const Level& level, const TiledDocument& document);
FormatResult<std::optional<FormatError>> size_beyond_tiled(const Level& level, const TiledDocument& document);
std::optional<FormatError> tiles_beyond_tiled(const Level& level);
// Whether tiles that no tileset has are among these cells.
std::optional<FormatError> cells_beyond_tiled(const MapCells& cells, const TiledFrame& frame);
std::optional<FormatError> tile_beyond_tiled(TileNumber tile, const TiledFrame& frame);

// Whether the level is one of several layers of its map.
bool is_one_of_many(const TiledOrigin& origin, const TiledDocument& document);
// Whether the map has another size now than in the file.
bool is_resized(const Level& level);
// Whether a cell of the level was off the map when that was opened.
bool was_off_map(Cell cell, const TiledFrame& frame);

// Why a level cannot be saved into its map, and what would help.
FormatError not_in_tiled(std::string why, std::string remedy = "save the level as .talus.json");

}  // namespace talus
