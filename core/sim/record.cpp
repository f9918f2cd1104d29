#include <talus/sim/record.h>

namespace talus {

std::string_view word_of(StepEvent::Kind kind) {
  constexpr std::string_view kWords[] = {"hit", "landed", "left"};
  return kWords[static_cast<std::size_t>(kind)];
}

void StepRecord::clear() {
  paths.clear();
  contacts.clear();
  tested.clear();
  events.clear();
  work = 0;
}

}  // namespace talus
