// PNG carts. Seeds: tests/fuzz/seeds/cart_*.png
#include "formats/tic80/tic_png.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto level = talus::read_tic_png({reinterpret_cast<const char*>(data), size}, {"png"});
  if (!level) {
    talus::require_clear(level.error());
    return 0;
  }
  talus::require_native_round_trip(*level);
  return 0;
}
