// FailingMemory: lets large allocations fail, as where there is not enough memory; and counts all of them. It
// stands in for operator new in the whole program that it is linked into, so that nothing of what is tested
// knows about it.
#pragma once

#include <cstddef>

namespace talus {

class FailingMemory {
 public:
  enum class Where { everywhere, on_other_threads };

  // From now on, allocations of that many bytes and more fail. One at a time.
  explicit FailingMemory(std::size_t bytes, Where where = Where::everywhere);
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;
};

// That this thread has made so far.
std::size_t allocations_made();

}  // namespace talus
