// Recorded input, a JSON object on each line. Seeds: tests/fuzz/seeds/*.jsonl
#include "document_checks.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  talus::require(talus::check_input({reinterpret_cast<const char*>(data), size}));
  return 0;
}
