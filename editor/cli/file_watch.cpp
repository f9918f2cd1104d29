// Polls, which also sees files that are saved by renaming, on any file system.
#include "file_watch.h"

#include <chrono>
#include <optional>

#include "end_signals.h"
#include "session/files/file_stamp.h"

namespace talus {
namespace {

constexpr auto kPoll = std::chrono::milliseconds(
    200);  // the time between two looks at the file, and how long it must be unchanged

// A thing that cannot be read, such as a pipe, counts as missing.
LevelStamp stamp_or_gone(const std::string& path) {
  const auto stamp = stamp_of_level(path);
  if (stamp && stamp->file.content) return *stamp;
  LevelStamp gone;
  gone.file.set_gone();
  return gone;
}

bool has_changed(const std::string& path, LevelStamp& known) {
  const FilesChange found = level_change(path, known);
  if (found.change == FileChange::gone && found.gone == &known.file) return !known.file.is_gone();
  return found.change != FileChange::none;
}

bool is_same_content(const LevelStamp& a, const LevelStamp& b) {
  const bool both = a.companion && b.companion;
  return a.file.content == b.file.content && a.companion.has_value() == b.companion.has_value() &&
         !(both && a.companion->content != b.companion->content);
}

// Waits until two looks in a row see the same; returns nothing if a signal came.
std::optional<LevelStamp> stamp_at_rest(const std::string& path, const EndSignals& end) {
  for (LevelStamp stamp = stamp_or_gone(path);;) {
    if (end.wait(kPoll)) return std::nullopt;
    if (!has_changed(path, stamp) || stamp.file.is_gone()) return stamp;
    stamp = stamp_or_gone(path);
  }
}

}  // namespace

void watch_file(const std::string& path, const std::function<bool()>& look,
                const std::function<bool()>& is_gone) {
  const EndSignals end;
  LevelStamp known = stamp_or_gone(path);  // taken before the content is read: changes meanwhile show later
  bool goes_on = known.file.is_gone() ? is_gone() : look();
  while (goes_on && !end.wait(kPoll)) {
    if (!has_changed(path, known)) continue;
    const auto now = stamp_at_rest(path, end);
    if (!now) return;
    const bool same = now->file.is_gone() == known.file.is_gone() && is_same_content(*now, known);
    known = *now;
    if (!same) goes_on = known.file.is_gone() ? is_gone() : look();
  }
}

}  // namespace talus
