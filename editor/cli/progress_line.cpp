// One line that is overwritten again and again.
#include "progress_line.h"

#include <unistd.h>

#include <iostream>

#include "formats/text/utf8_text.h"

namespace talus {
namespace {

constexpr const char* kToLineStart = "\r\x1b[K";  // and wipes the line

}  // namespace

ProgressLine::ProgressLine(std::ostream& stream, const std::string& label, bool shows, Clock::duration after,
                           Clock::duration between)
    : stream_(stream),
      label_(printable(label)),
      shows_(shows),
      next_(Clock::now() + after),
      between_(between) {}

ProgressLine::~ProgressLine() { wipe(); }

bool ProgressLine::at(double share) {
  const Clock::time_point now = Clock::now();
  if (shows_ && now >= next_) {
    stream_ << kToLineStart << label_ << ": " << static_cast<int>(share * 100) << " %" << std::flush;
    is_shown_ = true;
    next_ = now + between_;
  }
  return !signals_.have_come();
}

void ProgressLine::wipe() {
  if (is_shown_) stream_ << kToLineStart << std::flush;
  is_shown_ = false;
}

bool is_terminal(const std::ostream& stream) { return &stream == &std::cerr && isatty(STDERR_FILENO) != 0; }

}  // namespace talus
