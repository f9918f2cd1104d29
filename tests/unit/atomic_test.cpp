// A file holds its old or its new bytes, never half of them, whatever happens: kills, full disks, links and
// permissions.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "waiting.h"

namespace talus::atomic_test {

namespace fs = std::filesystem;

class AtomicFileTest : public FolderTest {
 protected:
  ~AtomicFileTest() override { fs::permissions(folder_, fs::perms::owner_all); }
  std::ptrdiff_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }
};

TEST_F(AtomicFileTest, ReadsWhatItWrites) {
  const std::string bytes("a\0b\n", 4);
  ASSERT_TRUE(write_file_atomic(path("x"), bytes));
  EXPECT_EQ(read_file(path("x")).value(), bytes);
  ASSERT_TRUE(write_file_atomic(path("x"), ""));
  EXPECT_EQ(read_file(path("x")).value(), "");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, UnreadableThingsAreErrors) {
  EXPECT_EQ(read_file(path("none")).error().message, "cannot be opened: No such file or directory");
  EXPECT_EQ(read_file(folder_.string()).error().message, "is a directory; only regular files can be read");
}

TEST_F(AtomicFileTest, ThingsOtherThanFilesAreRefusedAtOnce) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0666), 0);
  EXPECT_EQ(read_file(path("pipe")).error().message, "is a pipe; only regular files can be read");
  EXPECT_EQ(write_file_atomic(path("pipe"), "x").error().message, "is a pipe, but must be a regular file");
  EXPECT_EQ(write_file_atomic(path("pipe"), "x", InPlace::write).error().message,
            "is a pipe or a device that nobody reads");
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  EXPECT_TRUE(write_file_atomic(path("pipe"), "x", InPlace::write));
  EXPECT_EQ(read_file(path("pipe")).error().message, "is a pipe; only regular files can be read")
      << "with a byte in it";
  ::close(reader);
  const int descriptor = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{AF_UNIX, {}};
  const std::string name = path("s");
  ASSERT_LT(name.size(), sizeof address.sun_path);
  std::copy(name.begin(), name.end(), address.sun_path);
  ASSERT_EQ(::bind(descriptor, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  EXPECT_EQ(read_file(name).error().message, "is a socket; only regular files can be read");
  ::close(descriptor);
  for (const char* device : {"/dev/null", "/dev/zero", "/dev/tty"})
    EXPECT_EQ(read_file(device).error().message, "is a device; only regular files can be read");
  fs::create_symlink("pipe", path("link"));
  EXPECT_EQ(read_file(path("link")).error().message, "is a pipe; only regular files can be read");
}

TEST_F(AtomicFileTest, LargeFilesAreRefused) {
  std::ofstream(path("big")).close();
  fs::resize_file(path("big"), kMaxFileBytes);
  EXPECT_EQ(read_file(path("big"))->size(), kMaxFileBytes);
  fs::resize_file(path("big"), kMaxFileBytes + 1);
  EXPECT_EQ(read_file(path("big")).error().message, "is larger than 96 MiB");
}

TEST_F(AtomicFileTest, AReplacedFileKeepsItsPermissions) {
  ASSERT_TRUE(write_file_atomic(path("x"), "old"));
  fs::permissions(path("x"), fs::perms{0640});
  ASSERT_TRUE(write_file_atomic(path("x"), "new"));
  EXPECT_EQ(fs::status(path("x")).permissions(), fs::perms{0640});
}

TEST_F(AtomicFileTest, ANewFileHasTheUsualPermissions) {
  const mode_t mask = umask(022);
  const bool written = write_file_atomic(path("x"), "new").has_value();
  umask(mask);
  ASSERT_TRUE(written);
  EXPECT_EQ(fs::status(path("x")).permissions(), fs::perms{0644});
}

TEST_F(AtomicFileTest, APrivateFileIsTheOwnersAlone) {
  const auto write = [&] {
    return write_file_atomic(path("x"), "mine", InPlace::follow_links, Readers::owner).has_value();
  };
  ASSERT_TRUE(write());
  EXPECT_EQ(fs::status(path("x")).permissions(), fs::perms{0600});
  fs::permissions(path("x"), fs::perms{0644});
  ASSERT_TRUE(write());
  EXPECT_EQ(fs::status(path("x")).permissions(), fs::perms{0600});
}

TEST_F(AtomicFileTest, LinksAreFollowed) {
  fs::create_directory(path("there"));
  fs::create_symlink("there/file", path("link"));
  fs::create_symlink("link", path("link2"));
  ASSERT_TRUE(write_file_atomic(path("link2"), "dangling"));
  EXPECT_EQ(read_file(path("there/file")).value(), "dangling");
  ASSERT_TRUE(write_file_atomic(path("link2"), "new"));
  EXPECT_EQ(read_file(path("there/file")).value(), "new");
  EXPECT_TRUE(fs::is_symlink(path("link")) && fs::is_symlink(path("link2")));
  fs::create_symlink("loop", path("loop"));
  EXPECT_FALSE(write_file_atomic(path("loop"), "x"));
}

// A link that appears after the check is refused too.
TEST_F(AtomicFileTest, LinksCanBeRefused) {
  put("outside", "old");
  fs::create_symlink("outside", path("link"));
  const auto refused = StagedFile::write(path("link"), "new", InPlace::refuse_links);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "cannot be written: Too many levels of symbolic links");
  EXPECT_TRUE(StagedFile::write(path("plain"), "new", InPlace::refuse_links)->put());
  EXPECT_EQ(bytes_of("outside") + bytes_of("plain"), "oldnew");
}

