// Whole files in and out, so that a crash, a full disk or a hostile path costs nobody a level.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <talus/formats/format.h>
#include <talus/level/limits.h>

namespace talus {

inline constexpr std::string_view kTemporaryEnding = ".tmp";  // of files that are being written

// The file's bytes; an error for unreadable files, files of more bytes than `most`, and at once for what is
// no file but a directory, device, pipe or socket: reading one of these could wait for ever.
// progress: it ends early, with an error, where that says so.
FormatResult<std::string> read_file(const std::string& path, std::size_t most = kMaxFileBytes,
                                    const Progress& progress = {});
// The first bytes of a file, `count` of them or all of a smaller one; errors as above.
FormatResult<std::string> read_start_of_file(const std::string& path, std::size_t count);

// Puts the bytes in place at once: whoever reads the path, even after a kill or power loss at any moment,
// finds the old file or the new one whole. Symbolic links are followed, the old file's permissions stay, and
// a device or pipe is written in place. After an error the old file is untouched and no temporary remains,
// but where StagedFile::doubt() is the error; only a killed process can leave its temporary, ".NAME.N.tmp"
// with N from 0, beside the file: the next one that writes the file removes it.
FormatResult<void> write_file_atomic(const std::string& path, std::string_view bytes);

// What becomes of a symbolic link in a file's place.
enum class LinkInPlace {
  follow,  // the file that it leads to is written
  refuse   // an error: nobody has seen where it leads, as there was none when that was looked at
};

// The same in two steps, for files that belong together: all are written, then all are put in place.
class StagedFile {
 public:
  // Writes the temporary file. bytes: must live until put(), which writes devices and pipes.
  static FormatResult<StagedFile> write(const std::string& path, std::string_view bytes,
                                        LinkInPlace link = LinkInPlace::follow);
  // The same in parts, for what is made bit by bit: begun, added to as often as there is more, and flushed.
  // Not for devices and pipes (asserted by add()), see is_in_place().
  static FormatResult<StagedFile> begin(const std::string& path, LinkInPlace link = LinkInPlace::follow);
  FormatResult<void> add(std::string_view bytes);
  FormatResult<void> flush();  // to the disk; before put()
  // Whether it is a device or a pipe, which has no temporary.
  bool is_in_place() const { return descriptor_ < 0; }
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();             // without put(), the old file stays and the temporary goes
  FormatResult<void> put();  // once
  // What is to be told of a file that is put in place: that a power failure may undo it, as its folder could
  // not be brought to the disk. Empty: nothing.
  const std::string& doubt() const { return doubt_; }

 private:
  StagedFile(std::string target, std::string temporary, int descriptor)
      : target_(std::move(target)), temporary_(std::move(temporary)), descriptor_(descriptor) {}
  void let_go();

  std::string target_;
  std::string temporary_;   // empty: it is written in place, or has been put
  int descriptor_;          // of the temporary, which is locked until it is put; -1: none
  std::string_view bytes_;  // for put(), of what is written in place
  std::string doubt_;
};

}  // namespace talus
