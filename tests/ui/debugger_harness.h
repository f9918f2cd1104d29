// DebuggerTest: the editor with the level of a test, and helpers for its timeline.
#pragma once

#include "harness.h"

namespace talus {

class DebuggerTest : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  void play(int steps) {
    for (int i = 0; i < steps; ++i) key(kKeyF10);
  }
  std::int64_t frame() { return session().state().frame; }
  const Timeline& timeline() { return session().timeline(); }
};

}  // namespace talus
