// Memory of the window, where nobody looks at it.
#include <unistd.h>

#include <fstream>

#include "harness.h"

namespace talus::memory_test {

constexpr std::size_t kMiB = std::size_t{1} << 20;

// Bytes of this process in memory.
std::size_t resident() {
  std::size_t all = 0, here = 0;
  std::ifstream("/proc/self/statm") >> all >> here;
  return here * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

// The driver may hold back what it has to draw as long as nothing waits for it.
TEST(UiMemory, StaysFlatWhereSdlHasNoScreen) {
  ::setenv("SDL_VIDEODRIVER", "offscreen", 1);
  AppOptions options;
  options.width = 1280;
  options.height = 720;
  options.remember = false;
  double clock = 0;
  options.clock = [&clock] { return clock; };
  auto app = App::start(std::move(options));
  ::unsetenv("SDL_VIDEODRIVER");
  ASSERT_TRUE(app) << app.error();
  const auto frames = [&](int count) {
    for (int i = 0; i < count; ++i) {
      clock += 1.0 / 60;
      (*app)->frame();
    }
  };
  frames(20);
  const std::size_t before = resident();
  frames(60);
  EXPECT_LT(resident(), before + 16 * kMiB);
}

}  // namespace talus::memory_test
