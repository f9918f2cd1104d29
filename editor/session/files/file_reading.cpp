// Reads files on a thread.
#include "file_reading.h"

#include <chrono>
#include <filesystem>
#include <system_error>
#include <utility>

#include <talus/formats/format.h>
#include "formats/files/real_path.h"
#include "formats/last_catch.h"

namespace talus {
namespace {

// How long to wait for the result: small files are there at once; for large ones the window goes on.
constexpr std::chrono::milliseconds kPatience{2000}, kPatienceForLarge{100};

std::chrono::milliseconds patience_for(const std::string& path) {
  constexpr std::uintmax_t kSmall = 256 << 10;  // bytes
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  return error || size <= kSmall ? kPatience : kPatienceForLarge;
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
  reader_.start(last_name(file), guarded, is_large ? kPatienceForLarge : patience_for(file));
}

void FileReading::cancel() {
  reader_.cancel();
  if (on_given_up_) on_given_up_();
}

}  // namespace talus
