// Recorded input, made by their grammar from the fuzzer's bytes: see grammar.h.
#include "document_checks.h"
#include "grammar.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const talus::Grammar grammar = talus::grammar_of_seed("keys.jsonl");
  talus::RandomBytes choices({reinterpret_cast<const char*>(data), size});
  talus::require(talus::check_input(grammar.lines(choices)));
  return 0;
}
