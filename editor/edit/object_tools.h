// Edits of the layers of objects.
#pragma once

#include <string>

#include "level/edit.h"

namespace talus {

// layer, here and below: an index in Level::objects. Each edit is empty if there is no such layer, or if it
// changes nothing.

// Makes areas and lines of the layer ground, or no ground.
Edit set_object_ground(const Level& level, int layer, bool is_ground);
// Shows or hides it.
Edit set_object_visible(const Level& level, int layer, bool visible);

// The name of a layer of objects for people, and how many it has: "walls, 12 objects".
std::string object_layer_text(const Level& level, int layer);

}  // namespace talus
