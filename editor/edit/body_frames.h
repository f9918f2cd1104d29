// The size and the picture of a body placed by hand.
#pragma once

#include <string>

#include <talus/level/level.h>
#include <tl/expected.hpp>

#include "sprite_area.h"

namespace talus {

// The body with a box of another size, 1 px to kMaxBodySize a side. The middle of its bottom stays: there it
// stands.
Spawn with_size(Spawn spawn, Vec2 size);

// Whether all of these images are blank: a body with them could not be seen.
bool shows_nothing(const Level& level, const SpriteArea& area);

// The picture of a body whose act has these images of a sheet, cut into frames from the left to the right.
// The first act that gets frames says how large a frame is, and on which sheet all are: as high as the
// images, and as wide as the body if that is as high, else as wide as high. An error, one sentence, if the
// images do not fit to the frames that it has, or are of the other sheet.
tl::expected<BodyPicture, std::string> with_frames(const Level& level, const Spawn& spawn, BodyAct act,
                                                   const SpriteArea& area);

// The picture with frames of so many columns, 1 to kMaxBodyPictureSide: each act has as many of them as its
// tiles hold, at least one.
BodyPicture with_columns(BodyPicture picture, int columns);

}  // namespace talus
