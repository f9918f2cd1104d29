#include <talus/sim/record.h>

namespace talus {

void StepRecord::clear() {
  paths.clear();
  contacts.clear();
  tested.clear();
  work = 0;
}

}  // namespace talus
