// Recordings. Seeds: tests/fuzz/seeds/*.talusrec
#include "document_checks.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  talus::require(talus::check_recording({reinterpret_cast<const char*>(data), size}));
  return 0;
}
