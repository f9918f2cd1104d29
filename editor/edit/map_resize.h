// The map's size as an Edit.
#pragma once

#include "edit.h"
#include "level/resize.h"

namespace talus {

// Everything that resized() changes, and the selection with it. What is lost comes back with Undo.
Edit resize_map(const Level& level, const MapFrame& frame, std::optional<CellRect> selection);

}  // namespace talus
