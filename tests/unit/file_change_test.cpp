// Other programs change the file of a session: nothing is lost, whatever the answer.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "session/files/file_stamp.h"
#include "session/session.h"

namespace talus::file_change_test {

namespace fs = std::filesystem;

class FileChangeTest : public FolderTest {
 protected:
  void SetUp() override {
    write(level_with(1));
    session_.apply(action::OpenFile{file()});
    ASSERT_EQ(session_.path(), file());
  }

  std::string file() const { return path("level.talus.json"); }
  // A level with a tile in its first cell.
  static Level level_with(TileNumber tile) {
    Level level;
    level.map = TileMap(4, 4);
    level.map.set({0, 0}, tile);
    return level;
  }
  void write(const Level& level) const { ASSERT_TRUE(save_level(level, *find_format("native"), file())); }
  void edit(TileNumber tile) {
    Edit edit{"Paint", {CellChange{{0, 0}, first_tile(), tile}}};
    session_.apply(action::EditLevel{edit});
  }
  TileNumber first_tile() const { return session_.level().map.tile_at({0, 0}); }

  Session session_;
};

TEST_F(FileChangeTest, AnUnchangedFileGivesNoMessage) {
  session_.apply(action::CheckFile{});
  EXPECT_FALSE(session_.message());
  EXPECT_FALSE(session_.question());
  EXPECT_TRUE(session_.history().edits().empty());
}

TEST_F(FileChangeTest, ATouchedFileGivesNoMessage) {
  write(level_with(1));  // replaced by a rename: another time, the same bytes
  session_.apply(action::CheckFile{});
  EXPECT_FALSE(session_.message());
  EXPECT_FALSE(session_.question());
}

TEST_F(FileChangeTest, AnUnchangedLevelIsReadAgainWithUndo) {
  write(level_with(7));
  session_.apply(action::CheckFile{});
  EXPECT_EQ(first_tile(), 7);
  EXPECT_FALSE(session_.modified());
  ASSERT_TRUE(session_.message()) << "never silently";
  EXPECT_FALSE(session_.message()->is_error);
  session_.apply(action::Undo{});
  EXPECT_EQ(first_tile(), 1);
  EXPECT_TRUE(session_.modified());
  session_.apply(action::Redo{});
  EXPECT_EQ(session_.level(), level_with(7));
  EXPECT_FALSE(session_.modified());
}

TEST_F(FileChangeTest, AnotherTileSizeIsSaid) {
  edit(3);
  Level other = level_with(1);
  other.map = TileMap(4, 4, {16, 16});
  write(other);
  session_.apply(action::CheckFile{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(
      session_.question()->text,
      "level.talus.json was changed by another program.\nIt cannot be merged with what was changed here, "
      "as the tiles have 16x16 px there, and 8x8 px here. Take all of mine or all of theirs? Undo takes "
      "it back.");
  session_.apply(action::AnswerQuestion{action::Answer::reload});
  EXPECT_EQ(session_.level(), other);
  session_.apply(action::Undo{});
  EXPECT_EQ(first_tile(), 3);
}

// The new file takes longer to read than the window waits.
TEST_F(FileChangeTest, ACancelledRereadLeavesTheLevelModified) {
  std::string large = R"({"talus":1,"x":[{"a":0})";
  for (int i = 0; i < 2'400'000; ++i) large += R"(,{"a":0})";
  std::ofstream(file()) << large << "]}";
  session_.apply(action::CheckFile{});
  ASSERT_TRUE(session_.reading());
  EXPECT_FALSE(session_.modified());
  session_.apply(action::CancelReading{});
  EXPECT_FALSE(session_.reading());
  EXPECT_EQ(session_.level(), level_with(1));
  EXPECT_TRUE(session_.modified()) << "the file has something else";
  session_.apply(action::CheckFile{});
  session_.finish_reading();
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::changed_outside);
}

// Saving waits until the newer file is read, and goes on by itself.
TEST_F(FileChangeTest, SavingOverALargeFileMergesFirst) {
  edit(3);
  std::string large = R"("x":[{"a":0})";
  for (int i = 0; i < 100'000; ++i) large += R"(,{"a":0})";
  std::string newer = bytes_of("level.talus.json");
  newer.insert(newer.find('{') + 1, large + "],");
  std::ofstream(file()) << newer;
  session_.apply(action::SaveFile{});
  session_.finish_reading();
  ASSERT_FALSE(session_.question()) << session_.question()->text;
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(first_tile(), 3);
  EXPECT_GT(fs::file_size(file()), large.size() / 2) << "what Talus does not know is kept";
}

TEST_F(FileChangeTest, ARecoveredLevelWithoutItsFileIsModified) {
  fs::remove(file());
  session_.apply(action::RecoverLevel{std::make_shared<const Level>(level_with(3)), file(), "level"});
  EXPECT_EQ(first_tile(), 3);
  EXPECT_TRUE(session_.modified());
  session_.apply(action::Undo{});
  EXPECT_TRUE(session_.modified()) << "the state before the edit is in no file either";
}

TEST_F(FileChangeTest, WithUnsavedChangesItAsksAndKeeps) {
  edit(3);
  write(level_with(7));
  session_.apply(action::CheckFile{});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::merge);
  EXPECT_EQ(first_tile(), 3);
  session_.apply(action::AnswerQuestion{action::Answer::keep});
  EXPECT_EQ(first_tile(), 3);
  EXPECT_TRUE(session_.modified());
  session_.apply(action::CheckFile{});
  EXPECT_FALSE(session_.question()) << "each state of the file is asked about once";
  session_.apply(action::SaveFile{});
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(load_level(file())->level.map.at({0, 0}), 3);
}

TEST_F(FileChangeTest, WithUnsavedChangesItAsksAndReadsAgain) {
  edit(3);
  write(level_with(7));
  session_.apply(action::CheckFile{});
  session_.apply(action::AnswerQuestion{action::Answer::reload});
  EXPECT_EQ(first_tile(), 7);
  EXPECT_FALSE(session_.modified());
  session_.apply(action::Undo{});
  EXPECT_EQ(first_tile(), 3) << "the unsaved change is still there";
}

TEST_F(FileChangeTest, SavingDoesNotReplaceWhatAnotherProgramWrote) {
  edit(3);
  write(level_with(7));
  session_.apply(action::SaveFile{});  // before the session has noticed the change
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::merge);
  EXPECT_EQ(load_level(file())->level.map.at({0, 0}), 7);
  session_.apply(action::AnswerQuestion{action::Answer::keep});
  session_.apply(action::SaveFile{});
  EXPECT_EQ(load_level(file())->level.map.at({0, 0}), 3);
}

TEST_F(FileChangeTest, AHalfWrittenFileIsReadWhenItIsWhole) {
  std::ofstream(file()) << "{ half a lev";
  session_.apply(action::CheckFile{});
  write(level_with(7));
  session_.apply(action::CheckFile{});
  EXPECT_EQ(first_tile(), 7);
  EXPECT_FALSE(session_.modified());
}

TEST_F(FileChangeTest, ChangesInOtherPlacesAreMergedWithoutAQuestion) {
  edit(3);
  Level other = level_with(1);
  other.map.set({2, 2}, 9);
  write(other);
  session_.apply(action::CheckFile{});
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(first_tile(), 3);
  EXPECT_EQ(session_.level().map.at({2, 2}), 9);
  EXPECT_TRUE(session_.modified()) << "the file lacks what was changed here";
  session_.apply(action::SaveFile{});
  EXPECT_EQ(load_level(file())->level.map.at({0, 0}), 3);
  EXPECT_EQ(load_level(file())->level.map.at({2, 2}), 9);
  session_.apply({action::Undo{}, action::Undo{}});
  EXPECT_EQ(first_tile(), 1);
}

TEST_F(FileChangeTest, NotNowChangesNothingAndSavingAsksAgain) {
  edit(3);
  write(level_with(7));
  session_.apply(action::CheckFile{});
  ASSERT_TRUE(session_.question());
  EXPECT_TRUE(session_.question()->text.find("Both changed 1 cell,") != std::string::npos)
      << session_.question()->text;
  session_.apply(action::AnswerQuestion{action::Answer::cancel});
  session_.apply(action::CheckFile{});
  EXPECT_FALSE(session_.question());
  EXPECT_EQ(first_tile(), 3);
  session_.apply(action::SaveFile{});
  EXPECT_TRUE(session_.question());
  EXPECT_EQ(load_level(file())->level.map.at({0, 0}), 7);
}

TEST_F(FileChangeTest, SavingMergesWhatDoesNotMeetAndSavesBoth) {
  edit(3);
  Level other = level_with(1);
  other.map.set({2, 2}, 9);
  write(other);
  session_.apply(action::SaveFile{});  // before the session has noticed the change
  EXPECT_FALSE(session_.question());
  EXPECT_FALSE(session_.modified());
  EXPECT_EQ(load_level(file())->level.map.at({0, 0}), 3);
  EXPECT_EQ(load_level(file())->level.map.at({2, 2}), 9);
}

TEST_F(FileChangeTest, QuittingAsksAboutTheFileBeforeItReplacesIt) {
  edit(3);
  write(level_with(7));
  session_.apply(action::Quit{});
  session_.apply(action::AnswerQuestion{action::Answer::save});
  ASSERT_TRUE(session_.question());
  EXPECT_EQ(session_.question()->kind, Question::Kind::merge);
  EXPECT_FALSE(session_.wants_quit());
}

TEST_F(FileChangeTest, ARemovedFileIsReportedOnceAndTheLevelModified) {
  fs::remove(file());
  session_.apply(action::CheckFile{});
  ASSERT_TRUE(session_.message());
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_TRUE(session_.modified());
  session_.apply(action::DismissMessage{});
  session_.apply(action::CheckFile{});
  EXPECT_FALSE(session_.message());
  session_.apply(action::SaveFile{});
  EXPECT_TRUE(fs::exists(file()));
  EXPECT_FALSE(session_.modified());
}

TEST_F(FileChangeTest, AFileThatComesBackChangedIsAskedAbout) {
  fs::remove(file());
  session_.apply(action::CheckFile{});
  write(level_with(7));
  session_.apply(action::CheckFile{});
  EXPECT_EQ(first_tile(), 7) << "nothing was changed here";
  session_.apply(action::Undo{});
  EXPECT_EQ(first_tile(), 1);
}

TEST_F(FileChangeTest, ADamagedFileIsReportedAndChangesNothing) {
  std::ofstream(file()) << "{ half a lev";
  session_.apply(action::CheckFile{});
  EXPECT_FALSE(session_.message()) << "another program may be writing it";
  for (int i = 0; i < 3; ++i) session_.apply(action::CheckFile{});
  ASSERT_TRUE(session_.message());
  EXPECT_TRUE(session_.message()->is_error);
  EXPECT_EQ(first_tile(), 1);
  EXPECT_TRUE(session_.modified());
  write(level_with(7));
  session_.apply(action::CheckFile{});
  EXPECT_EQ(first_tile(), 7) << "the whole file that follows is another change";
}

TEST_F(FileChangeTest, SavingACartGivesItANewTimeAtOnce) {
  const std::string cart = path("game.tic");
  session_.apply(action::SaveFileAs{cart});
  ASSERT_EQ(session_.path(), cart);
  struct stat first = {};
  ASSERT_EQ(::stat(cart.c_str(), &first), 0);
  const timespec past[2] = {{first.st_mtim.tv_sec - 10, 0}, {first.st_mtim.tv_sec - 10, 0}};
  ASSERT_EQ(::utimensat(AT_FDCWD, cart.c_str(), past, 0), 0);
  edit(9);
  session_.apply(action::SaveFile{});
  struct stat second = {};
  ASSERT_EQ(::stat(cart.c_str(), &second), 0);
  // TIC-80 reads a cart again if its time, in whole seconds, has increased.
  EXPECT_GE(second.st_mtim.tv_sec, first.st_mtim.tv_sec);
  EXPECT_NE(second.st_ino, first.st_ino) << "in place at once, never half written";
  EXPECT_EQ(load_level(cart)->level.map.at({0, 0}), 9);
  EXPECT_FALSE(session_.question()) << "the same content at another time is no change";
}

class FileStamps : public FolderTest {};

TEST_F(FileStamps, SeparatesContentFromTime) {
  const std::string file = path("stamped");
  ASSERT_TRUE(write_file_atomic(file, "one"));
  FileStamp stamp = *stamp_of_file(file);
  EXPECT_EQ(stamp.size, 3);
  EXPECT_EQ(file_change(file, stamp), FileChange::none);
  ASSERT_TRUE(write_file_atomic(file, "two"));
  EXPECT_EQ(file_change(file, stamp), FileChange::content);
  fs::remove(file);
  EXPECT_EQ(file_change(file, stamp), FileChange::gone);
  EXPECT_FALSE(stamp_of_file(file));
}

TEST_F(FileStamps, OfALevelTellWithoutReadingWhatMayHaveChanged) {
  const std::string file = path("a.talus.json"), picture = path("t.png");
  ASSERT_TRUE(write_file_atomic(file, "one"));
  LevelStamp stamp = *stamp_of_level(file);
  add_linked({picture}, time_for_stamps(), stamp);
  EXPECT_FALSE(may_have_changed(file, stamp));
  ASSERT_TRUE(write_file_atomic(picture, "new"));
  EXPECT_TRUE(may_have_changed(file, stamp));
  EXPECT_EQ(level_change(file, stamp).file, picture);
  stamp = *stamp_of_level(file);
  add_linked({picture}, time_for_stamps(), stamp);
  ASSERT_TRUE(write_file_atomic(file, "one"));
  EXPECT_TRUE(may_have_changed(file, stamp)) << "another file with the same bytes";
  EXPECT_EQ(level_change(file, stamp).change, FileChange::none);
  EXPECT_FALSE(may_have_changed(file, stamp));
  fs::remove(picture);
  EXPECT_TRUE(may_have_changed(file, stamp));
}

}  // namespace talus::file_change_test
