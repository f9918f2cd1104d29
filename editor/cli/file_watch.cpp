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

FileStamp stamp_or_gone(const std::string& path) {
  const auto stamp = stamp_of_file(path);
  if (stamp) return *stamp;
  FileStamp gone;
  gone.set_gone();
  return gone;
}

// Until two looks in a row see the same; nothing: a signal came.
std::optional<FileStamp> stamp_at_rest(const std::string& path, const EndSignals& end) {
  for (FileStamp stamp = stamp_or_gone(path);;) {
    if (end.wait()) return std::nullopt;
    if (file_change(path, stamp) == FileChange::none || stamp.is_gone()) return stamp;
    stamp = stamp_or_gone(path);
  }
}

}  // namespace

void watch_file(const std::string& path, const std::function<void()>& look,
                const std::function<void()>& is_gone) {
  const EndSignals end;
  FileStamp known = stamp_or_gone(path);  // before the content is read: what comes meanwhile shows later
  if (known.is_gone())
    is_gone();
  else
    look();
  while (!end.wait()) {
    const FileChange change = file_change(path, known);
    if (change == FileChange::none || (change == FileChange::gone && known.is_gone())) continue;
    const auto now = stamp_at_rest(path, end);
    if (!now) return;
    const bool same = !now->is_gone() && !known.is_gone() && now->content == known.content;
    known = *now;
    if (known.is_gone())
      is_gone();
    else if (!same)
      look();
  }
}

}  // namespace talus
