// Waiting for what a thread or another process does.
#pragma once

#include <chrono>
#include <functional>
#include <thread>

namespace talus {

// Waits until is_so(), however busy the machine is. Returns false after ten minutes: then something hangs.
inline bool comes_true(const std::function<bool()>& is_so) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(10);
  while (!is_so()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

// Lets the exports and previews of a Session end. Returns false if they hang.
bool exports_end(auto& session) {
  return comes_true([&] {
    if (session.exporting().is_busy()) session.advance(0);
    return !session.exporting().is_busy();
  });
}

}  // namespace talus