// Things that appear between the check and the write are neither written into nor replaced, unless they are
// regular files.
TEST_F(AtomicFileTest, OnlyARegularFileIsReplaced) {
  put("outside", "old");
  for (const InPlace in_place : {InPlace::refuse_links, InPlace::follow_links, InPlace::write}) {
    auto late_pipe = StagedFile::write(path("pipe"), "new", in_place);
    auto late_link = StagedFile::write(path("link"), "new", in_place);
    auto late_folder = StagedFile::write(path("folder"), "new", in_place);
    auto late_file = StagedFile::write(path("file"), "new", in_place);
    ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0666), 0);
    const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
    fs::create_symlink("outside", path("link"));
    fs::create_directory(path("folder"));
    put("file", "newer");
    EXPECT_EQ(late_pipe->put().error().message, "is a pipe, but must be a regular file");
    char byte = 0;
    EXPECT_LE(::read(reader, &byte, 1), 0) << "nothing was written into it";
    ::close(reader);
    EXPECT_EQ(late_link->put().error().message, "cannot be written: Too many levels of symbolic links");
    EXPECT_EQ(bytes_of("outside"), "old");
    EXPECT_EQ(late_folder->put().error().message, "cannot be written: Is a directory");
    EXPECT_TRUE(late_file->put());
    EXPECT_EQ(bytes_of("file"), "new");
    EXPECT_TRUE(fs::is_fifo(path("pipe")) && fs::is_symlink(path("link")) &&
                fs::is_directory(path("folder")));
    for (const char* name : {"pipe", "link", "folder", "file"}) fs::remove(path(name));
  }
}

// The pipe is opened once. A file that gets its name later is another file.
TEST_F(AtomicFileTest, AFileThatReplacesAPipeIsNotWritten) {
  ASSERT_EQ(::mkfifo(path("pipe").c_str(), 0666), 0);
  const int reader = ::open(path("pipe").c_str(), O_RDONLY | O_NONBLOCK);
  auto staged = StagedFile::write(path("pipe"), "x", InPlace::write);
  ASSERT_TRUE(staged);
  fs::remove(path("pipe"));
  put("pipe", "precious");
  EXPECT_TRUE(staged->put());
  EXPECT_EQ(bytes_of("pipe"), "precious");
  char byte = 0;
  EXPECT_EQ(::read(reader, &byte, 1), 1);
  ::close(reader);
}

TEST_F(AtomicFileTest, TheStartOfAFileCanBeReadAlone) {
  put("a", "abcdef");
  EXPECT_EQ(read_start_of_file(path("a"), 4).value(), "abcd");
  EXPECT_EQ(read_start_of_file(path("a"), 10).value(), "abcdef");
  EXPECT_FALSE(read_start_of_file(path("none"), 4));
  EXPECT_EQ(read_start_of_file(folder_.string(), 4).error().message,
            "is a directory; only regular files can be read");
  fs::resize_file(path("a"), std::uintmax_t{1} << 33);
  EXPECT_EQ(read_start_of_file(path("a"), 4).value(), "abcd") << "of any size";
}

TEST_F(AtomicFileTest, ReadingCanBeCancelled) {
  put("a", std::string(std::size_t{8} << 20, 'a'));
  int asked = 0;
  const auto read = read_file(path("a"), kMaxFileBytes, Progress([&](double) { return ++asked < 3; }));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().message, "was cancelled");
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(read_file(path("a"), kMaxFileBytes, Progress([](double) { return true; })));
}

TEST_F(AtomicFileTest, DevicesAreWrittenOnRequestDirectoriesNever) {
  EXPECT_EQ(write_file_atomic(folder_.string(), "x").error().message, "cannot be written: Is a directory");
  EXPECT_EQ(write_file_atomic(path("none/x"), "x").error().message,
            "cannot be written: No such file or directory");
  EXPECT_EQ(write_file_atomic("/dev/null", "x").error().message, "is a device, but must be a regular file");
  ASSERT_TRUE(write_file_atomic("/dev/null", "x", InPlace::write));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_EQ(write_file_atomic("/dev/full", "x", InPlace::write).error().message,
            "cannot be written: No space left on device");
}

