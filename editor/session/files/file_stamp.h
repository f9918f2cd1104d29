// FileStamp: what a file held at some time, to find out whether another program has changed it since.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

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

// A file that the level's own names, such as a tileset or a picture.
struct LinkedStamp {
  std::string path;
  std::optional<FileStamp> stamp;  // nothing: there was no such file
};

// The files of a level: its own, the companion beside it (see formats/native/companion.h), and linked ones.
struct LevelStamp {
  FileStamp file;
  std::optional<FileStamp> companion;  // nothing: there is no companion
  std::vector<LinkedStamp> linked = {};
};

// The stamp of the current files; nothing if the level's own cannot be read.
std::optional<LevelStamp> stamp_of_level(const std::string& path);
// Adds the current linked files, each once. before: from stamp_of_level(), before the level was read; files
// that changed since then count as changed.
void add_linked(const std::vector<std::string>& paths, std::int64_t before, LevelStamp& stamp);
// The time of the system's clock, as FileStamp::modified.
std::int64_t time_for_stamps();
std::int64_t bytes_of(const LevelStamp& stamp);  // of all files together

struct FilesChange {
  FileChange change = FileChange::none;
  std::string file = {};      // the path of the one that has changed
  FileStamp* gone = nullptr;  // in `known`, of the file that is gone
};
// What has happened to the files since `known`. A companion that appeared is new content, and so is a linked
// file that was missing.
FilesChange level_change(const std::string& path, LevelStamp& known);
// Whether that is worth a call: whether a file has another time, size or number, has come or has gone. Reads
// no bytes.
bool may_have_changed(const std::string& path, const LevelStamp& known);

}  // namespace talus
