// Cartridges. Seeds: tests/golden/carts/*.tic
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  talus::require_cart_round_trip(*talus::find_format("tic"), {reinterpret_cast<const char*>(data), size},
                                 {"tic"});
  return 0;
}