TEST_F(AtomicFileTest, OnlyFilesOfKilledProcessesAreRemoved) {
  put(".x.0.tmp", "left by a killed process");
  auto first = StagedFile::write(path("x"), "first");
  ASSERT_TRUE(first);
  EXPECT_EQ(bytes_of(".x.0.tmp"), "first");
  {
    const auto second = StagedFile::write(path("x"), "second");
    ASSERT_TRUE(second);
    EXPECT_EQ(bytes_of(".x.0.tmp"), "first");
    EXPECT_EQ(bytes_of(".x.1.tmp"), "second");
  }
  ASSERT_TRUE(first->put());
  EXPECT_EQ(bytes_of("x"), "first");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, AFileWrittenInPartsAppearsAsAWhole) {
  put("x", "old");
  {
    auto given_up = StagedFile::begin(path("x"));
    ASSERT_TRUE(given_up);
    ASSERT_TRUE(given_up->add("one "));
  }
  EXPECT_EQ(bytes_of("x"), "old");
  auto staged = StagedFile::begin(path("x"));
  ASSERT_TRUE(staged);
  EXPECT_TRUE(staged->add("one "));
  EXPECT_TRUE(staged->add("two"));
  EXPECT_EQ(bytes_of("x"), "old");
  EXPECT_TRUE(staged->flush());
  EXPECT_TRUE(staged->put());
  EXPECT_EQ(bytes_of("x"), "one two");
  EXPECT_EQ(files(), 1);
  EXPECT_EQ(StagedFile::begin("/dev/full", InPlace::write)->add("x").error().message,
            "cannot be written: No space left on device");
}

TEST_F(AtomicFileTest, OtherThingsWithATemporaryNameStay) {
  put("precious", "bytes");
  fs::create_symlink("precious", path(".x.0.tmp"));
  fs::create_directory(path(".x.1.tmp"));
  ASSERT_TRUE(write_file_atomic(path("x"), "new"));
  EXPECT_EQ(bytes_of("x"), "new");
  EXPECT_EQ(bytes_of("precious"), "bytes");
  EXPECT_TRUE(fs::is_symlink(path(".x.0.tmp")) && fs::is_directory(path(".x.1.tmp")));
}

TEST_F(AtomicFileTest, LongNamesWork) {
  const std::string name(255, 'n');
  ASSERT_TRUE(write_file_atomic(path(name), "x"));
  EXPECT_EQ(read_file(path(name)).value(), "x");
}

// Runs `body` in a child process, as a user without root's permissions. Returns its exit status.
template <class Body>
int in_child(Body body) {
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (geteuid() == 0 && setuid(kNobody) != 0) _exit(99);
    _exit(body());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(AtomicFileTest, ProtectedFilesAndDirectoriesAreErrors) {
  ASSERT_TRUE(write_file_atomic(path("x"), "old"));
  fs::permissions(folder_, fs::perms{0777});
  fs::permissions(path("x"), fs::perms{0444});
  EXPECT_EQ(in_child([&] { return write_file_atomic(path("x"), "new") ? 1 : 0; }), 0);
  fs::permissions(path("x"), fs::perms{0666});
  fs::permissions(folder_, fs::perms{0555});
  EXPECT_EQ(in_child([&] { return write_file_atomic(path("x"), "new") ? 1 : 0; }), 0);
  fs::permissions(path("x"), fs::perms{0200});
  EXPECT_EQ(in_child([&] { return read_file(path("x")) ? 1 : 0; }), 0);
  fs::permissions(path("x"), fs::perms{0644});
  EXPECT_EQ(read_file(path("x")).value(), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, AFullDiskLeavesTheOldFile) {
  ASSERT_TRUE(write_file_atomic(path("x"), "old"));
  fs::permissions(folder_, fs::perms{0777});
  fs::permissions(path("x"), fs::perms{0666});
  const int status = in_child([&] {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {1000, 1000};
    setrlimit(RLIMIT_FSIZE, &limit);
    const auto written = write_file_atomic(path("x"), std::string(5000, 'n'));
    return !written && written.error().message == "cannot be written: File too large" ? 7 : 1;
  });
  EXPECT_EQ(status, 7);
  EXPECT_EQ(read_file(path("x")).value(), "old");
  EXPECT_EQ(files(), 1);
}

TEST_F(AtomicFileTest, AKillLeavesTheOldOrTheNewFile) {
  const auto content = [](int number) { return std::string(200'000, static_cast<char>('a' + number % 26)); };
  for (int round = 0; round < 60; ++round) {
    ASSERT_TRUE(write_file_atomic(path("x"), "old"));
    const pid_t child = fork();
    if (child == 0) {
      for (int number = 1;; ++number) {
        if (!write_file_atomic(path("x"), content(number))) _exit(1);
      }
    }
    EXPECT_TRUE(comes_true([&] { return bytes_of("x") != "old"; }));
    usleep(static_cast<useconds_t>(500 + 379 * round));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    const std::string bytes = read_file(path("x")).value();
    ASSERT_EQ(bytes.size(), 200'000u);
    ASSERT_EQ(std::count(bytes.begin(), bytes.end(), bytes[0]), 200'000);
  }
}

}  // namespace talus::atomic_test
