// One line, written over itself.
#include "progress_line.h"

#include <unistd.h>

#include <iostream>
#include <utility>

namespace talus {
namespace {

constexpr auto kBetweenLines = std::chrono::milliseconds(100);
constexpr const char* kToLineStart = "\r\x1b[K";  // and wipes the line

sigset_t end_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

}  // namespace

ProgressLine::ProgressLine(std::ostream& stream, std::string label, bool shows, Clock::duration after)
    : stream_(stream), label_(std::move(label)), shows_(shows), next_(Clock::now() + after) {
  const sigset_t signals = end_signals();
  pthread_sigmask(SIG_BLOCK, &signals, &before_);
}

ProgressLine::~ProgressLine() {
  wipe();
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool ProgressLine::at(double share) {
  const Clock::time_point now = Clock::now();
  if (shows_ && now >= next_) {
    stream_ << kToLineStart << label_ << ": " << static_cast<int>(share * 100) << " %" << std::flush;
    is_shown_ = true;
    next_ = now + kBetweenLines;
  }
  sigset_t waiting;
  sigpending(&waiting);
  return sigismember(&waiting, SIGINT) == 0 && sigismember(&waiting, SIGTERM) == 0;
}

void ProgressLine::wipe() {
  if (is_shown_) stream_ << kToLineStart << std::flush;
  is_shown_ = false;
}

bool is_terminal(const std::ostream& stream) { return &stream == &std::cerr && isatty(STDERR_FILENO) != 0; }

}  // namespace talus
