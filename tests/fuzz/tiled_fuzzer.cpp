// Maps and tilesets of Tiled, without the files beside them. Seeds: tests/fuzz/seeds/*.tmj, *.tmx, *.tsx
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const talus::Format& format = *talus::find_format("tmj");  // which reads XML too
  for (const bool used_tiles : {false, true}) {
    std::vector<std::string> dropped;
    talus::FormatContext context{"tmj"};
    context.choices.used_tiles = used_tiles;
    context.dropped = &dropped;
    const auto level = format.read(bytes, context);
    if (!level) {
      talus::require_clear(level.error());
      continue;
    }
    talus::require_native_round_trip(*level);
  }
  return 0;
}
