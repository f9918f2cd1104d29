// Changes single pixels of a PNG, and leaves all else of the file as it is.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <talus/collision/geometry.h>
#include <talus/formats/format.h>

namespace talus {

struct PngPixel {
  Cell at;                                // px; outside of the picture it is left out
  std::array<std::uint8_t, 4> rgba = {};  // red, green, blue, opacity
};

// How a picture stores its colours, as far as that matters for painting.
enum class PngKind {
  rgb,      // 8 bits a channel, opaque
  rgba,     // 8 bits a channel, with opacity
  palette,  // a palette, or greys: it becomes rgba
  deep,     // 16 bits a channel, which painting would lose
  other     // no PNG, or a damaged one
};
// start: at least the first kPngKindBytes of a file, if it has so many.
inline constexpr std::size_t kPngKindBytes = 26;
PngKind kind_of_png(std::string_view start);

// Returns the file with these pixels. Pixels beside them keep their colours and opacities, and so do the
// file's notes, such as its gamma. If all pixels have these colours already, the file stays as it is. A
// picture in rgb stays so if all pixels are opaque. `deep` and `other` are errors.
FormatResult<std::string> patch_png(std::string_view bytes, const std::vector<PngPixel>& pixels);

}  // namespace talus
