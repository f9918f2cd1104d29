// Companions of a small cart. Seeds: tests/fuzz/seeds/*.companion
#include "formats/native/companion.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const talus::Format& format = *talus::find_format("tic");
  talus::Level drawn;
  drawn.map.set({2, 3}, 4);
  const auto cart = format.write(drawn, {});
  const auto held = format.read(cart->bytes, {});
  const auto joined = talus::join_companion(bytes, *held, format, "game.tic");
  if (!joined) {
    talus::require_clear(joined.error());
    return 0;
  }
  talus::require(joined->note.find('\n') == std::string::npos);
  const auto written = format.write(joined->level, {});
  if (!written) {  // no cart holds this map
    talus::require_clear(written.error());
    return 0;
  }
  const auto held_now = format.read(written->bytes, {});
  talus::require(held_now.has_value());
  const auto companion = talus::write_companion(joined->level, *held_now, format, "game.tic", true);
  talus::require(companion.has_value());
  auto again = talus::join_companion(*companion, *held_now, format, "game.tic");
  talus::require(again && again->note.empty());
  again->level.cart = joined->level.cart;
  talus::require(again->level == joined->level);
  return 0;
}
