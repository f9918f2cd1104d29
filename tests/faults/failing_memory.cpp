#include "failing_memory.h"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

namespace talus {
namespace failing_memory {

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();
inline std::atomic<std::size_t> least_failing = kNone;  // bytes
inline thread_local std::size_t made = 0;
inline thread_local bool is_spared = false;

// Returns null if there is not enough memory.
void* allocated(std::size_t size) {
  ++made;
  if (size >= least_failing && !is_spared) return nullptr;
  return std::malloc(size);
}

}  // namespace failing_memory

FailingMemory::FailingMemory(std::size_t bytes, Where where) {
  failing_memory::is_spared = where == Where::on_other_threads;
  failing_memory::least_failing = bytes;
}

FailingMemory::~FailingMemory() {
  failing_memory::least_failing = failing_memory::kNone;
  failing_memory::is_spared = false;
}

std::size_t allocations_made() { return failing_memory::made; }

}  // namespace talus

// Not inlined: a compiler that sees only one of the pair warns of a mismatch.
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* memory = talus::failing_memory::allocated(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return talus::failing_memory::allocated(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
