// Pictures, and levels made from their colours. Seeds: tests/fuzz/seeds/*.png
#include "formats/pictures/png_sheet.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto picture = talus::read_png({reinterpret_cast<const char*>(data), size});
  if (!picture) {
    talus::require_clear(picture.error());
    return 0;
  }
  const talus::Palette palette = talus::default_palette();
  const auto taken = talus::palette_for(*picture, palette);
  const talus::MatchedPicture matched = talus::match_colors(*picture, taken.value_or(palette));
  talus::require(matched.indices.size() == picture->pixels.size());
  for (const auto index : matched.indices) talus::require(index < talus::kColorCount);
  if (taken) talus::require(matched.largest_distance == 0);
  return 0;
}
