// Animations of tiles as JSON: by tile number, a list of frames [tile, ms].
#pragma once

#include <talus/level/tile_animation.h>

#include "../text/json_text.h"

namespace talus {

FormatResult<TileAnimations> take_animations(const Json& json, int tile_count);
// An empty object if there are none.
FormatResult<Json> json_of(const TileAnimations& animations, int tile_count);

}  // namespace talus
