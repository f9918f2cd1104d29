// Native levels. Seeds: tests/fuzz/seeds/*.talus.json
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto level = talus::find_format("native")->read(bytes, {});
  if (!level) {
    talus::require_clear(level.error());
    return 0;
  }
  const talus::Format& native = *talus::find_format("native");
  const auto written = native.write(*level, {});
  talus::require(written.has_value());
  const auto again = native.read(written->bytes, {});
  talus::require(again.has_value());
  talus::require(native.write(*again, {})->bytes == written->bytes);
  return 0;
}
