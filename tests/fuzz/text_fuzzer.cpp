// Text projects; the first byte chooses the comment prefix. Seeds: tests/fuzz/seeds/*.text
#include <array>

#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  if (size == 0) return 0;
  constexpr std::array<const char*, 5> kExtensions = {"lua", "js", "fnl", "py", ""};
  const talus::FormatContext context = {kExtensions[data[0] % kExtensions.size()]};
  const std::string_view bytes(reinterpret_cast<const char*>(data + 1), size - 1);
  talus::require_cart_round_trip(*talus::find_format("tic-text"), bytes, context);
  return 0;
}
