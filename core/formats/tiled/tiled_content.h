// TiledContent: what the files of a map hold, before it becomes a level.
#pragma once

#include <span>
#include <string_view>

#include <talus/formats/format.h>
#include "tiled_tiles.h"

namespace talus {

struct TiledContent {
  TiledMap map;
  TiledPictures pictures;
};

// As read_tiled_again().
FormatResult<TiledContent> read_tiled_content(std::string_view bytes, const FormatContext& context,
                                              std::span<const TiledOrigin::File> tilesets);

}  // namespace talus
