// The size of the map as an Edit.
#pragma once

#include "level/edit.h"
#include "level/resize.h"

namespace talus {

// Changes all that resized() changes, and the selection. Undo brings back what is lost.
Edit resize_map(const Level& level, const MapFrame& frame, std::optional<CellRect> selection);

}  // namespace talus
