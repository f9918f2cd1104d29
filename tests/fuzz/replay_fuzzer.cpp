// Collision scenarios. Seeds: tests/fuzz/seeds/*.scenario.json
#include "formats/replay.h"
#include "round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  const auto answers = talus::replay_scenario({reinterpret_cast<const char*>(data), size});
  if (!answers) {
    talus::require_clear(answers.error());
    return 0;
  }
  for (const std::string& answer : *answers) talus::require(answer.find('\n') == std::string::npos);
  return 0;
}
