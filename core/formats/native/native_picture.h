// The picture of the tiles in a native level: "picture", lines of Base64, together a PNG.
#pragma once

#include <memory>

#include <talus/level/tileset.h>
#include "../text/json_text.h"

namespace talus {

// Reads the lines. width, height: px that the picture must have, with `layout` for the message; another size
// is an error, as is one beyond the limits of a sheet's picture.
FormatResult<std::shared_ptr<const SheetPicture>> take_picture(const Json& lines, const SheetLayout& layout,
                                                               int width, int height);

FormatResult<Json> json_of(const SheetPicture& picture);

}  // namespace talus
