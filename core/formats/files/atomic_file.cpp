// The POSIX way to replace a file: write a temporary beside it, fsync, rename over it, fsync the directory.
#include "atomic_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "held_file.h"
#include "real_path.h"

namespace talus {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kReadAtOnce = 1 << 20;   // bytes
constexpr std::size_t kReadAtLeast = 1 << 16;  // bytes, for which memory is cleared however short the file is

tl::unexpected<FormatError> failure(const char* what, int error_number) {
  return tl::unexpected(
      FormatError{"", std::string(what) + ": " + std::generic_category().message(error_number)});
}

// Null: the path is a regular file.
const char* kind_of_no_file(mode_t mode) {
  if (S_ISREG(mode)) return nullptr;
  return S_ISDIR(mode) ? "directory" : S_ISFIFO(mode) ? "pipe" : S_ISSOCK(mode) ? "socket" : "device";
}

tl::unexpected<FormatError> no_file(const std::string& kind) {
  return tl::unexpected(FormatError{"", "is a " + kind + "; only regular files can be read"});
}

// Whether a rename would put a file into an empty place or over a regular file. Returns whether one is there.
FormatResult<bool> look_at_place(const fs::path& target, struct stat& found) {
  if (::lstat(target.c_str(), &found) != 0) {
    if (errno != ENOENT) return failure("cannot be written", errno);  // the path is forbidden
    return false;
  }
  if (S_ISLNK(found.st_mode)) return failure("cannot be written", ELOOP);
  if (S_ISDIR(found.st_mode)) return failure("cannot be written", EISDIR);
  if (const char* const kind = kind_of_no_file(found.st_mode))
    return tl::unexpected(FormatError{"", "is a " + std::string(kind) + ", but must be a regular file"});
  return true;
}

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  ~File() { close(); }
  File(File&& other) noexcept : descriptor_(other.release()) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  int get() const { return descriptor_; }
  bool is_open() const { return descriptor_ >= 0; }
  int release() { return std::exchange(descriptor_, -1); }
  bool close() {
    const int descriptor = release();
    return descriptor < 0 || ::close(descriptor) == 0;
  }

 private:
  int descriptor_;
};

bool write_all(int descriptor, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

int create_new(const std::string& name, mode_t mode) {
  return ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
}

// Creates a new file beside `target` and locks it. The lock tells files that are being written from those
// that killed processes left, which are removed. Returns -1 with errno if that fails.
int create_temporary(const fs::path& target, mode_t mode, std::string& name) {
  constexpr int kAttempts = 100;
  constexpr std::size_t kMaxStem = 200;  // file names have at most 255 bytes
  const std::string stem = "." + target.filename().string().substr(0, kMaxStem) + ".";
  for (int i = 0; i < kAttempts; ++i) {
    name = (target.parent_path() / (stem + std::to_string(i) + std::string(kTemporaryEnding))).string();
    int descriptor = create_new(name, mode);
    if (descriptor < 0 && errno == EEXIST) {
      if (!remove_if_unlocked(name)) continue;
      descriptor = create_new(name, mode);
    }
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) return -1;
    // Before the lock was taken, another process may have removed the file as left behind.
    if (try_lock(descriptor, name) || (errno != EWOULDBLOCK && errno != ENOENT)) return descriptor;
    ::close(descriptor);
  }
  errno = EEXIST;
  return -1;
}

bool is_device_or_pipe(const struct stat& status) {
  return !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
}

// Opens a device or a pipe, and makes sure that it still is one: what took its place is not written.
FormatResult<File> open_in_place(const std::string& path) {
  // Opening a pipe that nobody reads would wait without end.
  File file(::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!file.is_open() && errno == ENXIO)
    return tl::unexpected(FormatError{"", "is a pipe or a device that nobody reads"});
  if (!file.is_open()) return failure("cannot be opened for writing", errno);
  struct stat status = {};
  if (::fstat(file.get(), &status) != 0) return failure("cannot be written", errno);
  if (!is_device_or_pipe(status))
    return tl::unexpected(FormatError{"", "was a pipe or a device, and is another file now"});
  const int flags = ::fcntl(file.get(), F_GETFL);
  if (flags < 0 || ::fcntl(file.get(), F_SETFL, flags & ~O_NONBLOCK) != 0)
    return failure("cannot be written", errno);
  return file;
}

