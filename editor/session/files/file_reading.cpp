// Reads files on a thread.
#include "file_reading.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include <talus/formats/format.h>
#include "formats/files/real_path.h"
#include "formats/last_catch.h"

namespace talus {
namespace {

bool is_small(const std::string& path) {
  constexpr std::uintmax_t kSmall = 256 << 10;  // bytes
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error || size <= kSmall;
}

}  // namespace

void FileReading::read(const std::string& file, FileReader::Work work, bool is_large) {
  const auto guarded = [this, file, work = std::move(work)](const Progress& progress) {
    try {
      return work(progress);
    } catch (...) {
      return FileReader::Finish([this, file, problem = "cannot be read: " + caught_text()] {
        cancel();
        messages_.tell_error(to_string(FormatError{"", problem}, file));
      });
    }
  };
  reader_.start(last_name(file), guarded, is_large || !is_small(file) ? patience_.large : patience_.small);
}

void FileReading::cancel() {
  reader_.cancel();
  if (on_given_up_) on_given_up_();
}

}  // namespace talus
