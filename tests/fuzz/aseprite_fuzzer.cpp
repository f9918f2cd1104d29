// Pictures of Aseprite.
#include "formats/pictures/aseprite_picture.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr int kMaxSide = 256;  // px
  const auto picture = talus::read_aseprite({reinterpret_cast<const char*>(data), size}, kMaxSide);
  if (!picture) talus::require_clear(picture.error());
  return 0;
}
