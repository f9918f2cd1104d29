// The memory of the window while nobody can see it.
#include <unistd.h>

#include <fstream>

#include "harness.h"

#ifdef __has_feature
#if __has_feature(address_sanitizer)
#define TALUS_ADDRESS_SANITIZER
#include <sanitizer/allocator_interface.h>
#endif
#endif

namespace talus::memory_test {

constexpr std::size_t kMiB = std::size_t{1} << 20;

// Bytes that this process uses. AddressSanitizer keeps freed memory, but counts the rest.
std::size_t memory_in_use() {
#ifdef TALUS_ADDRESS_SANITIZER
  return __sanitizer_get_current_allocated_bytes();
#else
  std::size_t all = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return resident * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
#endif
}

// A driver may queue frames as long as nothing waits for them.
TEST(UiMemory, StaysConstantWithoutAScreen) {
  const EnvironmentVariable driver("SDL_VIDEODRIVER", "offscreen");
  AppOptions options;
  options.width = 1280;
  options.height = 720;
  options.remember = false;
  double clock = 0;
  options.clock = [&clock] { return clock; };
  auto app = App::start(std::move(options));
  ASSERT_TRUE(app) << app.error();
  const auto frames = [&](int count) {
    for (int i = 0; i < count; ++i) {
      clock += 1.0 / 60;
      (*app)->frame();
    }
  };
  frames(10);
  const std::size_t before = memory_in_use();
  frames(40);
  EXPECT_LT(memory_in_use(), before + 16 * kMiB);
}

}  // namespace talus::memory_test
