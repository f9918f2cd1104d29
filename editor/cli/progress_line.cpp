#include "progress_line.h"

#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <iostream>

#include "formats/text/utf8_text.h"

namespace talus {
namespace {

using Clock = ProgressLine::Clock;

constexpr const char* kToLineStart = "\r\x1b[K";             // and wipes the line
constexpr Clock::duration kPlain = std::chrono::minutes(1);  // between lines that stay

// Nothing as long as the share says too little.
std::string time_left(Clock::duration gone, double share) {
  if (gone < std::chrono::seconds(10) || !(share > 0)) return "";
  const double seconds = std::chrono::duration<double>(gone).count() * (1 - share) / share;
  const bool in_minutes = seconds >= 90;
  const double number = std::ceil(in_minutes ? seconds / 60 : seconds);
  return ", about " + std::to_string(static_cast<std::int64_t>(number)) + (in_minutes ? " min" : " s") +
         " left";
}

}  // namespace

ProgressLine::ProgressLine(std::ostream& stream, const std::string& label, bool is_terminal,
                           Clock::duration after, Clock::duration between)
    : stream_(stream),
      label_(printable(label)),
      is_terminal_(is_terminal),
      start_(Clock::now()),
      next_(start_ + (is_terminal ? after : kPlain)),
      between_(is_terminal ? between : kPlain) {}

ProgressLine::~ProgressLine() { wipe(); }

bool ProgressLine::at(double share) {
  const Clock::time_point now = Clock::now();
  if (now >= next_) {
    stream_ << (is_terminal_ ? kToLineStart : "") << label_ << ": " << static_cast<int>(share * 100) << " %"
            << time_left(now - start_, share) << (is_terminal_ ? "" : "\n") << std::flush;
    is_shown_ = is_terminal_;
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
