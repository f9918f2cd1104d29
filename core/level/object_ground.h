// The ground that objects of a level make.
#pragma once

#include <optional>
#include <string>

#include <talus/level/level.h>

namespace talus {

// Whether a layer of objects is ground, and has any.
bool has_object_ground(const Level& level);

// The level with its ground of objects as one more layer of tiles, which is not drawn, and as curves; its
// layers of objects are gone. Areas are cut into cells, whose tiles come behind those of the level: the first
// is empty, the others have a shape each. Polylines, and the upper sides of one-way areas, become curves. A
// level whose objects are more than its ground can hold has no ground at all: problem, unless null, gets a
// sentence about that, without its subject. The picture of the tiles stays if keep_picture.
Level with_object_tiles(const Level& level, bool keep_picture = false,
                        std::optional<std::string>* problem = nullptr);

}  // namespace talus
