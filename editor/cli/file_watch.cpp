// Polling: it sees what is saved by renaming, on any file system.
#include "file_watch.h"

#include <csignal>
#include <ctime>
#include <optional>

#include "session/file_stamp.h"

namespace talus {
namespace {

constexpr long kPollNs = 200'000'000;  // between looks at the file, and how long it must be at rest

// Takes the signals that end a program as news, without a handler.
class EndSignals {
 public:
  EndSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    sigaddset(&signals_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  }
  ~EndSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  EndSignals(const EndSignals&) = delete;
  EndSignals& operator=(const EndSignals&) = delete;

  // True when one came within the time of a poll.
  bool wait() const {
    const timespec time{0, kPollNs};
    return sigtimedwait(&signals_, nullptr, &time) > 0;
  }

 private:
  sigset_t signals_{}, before_{};
};

LevelStamp stamp_or_gone(const std::string& path) {
  const auto stamp = stamp_of_level(path);
  if (stamp) return *stamp;
  LevelStamp gone;
  gone.file.set_gone();
  return gone;
}

bool has_changed(const std::string& path, LevelStamp& known) {
  const FilesChange found = level_change(path, known);
  if (found.change == FileChange::gone && !found.of_companion) return !known.file.is_gone();
  return found.change != FileChange::none;
}

bool is_same_content(const LevelStamp& a, const LevelStamp& b) {
  const bool both = a.companion && b.companion;
  return a.file.content == b.file.content && a.companion.has_value() == b.companion.has_value() &&
         !(both && a.companion->content != b.companion->content);
}

// Until two looks in a row see the same; nothing: a signal came.
std::optional<LevelStamp> stamp_at_rest(const std::string& path, const EndSignals& end) {
  for (LevelStamp stamp = stamp_or_gone(path);;) {
    if (end.wait()) return std::nullopt;
    if (!has_changed(path, stamp) || stamp.file.is_gone()) return stamp;
    stamp = stamp_or_gone(path);
  }
}

}  // namespace

void watch_file(const std::string& path, const std::function<void()>& look,
                const std::function<void()>& is_gone) {
  const EndSignals end;
  LevelStamp known = stamp_or_gone(path);  // before the content is read: what comes meanwhile shows later
  if (known.file.is_gone())
    is_gone();
  else
    look();
  while (!end.wait()) {
    if (!has_changed(path, known)) continue;
    const auto now = stamp_at_rest(path, end);
    if (!now) return;
    const bool same = !now->file.is_gone() && !known.file.is_gone() && is_same_content(*now, known);
    known = *now;
    if (known.file.is_gone())
      is_gone();
    else if (!same)
      look();
  }
}

}  // namespace talus
