// Most edits change neither layers nor sizes: only the tiles that they put on the map are looked at.
#include "file_limits.h"

#include <algorithm>
#include <utility>
#include <variant>

namespace talus {
namespace {

bool may_change_map(const Level& level, const Change& change) {
  if (const auto* map = std::get_if<MapChange>(&change)) {
    return map->after.width() != level.map.width() || map->after.height() != level.map.height() ||
           !(map->after.tile_size() == level.map.tile_size());
  }
  return std::holds_alternative<LayersChange>(change) || std::holds_alternative<LevelChange>(change);
}

std::optional<FormatError> tile_beyond(const Change& change, const TiledFrame& frame) {
  if (const auto* cell = std::get_if<CellChange>(&change)) return tile_beyond_tiled(cell->after.tile, frame);
  if (const auto* map = std::get_if<MapChange>(&change)) return cells_beyond_tiled(map->after.cells(), frame);
  return std::nullopt;
}

}  // namespace

std::vector<BeyondTiled> beyond_tiled_after(const Level& level, const Edit& edit) {
  if (!level.tiled) return {};
  const bool is_large = std::any_of(edit.changes.begin(), edit.changes.end(),
                                    [&](const Change& change) { return may_change_map(level, change); });
  if (is_large) {
    Edit fitted = edit;
    rebase_edit(level, fitted);
    if (problem_after(level, fitted)) return {};  // it is not made
    Level after = level;
    apply_edit(after, fitted);
    after.tiled = level.tiled;
    return beyond_tiled(after);
  }
  for (const Change& change : edit.changes) {
    if (auto beyond = tile_beyond(change, level.tiled->frame))
      return {{TiledLimit::tiles, *std::move(beyond)}};
  }
  return {};
}

}  // namespace talus