// Checks what the path is before it is opened, as opening a device may have an effect; and again afterwards,
// as it may be another file by then. size: of the file.
FormatResult<File> open_for_reading(const std::string& path, std::size_t& size) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return failure("cannot be opened", errno);
  if (const char* const kind = kind_of_no_file(status.st_mode)) return no_file(kind);
  File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
  if (!file.is_open()) return failure("cannot be opened", errno);
  if (::fstat(file.get(), &status) != 0) return failure("cannot be read", errno);
  if (const char* const kind = kind_of_no_file(status.st_mode)) return no_file(kind);
  size = static_cast<std::size_t>(status.st_size);
  return file;
}

// Appends up to `most` bytes. Returns how many were read; 0 at the end of the file.
FormatResult<std::size_t> read_more(int descriptor, std::size_t most, std::string& bytes) {
  const std::size_t before = bytes.size();
  bytes.resize(before + most);
  ssize_t count = 0;
  do count = ::read(descriptor, bytes.data() + before, most);
  while (count < 0 && errno == EINTR);
  const int error_number = errno;
  bytes.resize(before + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
  if (count < 0) return failure("cannot be read", error_number);
  return bytes.size() - before;
}

// The rename has happened, so a failure here costs only durability at power loss. Returns the error's number;
// 0 if it is done, or cannot be done here: the folder cannot be read, or the file system does not support it.
int sync_directory(const fs::path& target) {
  const fs::path directory = target.has_parent_path() ? target.parent_path() : fs::path(".");
  const File file(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!file.is_open()) return errno == EACCES ? 0 : errno;
  if (::fsync(file.get()) == 0 || errno == EINVAL || errno == ENOTSUP) return 0;
  return errno;
}

}  // namespace

FormatError too_large_file(std::size_t most) {
  return {"", "is larger than " + std::to_string(most >> 20) + " MiB"};
}

std::size_t most_bytes_of(const std::string& path) {
  return path.ends_with(".tmx") || path.ends_with(".TMX") ? kMaxTmxBytes : kMaxFileBytes;
}

FormatResult<std::string> read_file(const std::string& path, std::optional<std::size_t> most,
                                    const Progress& progress) {
  const std::size_t limit = most.value_or(most_bytes_of(path));
  std::size_t size = 0;
  const auto file = open_for_reading(path, size);
  if (!file) return tl::unexpected(file.error());
  if (size > limit) return tl::unexpected(too_large_file(limit));
  std::string bytes;
  bytes.reserve(size + kReadAtLeast);  // growing step by step would take up to twice as much
  while (progress.at(bytes.size(), std::max(size, bytes.size() + 1))) {
    const std::size_t left = size - std::min(size, bytes.size());
    const auto count = read_more(file->get(), std::clamp(left, kReadAtLeast, kReadAtOnce), bytes);
    if (!count) return tl::unexpected(count.error());
    if (bytes.size() > limit) return tl::unexpected(too_large_file(limit));
    if (*count == 0) return bytes;
  }
  return was_cancelled();
}

FormatResult<std::string> read_start_of_file(const std::string& path, std::size_t count) {
  std::size_t size = 0;
  const auto file = open_for_reading(path, size);
  if (!file) return tl::unexpected(file.error());
  std::string bytes;
  while (bytes.size() < count) {
    const auto read = read_more(file->get(), std::min(count - bytes.size(), kReadAtOnce), bytes);
    if (!read) return tl::unexpected(read.error());
    if (*read == 0) break;
  }
  return bytes;
}

