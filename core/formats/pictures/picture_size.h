// How large a picture may be.
#pragma once

#include "png_picture.h"

namespace talus {

// Returns why a picture of `size`, in px, is refused, as an error: one without pixels, and one of more than
// most_side px a side or kMaxSheetPicturePixels in all.
FormatResult<void> check_picture_size(TileSize size, int most_side);

}  // namespace talus
