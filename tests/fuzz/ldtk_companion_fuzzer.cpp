// What goes with a project of LDtk. Seeds: tests/fuzz/seeds/*.ldtkc
#include "document_checks.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  talus::require(talus::check_ldtk_companion({reinterpret_cast<const char*>(data), size}));
  return 0;
}
