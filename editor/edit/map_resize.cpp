// Resizes and shifts the map.
#include "map_resize.h"

#include <utility>

namespace talus {

Edit resize_map(const Level& level, const MapFrame& frame, std::optional<CellRect> selection) {
  ResizedMap result = resized(level, frame);
  const bool same_size = frame.width == level.map.width() && frame.height == level.map.height();
  Edit edit{same_size ? "Shift map" : "Resize map", {}};
  if (result.layers != level.layers)
    edit.changes.emplace_back(LayersChange{level.layers, std::move(result.layers)});
  if (!(result.map == level.map)) edit.changes.emplace_back(MapChange{level.map, std::move(result.map)});
  if (result.spawns != level.spawns)
    edit.changes.emplace_back(SpawnsChange{level.spawns, std::move(result.spawns)});
  if (result.curves != level.curves)
    edit.changes.emplace_back(CurvesChange{level.curves, std::move(result.curves)});
  if (result.objects != level.objects)
    edit.changes.emplace_back(ObjectsChange{level.objects, std::move(result.objects)});
  if (selection) {
    CellRect there = *selection;
    there.x += frame.shift.x;
    there.y += frame.shift.y;
    edit.selection = SelectionChange{selection, shared(there, {0, 0, frame.width, frame.height}), {}};
  }
  return edit;
}

}  // namespace talus
