// How a map of Tiled was numbered, as JSON: "frame" of companions, see companion.h.
#pragma once

#include <optional>

#include <talus/level/level.h>
#include "../text/json_text.h"

namespace talus {

Json json_of_tiled_frame(const TiledFrame& frame);
// The same read again; nothing if it is not what json_of_tiled_frame() gives.
std::optional<TiledFrame> tiled_frame_of_json(const Json& json);

}  // namespace talus
