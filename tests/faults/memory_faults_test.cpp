// Too little memory: the error says what was being read or done, and everything else goes on as it was.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/c/talus.h>
#include "faults/failing_memory.h"
#include "platform/autosave.h"
#include "unit/cli_answer.h"
#include "unit/folder_test.h"
#include "unit/waiting.h"

namespace talus::memory_faults_test {

using testing::HasSubstr;

constexpr std::size_t kFileBytes = 9 << 20, kTooMuch = 4 << 20;

class MemoryFaults : public FolderTest {
 protected:
  // A file that is larger than the memory that will be left.
  std::string large_file(const std::string& name) const { return put(name, std::string(kFileBytes, ' ')); }
  static std::string message(const Session& session) {
    return session.message() ? session.message()->text : "";
  }
};

TEST_F(MemoryFaults, ACommandSaysWhatItWasReading) {
  const std::string file = large_file("cave.talus.json");
  const FailingMemory failing(kTooMuch);
  const CliAnswer answer = cli_answer({"check", file});
  EXPECT_EQ(answer.status, 1);
  EXPECT_EQ(answer.err, "talus: error: failed while reading " + file + ": there is not enough memory\n");
}

TEST_F(MemoryFaults, TheInterfaceForCSaysWhatItWasReading) {
  const std::string file = large_file("cave.talus.json");
  char error[1000] = "";
  const FailingMemory failing(kTooMuch);
  EXPECT_EQ(talus_open(file.c_str(), error, sizeof error), nullptr);
  EXPECT_EQ(std::string(error), file + ": error: cannot be read: there is not enough memory");
}

TEST_F(MemoryFaults, TheEditorSaysWhatItHadOpen) {
  large_file("settings.json");  // settings are read before there is a window
  const EnvironmentVariable config("TALUS_CONFIG_DIR", folder_.string());
  testing::internal::CaptureStderr();
  int status = 0;
  {
    const FailingMemory failing(kTooMuch);
    status = cli_answer({"edit", "cave.talus.json"}).status;
  }
  EXPECT_EQ(status, 1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "talus: error: the editor ended while it had cave.talus.json open: there is not enough memory\n");
}

TEST_F(MemoryFaults, OpeningAFileLeavesTheLevelAsItIs) {
  const std::string file = large_file("cave.talus.json");
  Session session;
  {
    const FailingMemory failing(kTooMuch, FailingMemory::Where::on_other_threads);
    session.apply(action::OpenFile{file});
    session.finish_reading();
  }
  EXPECT_EQ(message(session), file + ": error: cannot be read: there is not enough memory");
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_EQ(session.path(), "");
  EXPECT_EQ(session.level(), Level());
}

// The first bytes tell that it is a picture. A thread reads the rest.
TEST_F(MemoryFaults, ALargePictureIsReadOnAnotherThread) {
  const std::string file = put("large.png", std::string("\x89PNG\r\n\x1a\n") + std::string(kFileBytes, ' '));
  Session session;
  for (const Action& open : {Action(action::OpenFile{file}), Action(action::OpenPng{file})}) {
    session.apply(action::DismissMessage{});
    const FailingMemory failing(kTooMuch);
    session.apply(open);
    session.finish_reading();
    EXPECT_EQ(message(session), file + ": error: cannot be read: there is not enough memory");
    EXPECT_FALSE(session.png_import());
  }
}

TEST_F(MemoryFaults, CompilingALargeLevelSaysThatItCannotBePlayed) {
  Level level;
  level.sheet(SheetId::tiles).flags[1] = 1;
  level.map = TileMap(400, 400);
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{1});
  Session session(level);
  {
    const FailingMemory failing(10'000, FailingMemory::Where::on_other_threads);
    session.apply(action::EditLevel{Edit{"Clear the flag", {FlagsChange{SheetId::tiles, 1, 1, 0}}}, 0});
    ASSERT_TRUE(session.compile_progress());
    ASSERT_TRUE(comes_true([&] {
      session.advance(0);
      return !session.compile_progress();
    }));
  }
  EXPECT_EQ(message(session), "The level cannot be played: there is not enough memory.");
}

TEST_F(MemoryFaults, AutosavingSaysThatItCannot) {
  Session session;
  session.apply(action::EditLevel{Edit{"Paint", {CellChange{{1, 1}, 0, 4}}}});
  Autosave autosave(path("autosave"));
  {
    const FailingMemory failing(2'000, FailingMemory::Where::on_other_threads);
    autosave.follow(session, 0);
    autosave.follow(session, Autosave::kDelay + 1);
    ASSERT_TRUE(comes_true([&] { return !autosave.is_writing(); }));
  }
  EXPECT_THAT(autosave.follow(session, 0).value_or(""),
              HasSubstr("cannot be written: there is not enough memory"));
}

TEST_F(MemoryFaults, AnExportSaysThatItCannotBeMade) {
  Session session;
  session.apply(action::SaveFileAs{path("a.talus.json")});
  const ExportPreset preset{.name = "map", .exporter = "tmj", .path = "map.tmj", .extra = {}};
  session.apply(action::EditLevel{Edit{"Add", {ExportsChange{{}, {preset}}}}});
  {
    const FailingMemory failing(20'000, FailingMemory::Where::on_other_threads);
    session.apply(action::RunExports{});
    ASSERT_TRUE(exports_end(session));
  }
  EXPECT_THAT(message(session), HasSubstr("cannot be made: there is not enough memory"));
  EXPECT_FALSE(exists("map.tmj"));
}

TEST_F(MemoryFaults, WorkLeftBehindIsNamed) {
  const std::string file = large_file("1-0.talus-autosave");
  const FailingMemory failing(kTooMuch);
  const auto works = Autosave(folder_.string()).left_behind();
  ASSERT_EQ(works.size(), 1u);
  EXPECT_EQ(works[0].file, file);
  EXPECT_EQ(works[0].problem, "cannot be read: there is not enough memory");
}

}  // namespace talus::memory_faults_test
