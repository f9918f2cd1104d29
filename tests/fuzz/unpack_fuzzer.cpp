// Streams of zlib, gzip and zstd. Seeds: tests/fuzz/seeds/*.zlib, *.zst
#include "formats/text/unpack.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  constexpr std::size_t kMax = std::size_t{1} << 16;  // bytes
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const auto& content : {talus::unpack_zlib(bytes, kMax), talus::unpack_zstd(bytes, kMax)}) {
    if (!content) {
      talus::require(content.error().is_too_large || !content.error().reason.empty());
      continue;
    }
    talus::require(content->size() <= kMax);
    talus::require(talus::unpack_zlib(talus::pack_zlib(*content), kMax).value_or("") == *content);
    talus::require(talus::unpack_zstd(talus::pack_zstd(*content), kMax).value_or("") == *content);
  }
  return 0;
}
