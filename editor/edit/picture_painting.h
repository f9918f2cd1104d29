// Edits of tiles whose pixels come from pictures in files: which files they paint, and what of them the files
// can hold.
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "level/edit.h"
#include "level/picture_tiles.h"

namespace talus {

// Whether an edit paints tiles, and not sprites alone.
bool paints_tiles(const Edit& edit);

// The paths of the files that an edit paints, each once. The error is a sentence on a tile that shows no part
// of a file that could be painted.
tl::expected<std::vector<std::string>, std::string> files_painted(const PictureTiles& pictures,
                                                                  const Edit& edit);

// The edit without pixels that no picture has a place for. Other tiles in true colour that show the same part
// of a picture are painted, too. An opaque pixel with the colour that its file does not draw gets a like one.
Edit fitted_to_pictures(const Level& level, const PictureTiles& pictures, const Edit& edit);

}  // namespace talus
