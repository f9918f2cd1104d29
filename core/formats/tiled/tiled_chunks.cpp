// Measures chunks before it makes the map of them.
#include "tiled_chunks.h"

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

// Cells, from the first ones to those before the ends. Empty while nothing was added.
struct CellBounds {
  std::int64_t x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  bool is_empty() const { return x0 == x1; }
  std::int64_t width() const { return x1 - x0; }
  std::int64_t height() const { return y1 - y0; }
  void add(const CellBounds& other) {
    if (other.is_empty()) return;
    const CellBounds old = is_empty() ? other : *this;
    *this = {std::min(old.x0, other.x0), std::min(old.y0, other.y0), std::max(old.x1, other.x1),
             std::max(old.y1, other.y1)};
  }
};

// The cells of a chunk that are not empty.
CellBounds bounds_of_tiles(const TiledChunk& chunk) {
  CellBounds bounds;
  for (int row = 0; row < chunk.height; ++row) {
    const auto begin = chunk.cells.begin() + std::ptrdiff_t{row} * chunk.width, end = begin + chunk.width;
    const auto is_tile = [](std::uint32_t cell) { return cell != 0; };
    const auto first = std::find_if(begin, end, is_tile);
    if (first == end) continue;
    const auto after =
        std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), is_tile);
    const std::int64_t y = std::int64_t{chunk.y} + row;
    bounds.add({chunk.x + (first - begin), y, chunk.x + (after.base() - begin), y + 1});
  }
  return bounds;
}

// The cell of a place, px, if it is in the bounds.
CellBounds cell_of(Vec2 place, TileSize tile, const CellBounds& within) {
  const double x = std::floor(place.x / tile.width), y = std::floor(place.y / tile.height);
  const bool is_inside = x >= static_cast<double>(within.x0) && x < static_cast<double>(within.x1) &&
                         y >= static_cast<double>(within.y0) && y < static_cast<double>(within.y1);
  if (!is_inside) return {};
  const auto cell_x = static_cast<std::int64_t>(x), cell_y = static_cast<std::int64_t>(y);
  return {cell_x, cell_y, cell_x + 1, cell_y + 1};
}

CellBounds bounds_of(const TiledChunks& chunks, const TiledMap& map, const TiledFrame* frame) {
  CellBounds all, kept;
  if (frame != nullptr)
    kept = {frame->x, frame->y, std::int64_t{frame->x} + frame->width,
            std::int64_t{frame->y} + frame->height};
  for (const auto& of_layer : chunks) {
    for (const TiledChunk& chunk : of_layer) {
      all.add({chunk.x, chunk.y, std::int64_t{chunk.x} + chunk.width, std::int64_t{chunk.y} + chunk.height});
      kept.add(bounds_of_tiles(chunk));
    }
  }
  if (kept.is_empty()) return {0, 0, map.width, map.height};
  for (const TiledLayer& layer : map.layers) {
    const Vec2 offset = shown_looks(map.groups, layer.looks).offset;
    for (const TiledObject& object : layer.objects)
      kept.add(cell_of(object.position + offset, map.tile_size, all));
  }
  return kept;
}

// Copies the cells of a chunk that are within the bounds, which are those of `cells`.
void put_chunk(const TiledChunk& chunk, const CellBounds& bounds, std::vector<std::uint32_t>& cells) {
  const std::int64_t from = std::max<std::int64_t>(bounds.x0, chunk.x);
  const std::int64_t to = std::min<std::int64_t>(bounds.x1, std::int64_t{chunk.x} + chunk.width);
  for (int row = 0; row < chunk.height && from < to; ++row) {
    const std::int64_t y = std::int64_t{chunk.y} + row;
    if (y < bounds.y0 || y >= bounds.y1) continue;
    const auto begin = chunk.cells.begin() + std::ptrdiff_t{row} * chunk.width;
    std::copy(begin + (from - chunk.x), begin + (to - chunk.x),
              cells.begin() + ((y - bounds.y0) * bounds.width() + from - bounds.x0));
  }
}

}  // namespace

bool has_tiles_off(const std::vector<TiledChunk>& chunks, const TiledMap& map) {
  return std::any_of(chunks.begin(), chunks.end(), [&](const TiledChunk& chunk) {
    const bool may_be = chunk.x < 0 || chunk.y < 0 || std::int64_t{chunk.x} + chunk.width > map.width ||
                        std::int64_t{chunk.y} + chunk.height > map.height;
    if (!may_be) return false;
    const CellBounds bounds = bounds_of_tiles(chunk);
    return bounds.x0 < 0 || bounds.y0 < 0 || bounds.x1 > map.width || bounds.y1 > map.height;
  });
}

std::vector<std::uint32_t> cells_of_chunks(std::vector<TiledChunk> chunks, const TiledMap& map) {
  const auto is_whole = [&](const TiledChunk& chunk) {
    return chunk.x == 0 && chunk.y == 0 && chunk.width == map.width && chunk.height == map.height;
  };
  if (chunks.size() == 1 && is_whole(chunks[0])) return std::move(chunks[0].cells);
  std::vector<std::uint32_t> cells(static_cast<std::size_t>(map.width) *
                                   static_cast<std::size_t>(map.height));
  for (const TiledChunk& chunk : chunks) put_chunk(chunk, {0, 0, map.width, map.height}, cells);
  return cells;
}

std::optional<std::string> join_chunks(TiledChunks chunks, const TiledFrame* frame, TiledMap& map) {
  const CellBounds bounds = bounds_of(chunks, map, frame);
  const std::string size = std::to_string(bounds.width()) + "x" + std::to_string(bounds.height());
  if (!is_terrain_size(bounds.width(), bounds.height(), map.tile_size)) {
    return "is an infinite map whose tiles are spread over " + size +
           " cells, but a level has at most 16777216 cells and 16777216 px a side";
  }
  const auto cell_count = static_cast<std::size_t>(bounds.width() * bounds.height());
  const auto layer_count = std::count_if(map.layers.begin(), map.layers.end(),
                                         [](const TiledLayer& layer) { return layer.has_tiles; });
  if (static_cast<std::size_t>(layer_count) * cell_count > kMaxTiledCells) {
    return "has " + std::to_string(layer_count) + " layers of " + size +
           " tiles, but all layers of a map may have at most " + std::to_string(kMaxTiledCells) +
           " cells together";
  }
  map.width = static_cast<int>(bounds.width());
  map.height = static_cast<int>(bounds.height());
  map.first = {static_cast<int>(bounds.x0), static_cast<int>(bounds.y0)};
  const Vec2 origin = {static_cast<double>(bounds.x0 * map.tile_size.width),
                       static_cast<double>(bounds.y0 * map.tile_size.height)};
  for (std::size_t i = 0; i < map.layers.size(); ++i) {
    TiledLayer& layer = map.layers[i];
    for (TiledObject& object : layer.objects) object.position = object.position - origin;
    if (layer.image) layer.looks.offset = layer.looks.offset - origin;
    if (!layer.has_tiles) continue;
    layer.cells.assign(cell_count, 0);
    for (const TiledChunk& chunk : chunks[i]) put_chunk(chunk, bounds, layer.cells);
    std::vector<TiledChunk>().swap(chunks[i]);
  }
  return std::nullopt;
}

}  // namespace talus
