// Reads and writes whole files so that no crash, full disk or hostile path costs anybody a level.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <talus/formats/format.h>
#include <talus/level/limits.h>

namespace talus {

inline constexpr std::string_view kTemporaryEnding = ".tmp";  // of files that are being written

// The error of a file with more bytes than `most`.
FormatError too_large_file(std::size_t most);

// A map of Tiled as XML may have more than other files: three layers of 4096x4096 cells take 100 to 250 MB as
// CSV.
inline constexpr std::size_t kMaxTmxBytes = std::size_t{256} << 20;
// How many bytes a file may have that is read, by its name: kMaxTmxBytes or kMaxFileBytes.
std::size_t most_bytes_of(const std::string& path);

// Returns the file's bytes. Unreadable files, and files of more bytes than `most`, are errors; so are
// directories, devices, pipes and sockets, at once, as reading them could wait for ever. progress: may stop
// the reading, which is an error, too. most: nothing stands for most_bytes_of().
FormatResult<std::string> read_file(const std::string& path, std::optional<std::size_t> most = std::nullopt,
                                    const Progress& progress = {});
// Returns the first `count` bytes, or all of a smaller file; errors as above.
FormatResult<std::string> read_start_of_file(const std::string& path, std::size_t count);

// What to do with something in a file's place that is no regular file. A directory is always an error.
enum class InPlace {
  refuse_links,  // as below, and a link is an error: it was not there when the place was looked at
  follow_links,  // write the file that a link leads to; a pipe or a device is an error. The usual choice
  write          // write into a pipe or a device, too, which may wait for ever: the user has named it
};

// Who may read a new file.
enum class Readers {
  usual,  // whom the user's settings allow (umask); a file that is replaced keeps its permissions
  owner   // nobody but its owner, whatever the old file allowed
};

// Replaces the file at once: whoever reads the path, even after a kill or a power loss at any moment, finds
// either the old file or the whole new one. Symbolic links are followed, and the old file's permissions stay.
// After an error the old file is untouched and no temporary file remains, unless the error is
// StagedFile::doubt(). Only a killed process can leave its temporary file, ".NAME.N.tmp" with N from 0,
// beside the file; the next process that writes the file removes it.
FormatResult<void> write_file_atomic(const std::string& path, std::string_view bytes,
                                     InPlace in_place = InPlace::follow_links,
                                     Readers readers = Readers::usual);

// StagedFile: the same in two steps, for files that belong together. First all are written, then all are put
// in their places.
class StagedFile {
 public:
  // Writes the temporary file. bytes: must live until put(), which writes devices and pipes.
  static FormatResult<StagedFile> write(const std::string& path, std::string_view bytes,
                                        InPlace in_place = InPlace::follow_links,
                                        Readers readers = Readers::usual);
  // The same in parts, for large content: begin, add as often as needed, flush. A device or a pipe gets each
  // part at once.
  static FormatResult<StagedFile> begin(const std::string& path, InPlace in_place = InPlace::follow_links,
                                        Readers readers = Readers::usual);
  FormatResult<void> add(std::string_view bytes);
  FormatResult<void> flush();  // to the disk; call it before put()
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();  // without put(), the old file stays and the temporary one is removed
  // Call it once. What came into the place since begin() and is no regular file is an error, and stays.
  FormatResult<void> put();
  // A sentence on a doubt after put(): a power failure may undo the writing, as the folder could not be
  // brought to the disk. Empty: there is no doubt.
  const std::string& doubt() const { return doubt_; }

 private:
  StagedFile(std::string target, std::string temporary, int descriptor)
      : target_(std::move(target)), temporary_(std::move(temporary)), descriptor_(descriptor) {}
  void let_go();
  bool is_in_place() const { return temporary_.empty(); }  // until put()

  std::string target_;
  std::string temporary_;   // empty: the target is a device or a pipe, or was put
  int descriptor_;          // of the temporary file, which is locked until put(), or of the target; -1: none
  std::string_view bytes_;  // what put() writes in place
  std::string doubt_;
};

}  // namespace talus
