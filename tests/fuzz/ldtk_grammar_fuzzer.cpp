// Projects of LDtk, made by their grammar from the fuzzer's bytes: see grammar.h.
#include "document_checks.h"
#include "grammar.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const talus::Grammar grammar = talus::grammar_of_seed("small.ldtk");
  talus::RandomBytes choices({reinterpret_cast<const char*>(data), size});
  talus::require(talus::check_ldtk(grammar.document(choices)));
  return 0;
}
