// FailingMemory lets large allocations fail, as if there were too little memory, and counts all allocations.
// It replaces operator new in the whole program that it is linked into, so that the tested code knows nothing
// of it.
#pragma once

#include <cstddef>

namespace talus {

class FailingMemory {
 public:
  enum class Where { everywhere, on_other_threads };

  // Lets allocations of at least `bytes` bytes fail from now on. Only one object may exist at a time.
  explicit FailingMemory(std::size_t bytes, Where where = Where::everywhere);
  ~FailingMemory();
  FailingMemory(const FailingMemory&) = delete;
  FailingMemory& operator=(const FailingMemory&) = delete;
};

// The number of allocations that this thread has made so far.
std::size_t allocations_made();

}  // namespace talus
