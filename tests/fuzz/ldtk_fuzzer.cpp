// Projects of LDtk, without the files beside them. Seeds: tests/fuzz/seeds/*.ldtk
#include "document_checks.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  talus::require(talus::check_ldtk({reinterpret_cast<const char*>(data), size}));
  return 0;
}
