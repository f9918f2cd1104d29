// The pictures in files of their own whose tiles were painted.
#pragma once

#include <string>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

// Returns the pictures whose tiles look otherwise than in `before`, with the pixels that differ. before: the
// level as its files had it. Errors name the file.
FormatResult<std::vector<WrittenFile>> painted_pictures(const Level& level, const Level& before);

// The level with the looks that these tiles have in `before`, where they come from files.
Level without_painted_tiles(Level level, const Level& before);

}  // namespace talus
