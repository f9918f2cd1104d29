// Maps and tilesets of Tiled in XML, made by their grammar from the fuzzer's bytes: see grammar.h.
#include <array>

#include "document_checks.h"
#include "grammar.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const std::array grammars = {
      talus::grammar_of_seed("small.tmx"), talus::grammar_of_seed("infinite.tmx"),
      talus::grammar_of_seed("sets.tmx"), talus::grammar_of_seed("small.tsx")};
  const talus::Grammar& grammar = grammars[size > 0 ? data[0] % grammars.size() : 0];
  talus::RandomBytes choices({reinterpret_cast<const char*>(data), size});
  talus::require(talus::check_tiled(grammar.document(choices)));
  return 0;
}
