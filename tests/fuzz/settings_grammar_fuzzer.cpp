// The editor's settings, made by their grammar from the fuzzer's bytes: see grammar.h.
#include "document_checks.h"
#include "grammar.h"
#include "platform/settings.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const talus::Grammar grammar = talus::grammar_of_seed("settings.json");
  talus::RandomBytes choices({reinterpret_cast<const char*>(data), size});
  const auto settings = talus::settings_of_text(grammar.document(choices));
  if (!settings) talus::require(talus::checked_error(settings.error()));
  return 0;
}
