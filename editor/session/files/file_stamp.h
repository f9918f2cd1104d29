// FileStamp: what a file held at some time, to tell whether another program has changed it since.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace talus {

struct FileStamp {
  std::int64_t modified = 0;  // ns since 1970, as the file system says
  std::int64_t size = 0;      // bytes
  std::uint64_t number = 0;   // of the file in its file system: another one was renamed to its name
  std::optional<std::uint64_t> content;  // hash of the bytes; nothing: they could not be read, and any other
                                         // time, size or number counts as other ones

  // It is known that the file went away: if it comes back, its content counts.
  bool is_gone() const { return size < 0; }
  void set_gone() { modified = size = -1; }
};

// Of the file as it is; nothing when there is none.
std::optional<FileStamp> stamp_of_file(const std::string& path);

enum class FileChange { none, content, gone };
// What has become of the file since `known`. The bytes are read only where time, size or number differ; where
// they are the same after all, `known` is brought up to the file.
FileChange file_change(const std::string& path, FileStamp& known);

// The files of a level: its own, and the companion beside it (see formats/native/companion.h).
struct LevelStamp {
  FileStamp file;
  std::optional<FileStamp> companion;  // none: there is none
};

// Of the files as they are; nothing when the level's own cannot be read.
std::optional<LevelStamp> stamp_of_level(const std::string& path);

struct FilesChange {
  FileChange change = FileChange::none;
  bool of_companion = false;  // and not of the file
};
// What has become of the files since `known`. A companion that came is new content.
FilesChange level_change(const std::string& path, LevelStamp& known);

}  // namespace talus
