// Maps and tilesets of Tiled in JSON, made by their grammar from the fuzzer's bytes: see grammar.h.
#include <array>

#include "document_checks.h"
#include "grammar.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const std::array grammars = {talus::grammar_of_seed("small.tmj"),
                                      talus::grammar_of_seed("infinite.tmj"),
                                      talus::grammar_of_seed("old.tmj"), talus::grammar_of_seed("small.tsj")};
  const talus::Grammar& grammar = grammars[size > 0 ? data[0] % grammars.size() : 0];
  talus::RandomBytes choices({reinterpret_cast<const char*>(data), size});
  talus::require(talus::check_tiled(grammar.document(choices)));
  return 0;
}