FormatResult<void> write_file_atomic(const std::string& path, std::string_view bytes, InPlace in_place,
                                     Readers readers) {
  auto staged = StagedFile::write(path, bytes, in_place, readers);
  if (!staged) return tl::unexpected(staged.error());
  auto put = staged->put();
  if (put && !staged->doubt().empty()) return tl::unexpected(FormatError{"", staged->doubt()});
  return put;
}

FormatResult<StagedFile> StagedFile::write(const std::string& path, std::string_view bytes, InPlace in_place,
                                           Readers readers) {
  auto staged = begin(path, in_place, readers);
  if (!staged) return staged;
  staged->bytes_ = bytes;
  if (staged->is_in_place()) return staged;
  auto done = staged->add(bytes);
  if (done) done = staged->flush();
  if (!done) return tl::unexpected(done.error());
  return staged;
}

FormatResult<StagedFile> StagedFile::begin(const std::string& path, InPlace in_place, Readers readers) {
  struct stat old = {};
  if (in_place == InPlace::write && ::stat(path.c_str(), &old) == 0 && is_device_or_pipe(old)) {
    auto device = open_in_place(path);
    if (!device) return tl::unexpected(device.error());
    return StagedFile(path, "", device->release());
  }
  const auto place = in_place == InPlace::refuse_links ? FormatResult<std::string>(path) : real_path(path);
  if (!place) return tl::unexpected(place.error());
  const fs::path target = *place;
  const auto exists = look_at_place(target, old);
  if (!exists) return tl::unexpected(exists.error());
  // rename() would replace a write-protected file, as only the directory's permissions count.
  if (*exists && ::access(target.c_str(), W_OK) != 0) return failure("cannot be written", errno);

  // Nobody opens the new file of a private one before it has its permissions.
  const bool is_private = readers == Readers::owner;
  std::string temporary;
  File file(create_temporary(target, *exists || is_private ? 0600 : 0666, temporary));
  if (!file.is_open()) return failure("cannot be written", errno);
  StagedFile staged(target.string(), std::move(temporary), file.release());
  // A file of another user stays theirs where the system lets it; the mode follows, as this may change it.
  struct stat made = {};
  if (*exists && !is_private && ::fstat(staged.descriptor_, &made) == 0 &&
      (made.st_uid != old.st_uid || made.st_gid != old.st_gid))
    (void)!::fchown(staged.descriptor_, old.st_uid, old.st_gid);
  if (*exists && !is_private && ::fchmod(staged.descriptor_, old.st_mode & 07777) != 0)
    return failure("cannot be written", errno);
  return staged;
}

FormatResult<void> StagedFile::add(std::string_view bytes) {
  if (!write_all(descriptor_, bytes)) return failure("cannot be written", errno);
  return {};
}

FormatResult<void> StagedFile::flush() {
  if (is_in_place()) return {};
  if (::fsync(descriptor_) != 0) return failure("cannot be written", errno);
  return {};
}

FormatResult<void> StagedFile::put() {
  if (is_in_place()) {
    const bool is_written = write_all(descriptor_, bytes_);
    if (!is_written || ::close(std::exchange(descriptor_, -1)) != 0)
      return failure("cannot be written", errno);
    return {};
  }
  struct stat found = {};
  if (const auto is_good = look_at_place(target_, found); !is_good) return tl::unexpected(is_good.error());
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) return failure("cannot be written", errno);
  temporary_.clear();
  let_go();
  if (const int error_number = sync_directory(target_); error_number != 0)
    doubt_ = "is written, but a power failure may undo that, since its folder could not be synchronised: " +
             std::generic_category().message(error_number);
  return {};
}

StagedFile::StagedFile(StagedFile&& other) noexcept
    : target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)),
      bytes_(other.bytes_),
      doubt_(std::move(other.doubt_)) {}

// fsync has brought the bytes of a file to the disk, so closing cannot fail.
void StagedFile::let_go() {
  if (descriptor_ >= 0) ::close(std::exchange(descriptor_, -1));
}

StagedFile::~StagedFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  let_go();
}

}  // namespace talus
