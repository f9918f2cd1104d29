// Edits the list of brushes, and chooses the tiles of random painting.
#include "brush_tools.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "level/single_change.h"
#include "raster.h"

namespace talus {
namespace {

// Mixes all bits (the finalizer of MurmurHash3, by Austin Appleby), so that neighbouring cells get unrelated
// tiles.
std::uint32_t mixed(std::uint32_t bits) {
  bits = (bits ^ bits >> 16) * 0x85ebca6bu;
  bits = (bits ^ bits >> 13) * 0xc2b2ae35u;
  return bits ^ bits >> 16;
}

bool has_brush(const Level& level, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < level.brushes.size();
}

Edit with_brushes(const Level& level, std::string label, std::vector<Brush> brushes) {
  return single_change(std::move(label), BrushesChange{level.brushes, std::move(brushes)});
}

// Cuts a name to the allowed number of bytes, but never within a character.
std::string cut_name(std::string name) {
  if (name.size() <= kMaxBrushName) return name;
  std::size_t end = kMaxBrushName;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) --end;
  name.resize(end);
  return name;
}

}  // namespace

MapCell random_tile(const Stamp& stamp, Cell cell, std::uint32_t seed, const TileNotes& notes) {
  std::uint32_t bits = mixed(seed);
  bits = mixed(bits ^ static_cast<std::uint32_t>(cell.x));
  bits = mixed(bits ^ static_cast<std::uint32_t>(cell.y));
  const auto weight_of = [&](MapCell painted) { return note_of(notes, painted.tile).probability; };
  const bool is_even = notes.empty() || std::all_of(stamp.tiles.begin(), stamp.tiles.end(),
                                                    [&](MapCell painted) { return weight_of(painted) == 1; });
  double all = 0;
  for (const MapCell painted : stamp.tiles) all += is_even ? 0 : weight_of(painted);
  if (all > 0) {
    constexpr double kBits = 4294967296.0;  // 2^32
    double left = bits / kBits * all;
    for (const MapCell painted : stamp.tiles) {
      left -= weight_of(painted);
      if (left < 0) return painted;
    }
  }
  return stamp.tiles[static_cast<std::size_t>(std::uint64_t{bits} * stamp.tiles.size() >> 32)];
}

Edit paint_random_stroke(const Level& level, Cell from, Cell to, const Stamp& stamp, std::uint32_t seed,
                         Within within) {
  CellPainter painter(level.map, within);
  for_each_on_line(from, to,
                   [&](Cell cell) { painter.paint(cell, random_tile(stamp, cell, seed, level.tile_notes)); });
  return painter.finish("Paint random tiles");
}

Edit fill_rect_at_random(const Level& level, CellRect cells, const Stamp& stamp, std::uint32_t seed,
                         Within within) {
  CellPainter painter(level.map);
  const CellRect map{0, 0, level.map.width(), level.map.height()};
  const auto on_map = shared(cells, map);
  const auto part = on_map && within ? shared(*on_map, *within) : on_map;
  if (!part) return painter.finish("Fill rectangle at random");
  for (int y = part->y; y < part->y + part->h; ++y) {
    for (int x = part->x; x < part->x + part->w; ++x)
      painter.paint({x, y}, random_tile(stamp, {x, y}, seed, level.tile_notes));
  }
  return painter.finish("Fill rectangle at random");
}

Stamp stamp_of_brush(const Brush& brush) { return {brush.w, brush.h, brush.tiles}; }

Brush brush_of_stamp(const Stamp& stamp, std::string name, bool random) {
  Brush brush{cut_name(std::move(name)),
              std::min(stamp.w, kMaxBrushSide),
              std::min(stamp.h, kMaxBrushSide),
              {},
              random,
              {}};
  for (int y = 0; y < brush.h; ++y) {
    for (int x = 0; x < brush.w; ++x) brush.tiles.push_back(stamp.at(x, y));
  }
  return brush;
}

Edit add_brush(const Level& level, Brush brush) {
  std::vector<Brush> brushes = level.brushes;
  if (brushes.size() < kMaxBrushes) brushes.push_back(std::move(brush));
  return with_brushes(level, "Add brush", std::move(brushes));
}

Edit rename_brush(const Level& level, int index, std::string name) {
  std::vector<Brush> brushes = level.brushes;
  if (has_brush(level, index)) brushes[static_cast<std::size_t>(index)].name = cut_name(std::move(name));
  return with_brushes(level, "Rename brush", std::move(brushes));
}

Edit remove_brush(const Level& level, int index) {
  std::vector<Brush> brushes = level.brushes;
  if (has_brush(level, index)) brushes.erase(brushes.begin() + index);
  return with_brushes(level, "Delete brush", std::move(brushes));
}

std::string free_brush_name(const Level& level) {
  for (std::size_t number = level.brushes.size() + 1;; ++number) {
    std::string name = "Brush " + std::to_string(number);
    const bool taken = std::any_of(level.brushes.begin(), level.brushes.end(),
                                   [&](const Brush& brush) { return brush.name == name; });
    if (!taken) return name;
  }
}

}  // namespace talus
