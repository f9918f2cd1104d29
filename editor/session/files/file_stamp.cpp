// Stamps by time, size and content.
#include "file_stamp.h"

#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string_view>

#include "formats/files/atomic_file.h"
#include "formats/native/companion.h"

namespace talus {
namespace {

// Time and size; nothing if there is no such file.
std::optional<FileStamp> outer_stamp(const std::string& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  constexpr std::int64_t kNsPerSecond = 1'000'000'000;
  return FileStamp{
      status.st_mtim.tv_sec * kNsPerSecond + status.st_mtim.tv_nsec, status.st_size, status.st_ino, {}};
}

// Whether it can be read without waiting for ever.
bool is_plain_file(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error));
}

bool same_outside(const FileStamp& a, const FileStamp& b) {
  return a.modified == b.modified && a.size == b.size && a.number == b.number;
}

}  // namespace

std::optional<FileStamp> stamp_of_file(const std::string& path) {
  std::optional<FileStamp> stamp = outer_stamp(path);  // before the bytes: changes in between show later
  if (!stamp) return std::nullopt;
  if (const auto bytes = read_file(path)) stamp->content = std::hash<std::string_view>()(*bytes);
  return stamp;
}

FileChange file_change(const std::string& path, FileStamp& known) {
  const auto outer = outer_stamp(path);
  if (!outer) return FileChange::gone;
  if (same_outside(*outer, known)) return FileChange::none;
  const auto now = stamp_of_file(path);
  if (!now || !now->content || now->content != known.content) return FileChange::content;
  known = *now;
  return FileChange::none;
}

std::optional<LevelStamp> stamp_of_level(const std::string& path) {
  const auto file = stamp_of_file(path);
  if (!file) return std::nullopt;
  const std::string beside = companion_path(path);
  return LevelStamp{*file, is_plain_file(beside) ? stamp_of_file(beside) : std::nullopt};
}

FilesChange level_change(const std::string& path, LevelStamp& known) {
  const auto change_of = [](const std::string& file, FileStamp& stamp) {
    return FilesChange{file_change(file, stamp), file, &stamp};
  };
  if (FilesChange found = change_of(path, known.file); found.change != FileChange::none) return found;
  const std::string beside = companion_path(path);
  const bool is_there = is_plain_file(beside);
  if (!known.companion && is_there) return {FileChange::content, beside};
  if (known.companion && !is_there) return {FileChange::gone, beside, &*known.companion};
  if (known.companion) {
    if (FilesChange found = change_of(beside, *known.companion); found.change != FileChange::none)
      return found;
  }
  for (LinkedStamp& linked : known.linked) {
    if (!linked.stamp && outer_stamp(linked.path)) return {FileChange::content, linked.path};
    if (!linked.stamp || (linked.stamp->is_gone() && !outer_stamp(linked.path))) continue;
    if (FilesChange found = change_of(linked.path, *linked.stamp); found.change != FileChange::none)
      return found;
  }
  return {};
}

bool may_have_changed(const std::string& path, const LevelStamp& known) {
  const auto differs = [](const std::optional<FileStamp>& now, const std::optional<FileStamp>& before) {
    const bool was_there = before && !before->is_gone();
    return now && was_there ? !same_outside(*now, *before) : now.has_value() != was_there;
  };
  const std::string beside = companion_path(path);
  const auto companion = is_plain_file(beside) ? outer_stamp(beside) : std::nullopt;
  if (differs(outer_stamp(path), known.file) || differs(companion, known.companion)) return true;
  return std::any_of(known.linked.begin(), known.linked.end(), [&](const LinkedStamp& linked) {
    return differs(outer_stamp(linked.path), linked.stamp);
  });
}

void add_linked(const std::vector<std::string>& paths, std::int64_t before, LevelStamp& stamp) {
  constexpr std::size_t kMaxLinked = 1000;  // each is looked at all the time
  for (const std::string& path : paths) {
    const bool is_known = std::any_of(stamp.linked.begin(), stamp.linked.end(),
                                      [&](const LinkedStamp& linked) { return linked.path == path; });
    if (is_known || stamp.linked.size() == kMaxLinked) continue;
    auto now = stamp_of_file(path);
    if (now && now->modified > before) now->content.reset(), now->modified = 0;
    stamp.linked.push_back({path, now});
  }
}

std::int64_t time_for_stamps() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::int64_t bytes_of(const LevelStamp& stamp) {
  std::int64_t bytes = stamp.file.size;
  for (const LinkedStamp& linked : stamp.linked) bytes += linked.stamp ? linked.stamp->size : 0;
  return bytes;
}

}  // namespace talus
