// Pictures of large tiles, of objects and of layers in a native level (see native.h): a list of pictures,
// of which the others name parts.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <talus/level/level.h>
#include "../text/json_text.h"
#include "native_members.h"

namespace talus {

using NativePictures = std::vector<std::shared_ptr<const SheetPicture>>;  // in the order of the list

// The pictures of a level, each once.
NativePictures pictures_of(const Level& level);

FormatResult<NativePictures> take_pictures(Json& list);
FormatResult<Json> json_of(const NativePictures& pictures);

// The members of a part: "picture", its number in the list, "rect", and how it is drawn.
void take_part(MemberTaker& take, const NativePictures& pictures, PicturePart& part);
// The part must be valid, and its picture in the list (asserted).
void put_part(const PicturePart& part, const NativePictures& pictures, Json& json);

FormatResult<LargeTiles> take_large_tiles(Json& json, const NativePictures& pictures, int tile_count);
FormatResult<Json> json_of(const LargeTiles& tiles, const NativePictures& pictures);

}  // namespace talus
