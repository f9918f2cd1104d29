// The progress of a long command on a terminal, and how Ctrl+C ends it.
#include "cli/progress_line.h"

#include <gtest/gtest.h>
#include <pthread.h>

#include <iostream>
#include <sstream>

#include <talus/formats/format.h>
#include "cli_answer.h"
#include "folder_test.h"
#include "formats/native/recording_file.h"

namespace talus::progress_line_test {

using std::chrono::hours, std::chrono::seconds;

// While it exists, signals that would end the program are held back. Signals that came are dropped when it is
// destroyed.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&signals_);
    sigaddset(&signals_, SIGINT);
    pthread_sigmask(SIG_BLOCK, &signals_, &before_);
  }
  ~HeldSignals() {
    const timespec now{};
    while (sigtimedwait(&signals_, nullptr, &now) > 0) continue;
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;

 private:
  sigset_t signals_{}, before_{};
};

TEST(ProgressLine, OverwritesItselfAndIsErased) {
  std::ostringstream text;
  {
    ProgressLine line(text, "cave.json", true, seconds(0), hours(1));
    EXPECT_TRUE(line.at(0.429));
    EXPECT_EQ(text.str(), "\r\x1b[Kcave.json: 42 %");
    EXPECT_TRUE(line.at(0.5)) << "too early for another";
    EXPECT_EQ(text.str(), "\r\x1b[Kcave.json: 42 %");
  }
  EXPECT_EQ(text.str(), "\r\x1b[Kcave.json: 42 %\r\x1b[K");
}

TEST(ProgressLine, QuickWorkShowsNothing) {
  std::ostringstream text;
  {
    ProgressLine quick(text, "a", true, hours(1));
    ProgressLine other(text, "b", false, seconds(0));
    EXPECT_TRUE(quick.at(0.5));
    EXPECT_TRUE(other.at(0.5));
  }
  EXPECT_EQ(text.str(), "");
  EXPECT_FALSE(is_terminal(text));
}

TEST(ProgressLine, CtrlCEndsTheWork) {
  const HeldSignals held;
  std::ostringstream text;
  ProgressLine line(text, "a", false);
  EXPECT_TRUE(line.at(0.5));
  pthread_kill(pthread_self(), SIGINT);
  EXPECT_FALSE(line.at(0.6));
}

class InterruptedExport : public FolderTest {};

TEST_F(InterruptedExport, LeavesOldFilesAsTheyWere) {
  ASSERT_TRUE(save_level(Level(), *find_format("native"), path("cave.talus.json")));
  put("a.json", "old");
  const HeldSignals held;
  pthread_kill(pthread_self(), SIGINT);
  const CliAnswer answer =
      cli_answer({"export", path("cave.talus.json"), "--to", "json", "-o", path("a.json")});
  EXPECT_EQ(answer.status, 1);
  EXPECT_NE(answer.err.find("error: was cancelled\n"), std::string::npos) << answer.err;
  EXPECT_EQ(bytes_of("a.json"), "old");
  EXPECT_EQ(cli_answer({"export", path("cave.talus.json"), "--to", "json", "-o", "-"}).out, "");
}

class InterruptedRun : public FolderTest {};

TEST_F(InterruptedRun, EndsLongBeforeItsLastFrame) {
  const std::string level = path("cave.talus.json");
  ASSERT_TRUE(save_level(Level(), *find_format("native"), level));
  Recording recording;
  recording.frames = kMaxUnhashedFrames;
  ASSERT_TRUE(save_recording(recording, path("run.talusrec")));
  const HeldSignals held;
  pthread_kill(pthread_self(), SIGINT);
  const std::vector<std::vector<std::string>> commands = {
      {"sim", level, "--frames", "1000000000"},
      {"sim", level, "--frames", "1000000000", "--until", "frame < 0"},
      {"sim", path("run.talusrec"), "--hash"},
      {"shot", level, "--frame", "1000000", "-o", path("a.png")},
      {"bench", level, "--bodies", "10", "--frames", "10000000"}};
  for (const auto& command : commands) {
    const CliAnswer answer = cli_answer(command);
    EXPECT_EQ(answer.status, 1) << command[0];
    EXPECT_NE(answer.err.find(": error: was cancelled\n"), std::string::npos) << command[0] << answer.err;
    EXPECT_EQ(answer.out, "") << command[0];
  }
  EXPECT_FALSE(exists("a.png"));
}

TEST_F(InterruptedRun, EndsWhileAFileIsRead) {
  Level large;
  large.map = TileMap(1000, 1000);
  std::fill(large.map.cells().tiles().begin(), large.map.cells().tiles().end(), TileNumber{1});
  ASSERT_TRUE(save_level(large, *find_format("native"), path("cave.talus.json")));
  const HeldSignals held;
  pthread_kill(pthread_self(), SIGINT);
  EXPECT_EQ(cli_answer({"check", path("cave.talus.json")}).err,
            path("cave.talus.json") + ": error: was cancelled\n");
}

}  // namespace talus::progress_line_test
