// FileStamp: what a file held at some time, to find out whether another program has changed it since.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace talus {

struct FileStamp {
  std::int64_t modified = 0;  // ns since 1970, as the file system reports it
  std::int64_t size = 0;      // bytes
  std::uint64_t number = 0;  // of the file in its file system: changes if another one was renamed to its name
  // Hash of the bytes; nothing: they could not be read, and any other time, size or number counts as a
  // change.
  std::optional<std::uint64_t> content;

  // The file is known to be gone: if it comes back, its content counts.
  bool is_gone() const { return size < 0; }
  void set_gone() { modified = size = -1; }
};

// The stamp of the current file; nothing if there is none.
std::optional<FileStamp> stamp_of_file(const std::string& path);

enum class FileChange { none, content, gone };
// What has happened to the file since `known`. The bytes are read only if time, size or number differ. If the
// bytes are the same after all, `known` is updated.
FileChange file_change(const std::string& path, FileStamp& known);

// The files of a level: its own, and the companion beside it (see formats/native/companion.h).
struct LevelStamp {
  FileStamp file;
  std::optional<FileStamp> companion;  // nothing: there is no companion
};

// The stamp of the current files; nothing if the level's own cannot be read.
std::optional<LevelStamp> stamp_of_level(const std::string& path);

struct FilesChange {
  FileChange change = FileChange::none;
  bool of_companion = false;  // whether only the companion has changed
};
// What has happened to the files since `known`. A companion that appeared is new content.
FilesChange level_change(const std::string& path, LevelStamp& known);

}  // namespace talus
