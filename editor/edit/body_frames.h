// The size and the picture of a body placed by hand.
#pragma once

#include <string>

#include <talus/level/level.h>
#include <tl/expected.hpp>

namespace talus {

// The body with a box of another size, 1 px to kMaxBodySize a side. The middle of its bottom stays: there it
// stands.
Spawn with_size(Spawn spawn, Vec2 size);

// The picture of a body whose act has these tiles of the sheet, cut into frames from the left to the right.
// The first act that gets frames says how large a frame is: as high as the tiles, and as wide as the body if
// that is as high, else as wide as high. An error, one sentence, if the tiles do not fit to the frames that
// it has.
tl::expected<BodyPicture, std::string> with_frames(const Level& level, const Spawn& spawn, BodyAct act,
                                                   CellRect tiles);

// The picture with frames of so many columns, 1 to kMaxBodyPictureSide: each act has as many of them as its
// tiles hold, at least one.
BodyPicture with_columns(BodyPicture picture, int columns);

}  // namespace talus
