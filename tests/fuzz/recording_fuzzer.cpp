// Recordings. Seeds: tests/fuzz/seeds/*.talusrec
#include "formats/recording.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const auto recording = talus::read_recording(bytes);
  if (!recording) {
    talus::require_clear(recording.error());
    return 0;
  }
  const auto written = talus::write_recording(*recording);
  talus::require(written.has_value());
  const auto again = talus::read_recording(*written);
  talus::require(again.has_value());
  talus::require(*talus::write_recording(*again) == *written);
  return 0;
}
