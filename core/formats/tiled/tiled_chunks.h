// The parts of maps, which infinite ones have, and the map that they are together.
#pragma once

#include <optional>

#include "tiled_map.h"

namespace talus {

// A rectangle of cells of a layer. The places are those of the file, and may be negative.
struct TiledChunk {
  int x = 0, y = 0;                  // cells, of its top left corner; at most kMaxTiledChunkPlace from 0
  int width = 0, height = 0;         // cells, each at least 1
  std::vector<std::uint32_t> cells;  // as in TiledLayer
};

inline constexpr int kMaxTiledChunkPlace = 1 << 30;  // cells

// By layer of the map; empty for layers without tiles.
using TiledChunks = std::vector<std::vector<TiledChunk>>;

// Gives the map the size of the rectangle around all chunks, without the rows and columns at its edges in
// which no layer has a tile and no object begins. The layers get their cells, and the objects move with them.
// An infinite map without tiles keeps the map's size. Where chunks overlap, the last one counts. Returns what
// is wrong, as the end of a sentence, if that map would be too large: then it is as it was. frame: how the
// map was numbered before, whose rectangle stays in it; null: it was not read before.
std::optional<std::string> join_chunks(TiledChunks chunks, const TiledFrame* frame, TiledMap& map);

// Of a layer of a finite map, whose chunks have their places on it: whether one has a tile off the map, and
// the cells of those on it, the last one above all others.
bool has_tiles_off(const std::vector<TiledChunk>& chunks, const TiledMap& map);
std::vector<std::uint32_t> cells_of_chunks(std::vector<TiledChunk> chunks, const TiledMap& map);

}  // namespace talus
