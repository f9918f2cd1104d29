// Reads and writes whole files so that no crash, full disk or hostile path costs anybody a level.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include <talus/formats/format.h>
#include <talus/level/limits.h>

namespace talus {

inline constexpr std::string_view kTemporaryEnding = ".tmp";  // of files that are being written

// Returns the file's bytes. Unreadable files, and files of more bytes than `most`, are errors; so are
// directories, devices, pipes and sockets, at once, as reading them could wait for ever. progress: may stop
// the reading, which is an error, too.
FormatResult<std::string> read_file(const std::string& path, std::size_t most = kMaxFileBytes,
                                    const Progress& progress = {});
// Returns the first `count` bytes, or all of a smaller file; errors as above.
FormatResult<std::string> read_start_of_file(const std::string& path, std::size_t count);

// Replaces the file at once: whoever reads the path, even after a kill or a power loss at any moment, finds
// either the old file or the whole new one. Symbolic links are followed, and the old file's permissions stay.
// A device or pipe is written in place. After an error the old file is untouched and no temporary file
// remains, unless the error is StagedFile::doubt(). Only a killed process can leave its temporary file,
// ".NAME.N.tmp" with N from 0, beside the file; the next process that writes the file removes it.
FormatResult<void> write_file_atomic(const std::string& path, std::string_view bytes);

// What to do with a symbolic link in a file's place.
enum class LinkInPlace {
  follow,  // write the file that it leads to
  refuse   // return an error: the link was not there when the place was looked at
};

// StagedFile: the same in two steps, for files that belong together. First all are written, then all are put
// in their places.
class StagedFile {
 public:
  // Writes the temporary file. bytes: must live until put(), which writes devices and pipes.
  static FormatResult<StagedFile> write(const std::string& path, std::string_view bytes,
                                        LinkInPlace link = LinkInPlace::follow);
  // The same in parts, for large content: begin, add as often as needed, flush. Not for devices and pipes
  // (asserted by add()), see is_in_place().
  static FormatResult<StagedFile> begin(const std::string& path, LinkInPlace link = LinkInPlace::follow);
  FormatResult<void> add(std::string_view bytes);
  FormatResult<void> flush();  // to the disk; call it before put()
  // Whether the target is a device or a pipe, which has no temporary file.
  bool is_in_place() const { return descriptor_ < 0; }
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();             // without put(), the old file stays and the temporary one is removed
  FormatResult<void> put();  // call it once
  // A sentence on a doubt after put(): a power failure may undo the writing, as the folder could not be
  // brought to the disk. Empty: there is no doubt.
  const std::string& doubt() const { return doubt_; }

 private:
  StagedFile(std::string target, std::string temporary, int descriptor)
      : target_(std::move(target)), temporary_(std::move(temporary)), descriptor_(descriptor) {}
  void let_go();

  std::string target_;
  std::string temporary_;   // empty: the target is written in place, or was put
  int descriptor_;          // of the temporary file, which is locked until put(); -1: there is none
  std::string_view bytes_;  // what put() writes in place
  std::string doubt_;
};

}  // namespace talus
