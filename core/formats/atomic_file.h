// Whole files in and out, so that a crash, a full disk or a hostile path costs nobody a level.
#pragma once

#include <string>
#include <string_view>
#include <utility>

#include "../level/limits.h"
#include "format.h"

namespace talus {

// The file's bytes; an error for unreadable files, files over kMaxFileBytes, and at once for what is no file
// but a directory, device, pipe or socket: reading one of these could wait for ever.
FormatResult<std::string> read_file(const std::string& path);

// Puts the bytes in place at once: whoever reads the path, even after a kill or power loss at any moment,
// finds the old file or the new one whole. Symbolic links are followed, the old file's permissions stay, and
// a device or pipe is written in place. After an error the old file is untouched and no temporary remains;
// only a process killed between two system calls can leave its temporary, ".NAME.PID-N.tmp", beside the file.
FormatResult<void> write_file_atomic(const std::string& path, std::string_view bytes);

// The same in two steps, for files that belong together: all are written, then all are put in place.
class StagedFile {
 public:
  // Writes the temporary file. bytes: must live until put(), which writes devices and pipes.
  static FormatResult<StagedFile> write(const std::string& path, std::string_view bytes);
  StagedFile(StagedFile&& other) noexcept;
  StagedFile& operator=(StagedFile&&) = delete;
  ~StagedFile();             // without put(), the old file stays and the temporary goes
  FormatResult<void> put();  // once

 private:
  StagedFile(std::string target, std::string temporary, std::string_view bytes)
      : target_(std::move(target)), temporary_(std::move(temporary)), bytes_(bytes) {}

  std::string target_;
  std::string temporary_;  // empty: it is written in place, or has been put
  std::string_view bytes_;
};

}  // namespace talus
