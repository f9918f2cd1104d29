// The whole map as a PNG picture.
#pragma once

#include <talus/formats/format.h>
#include <talus/level/progress.h>

namespace talus {

// Encoding takes ten bytes of memory for each pixel; the limit keeps it to a third of a gigabyte.
inline constexpr int kMaxPictureSide = 16384;         // px
inline constexpr std::int64_t kMaxPicture = 1 << 25;  // px in all, such as 8192x4096

// One pixel for each px: all visible layers over colour 0. A map larger than the limits is an error.
FormatResult<std::string> map_png(const Level& level, const Progress& progress = {});

}  // namespace talus
