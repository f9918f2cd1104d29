// The whole map as a PNG picture.
#pragma once

#include <talus/formats/format.h>
#include <talus/level/progress.h>

namespace talus {

inline constexpr int kMaxPictureSide = 262'144;                        // px
inline constexpr std::int64_t kMaxPicture = std::int64_t{1} << 31;     // px in all, such as 46,340x46,340
inline constexpr std::size_t kMaxPictureBytes = std::size_t{1} << 30;  // of the file
inline constexpr std::int64_t kMaxPictureInside = 1 << 25;  // px in all of a picture within another file

// One pixel for each px: all visible layers. Where nothing is, it is clear, as Tiled has it, or has colour 0
// in a level without a background of its own. It is painted and packed in strips. A map larger than the
// limits, or of more than `most` px, is an error.
FormatResult<std::string> map_png(const Level& level, const Progress& progress = {},
                                  std::int64_t most = kMaxPicture);

}  // namespace talus
