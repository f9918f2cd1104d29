// Native levels. Seeds: tests/fuzz/seeds/*.talus.json
#include "document_checks.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  talus::require(talus::check_native({reinterpret_cast<const char*>(data), size}));
  return 0;
}
