// Command lines of other programs: split without a shell, started as processes of their own.
#include "platform/external_program.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "edit/export_presets.h"
#include "edit/level_settings.h"
#include "folder_test.h"
#include "paths.h"
#include "platform/game_start.h"
#include "waiting.h"

namespace talus::external_program_test {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

TEST(SplitCommand, SplitsIntoWords) {
  EXPECT_EQ(split_command("tic80 {file}", "/a/b.tic"), (Words{"tic80", "/a/b.tic"}));
  EXPECT_EQ(split_command("  love   {folder}\t", "/a/b.tic"), (Words{"love", "/a"}));
  EXPECT_EQ(split_command("x \"two words\" 'a \"b\"' \"\"", "f"), (Words{"x", "two words", "a \"b\"", ""}));
  EXPECT_EQ(split_command("x --open={file}", "/c.tic"), (Words{"x", "--open=/c.tic"}));
}

TEST(SplitCommand, KeepsAnyFileNameInOneWord) {
  const std::string file = "/home/a b/$(touch x); \"'{folder}'\" `y`.tic";
  EXPECT_EQ(split_command("tic80 {file}", file), (Words{"tic80", file}));
}

TEST(SplitCommand, SaysWhatIsWrong) {
  EXPECT_EQ(split_command("", "f").error(), "The command is empty.");
  EXPECT_EQ(split_command("  ", "f").error(), "The command is empty.");
  EXPECT_EQ(split_command("x \"y", "f").error(), "A \" is missing at the end of the command.");
  EXPECT_EQ(split_command("x {fill}", "f").error(), "{fill} is unknown: write {file} or {folder}.");
  EXPECT_FALSE(split_command("x {file", "f"));
}

class ExternalProgramTest : public FolderTest {
 protected:
  void SetUp() override {
    // Writes its arguments, one on each line, and puts the finished file in place at once.
    put("program", "#!/bin/sh\nprintf '%s\\n' \"$@\" > \"" + path("part") + "\"\nmv \"" + path("part") +
                       "\" \"" + path("told") + "\"\n");
    ASSERT_EQ(::chmod(path("program").c_str(), 0755), 0);
  }

  // The arguments that the program got. Waits for them.
  std::string told() const {
    EXPECT_TRUE(comes_true([&] { return exists("told"); }));
    return bytes_of("told");
  }
  // Saves the session to this file, and then changes the level.
  void save_and_paint(Session& session, const std::string& name) const {
    session.apply(action::SaveFileAs{path(name)});
    session.apply(action::EditLevel{{"Paint", {CellChange{{0, 0}, 0, 4}}}});
  }
  ProgramCommands commands() const {
    ProgramCommands all = default_program_commands();
    all[0] = all[2] = "\"" + path("program") + "\" {file}";
    all[1] = "\"" + path("program") + "\" {folder}";
    return all;
  }
  void paint(Session& session, TileNumber tile) const {
    session.apply(
        action::EditLevel{{"Paint", {CellChange{{0, 0}, session.level().map.tile_at({0, 0}), tile}}}});
  }
  void save(Session& session) {
    session.apply(action::SaveFile{});
    ASSERT_FALSE(session.modified());
    copies_.follow(session);
  }
  int first_tile(const std::string& name) const { return load_level(path(name))->level.map.tile_at({0, 0}); }

  OpenCopies copies_{path("copies")};
};

TEST_F(ExternalProgramTest, StartsWithItsArguments) {
  ASSERT_TRUE(start_detached({path("program"), "a b", "$HOME; exit"}));
  EXPECT_EQ(told(), "a b\n$HOME; exit\n");
}

TEST_F(ExternalProgramTest, AMissingProgramIsAnError) {
  const auto started = start_detached({path("nothing here")});
  ASSERT_FALSE(started);
  EXPECT_EQ(started.error(), path("nothing here") + " cannot be started: No such file or directory.");
}

TEST_F(ExternalProgramTest, ACartIsSavedAndOpenedItself) {
  Session session;
  save_and_paint(session, "my game.tic");
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  EXPECT_EQ(told(), path("my game.tic") + "\n");
  EXPECT_FALSE(session.modified());
  EXPECT_EQ(load_level(path("my game.tic"))->level.map.at({0, 0}), 4);
  ASSERT_TRUE(session.message());
  EXPECT_FALSE(session.message()->is_error) << session.message()->text;
}

TEST_F(ExternalProgramTest, ALevelOfAnotherFormatIsOpenedAsACopy) {
  Session session;
  save_and_paint(session, "level.talus.json");
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  EXPECT_EQ(told(), path("copies/level.tic") + "\n");
  EXPECT_TRUE(session.modified()) << "its own file was left alone";
  EXPECT_EQ(load_level(path("copies/level.tic"))->level.map.at({0, 0}), 4);
}

TEST_F(ExternalProgramTest, ACopyHasACompanionForWhatACartCannotHold) {
  Session session;
  save_and_paint(session, "level.talus.json");
  const auto place = [&](std::size_t spawns) {
    session.apply(action::EditLevel{set_spawns(session.level(), std::vector<Spawn>(spawns), "Place")});
  };
  place(2);
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  EXPECT_TRUE(session.message()->text.starts_with("Wrote a copy of the level")) << session.message()->text;
  EXPECT_EQ(session.message()->text.find("Not in it"), std::string::npos);
  EXPECT_EQ(load_level(path("copies/level.tic"))->level.spawns, session.level().spawns);
  place(0);
  save(session);
  EXPECT_TRUE(load_level(path("copies/level.tic"))->level.spawns.empty())
      << "an older companion adds no bodies";
  EXPECT_EQ(load_level(path("copies/level.tic"))->note, "");
}

TEST_F(ExternalProgramTest, TiledOpensACopyWithItsPicture) {
  Session session;
  save_and_paint(session, "level.talus.json");
  open_in_program(session, ProgramId::tiled, commands(), copies_);
  EXPECT_EQ(told(), path("copies/level.tmj") + "\n");
  EXPECT_TRUE(session.modified()) << "its own file was left alone";
  EXPECT_TRUE(load_level(path("copies/level.tmj"))->level == session.level());
  EXPECT_TRUE(exists("copies/level-tiles.png"));
}

TEST_F(ExternalProgramTest, CopiesFollowSaves) {
  Session session;
  save_and_paint(session, "level.talus.json");
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  open_in_program(session, ProgramId::tiled, commands(), copies_);
  paint(session, 5);
  copies_.follow(session);
  EXPECT_EQ(first_tile("copies/level.tic"), 4) << "nothing was saved";
  save(session);
  EXPECT_EQ(first_tile("copies/level.tic"), 5);
  EXPECT_EQ(first_tile("copies/level.tmj"), 5);
  EXPECT_EQ(session.message()->text,
            "Saved level.talus.json. Wrote the copy for TIC-80 again. Wrote the copy for Tiled again.");
  EXPECT_FALSE(session.message()->is_error);

  session.apply(action::SaveFileAs{path("other.talus.json")});
  paint(session, 6);
  save(session);
  EXPECT_EQ(first_tile("copies/level.tic"), 5) << "it is a copy of the other file";
}

TEST_F(ExternalProgramTest, CopiesOfAnUnnamedLevelFollowItsFirstSave) {
  Session session;
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  ASSERT_TRUE(exists("copies/untitled.tic"));
  paint(session, 5);
  session.apply(action::SaveFileAs{path("level.talus.json")});
  copies_.follow(session);
  EXPECT_EQ(first_tile("copies/untitled.tic"), 5);
  copies_.forget();  // another level is opened
  paint(session, 6);
  save(session);
  EXPECT_EQ(first_tile("copies/untitled.tic"), 5);
}

TEST_F(ExternalProgramTest, AChangeByAnotherProgramStaysInItsCopy) {
  Session session, other;
  save_and_paint(session, "level.talus.json");
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  paint(other, 9);
  ASSERT_TRUE(save_level(other.level(), *find_format("tic"), path("copies/level.tic")));
  save(session);
  EXPECT_EQ(first_tile("copies/level.tic"), 9);
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_NE(session.message()->text.find("The copy for TIC-80 was changed by another program"),
            std::string::npos);
  paint(session, 5);
  save(session);
  EXPECT_FALSE(session.message()->is_error) << "the error is shown only once";

  OpenCopies later(path("copies"));  // the program was started again
  open_in_program(session, ProgramId::tic80, commands(), later);
  EXPECT_EQ(first_tile("copies/level.tic"), 5);
  EXPECT_EQ(first_tile("copies/level-kept1.tic"), 9);
  EXPECT_NE(session.message()->text.find("kept as " + path("copies/level-kept1.tic")), std::string::npos);
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  EXPECT_FALSE(exists("copies/level-kept2.tic")) << "what was there is the program's own";
}

TEST_F(ExternalProgramTest, ACopyThatCannotBeWrittenIsReported) {
  Session session;
  save_and_paint(session, "level.talus.json");
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  fs::remove_all(path("copies"));
  put("copies", "a file, no folder");
  save(session);
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_NE(session.message()->text.find("The copy for TIC-80 cannot be written again"), std::string::npos);
}

TEST_F(ExternalProgramTest, AGameRunsInTheFolderOfItsLevel) {
  Session session;
  open_in_program(session, ProgramId::love, commands(), copies_);
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->is_error) << "a level without a file belongs to no game";
  session.apply(action::SaveFileAs{path("level.talus.json")});
  open_in_program(session, ProgramId::love, commands(), copies_);
  EXPECT_EQ(told(), folder_.string() + "\n");
}

TEST_F(ExternalProgramTest, AGameRunsInTheFolderThatItIsExportedTo) {
  Session session(Level(), "", kUnnamed, ExportTools{[](const std::string& name) {
                    return read_file(source_path("assets/") + name);
                  }});
  GameStart game;
  session.apply(action::SaveFileAs{path("level.talus.json")});
  put("main.lua", "-- of a game");
  EXPECT_FALSE(game.begin(session, commands())) << "the level is in the folder of a game";
  session.apply(action::EditLevel{
      add_export(session.level(), {.name = "map", .exporter = "tmj", .path = "map.tmj", .extra = ""})});
  session.apply(action::EditLevel{
      add_export(session.level(), {.name = "game", .exporter = "love", .path = "my game", .extra = ""})});
  session.apply(action::SaveFileAs{path("level.talus.json")});
  paint(session, 4);
  ASSERT_TRUE(game.begin(session, commands()));
  EXPECT_TRUE(session.modified()) << "nobody has asked to save it";
  EXPECT_TRUE(comes_true([&] {
    session.advance(0);
    game.follow(session, commands());
    return exists("told");
  }));
  EXPECT_EQ(told(), path("my game") + "\n");
  EXPECT_TRUE(exists("my game/main.lua")) << "the game is exported before it starts";
  EXPECT_FALSE(exists("map.tmj"));
  EXPECT_EQ(session.message()->text, "Opened " + path("my game") + " in LÖVE.");
}

TEST_F(ExternalProgramTest, AGameOfAForeignPresetIsNotRunBeforeAnAnswer) {
  Level level;
  level.exports = {{.name = "game", .exporter = "love", .path = "game", .extra = ""}};
  ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
  Session session(Level(), "", kUnnamed, ExportTools{[](const std::string& name) {
                    return read_file(source_path("assets/") + name);
                  }});
  session.apply(action::OpenFile{path("level.talus.json")});
  GameStart game;
  ASSERT_TRUE(game.begin(session, commands()));
  const auto follow = [&] {
    session.advance(0);
    game.follow(session, commands());
  };
  ASSERT_TRUE(comes_true([&] {
    follow();
    return session.question().has_value();
  }));
  EXPECT_EQ(session.question()->kind, Question::Kind::allow_exports);
  session.apply(action::AnswerQuestion{action::Answer::cancel});
  for (int i = 0; i < 100 || session.exporting().is_busy(); ++i) follow();
  EXPECT_FALSE(exists("told"));
  EXPECT_FALSE(exists("game"));
}

// A name that begins with a dash must not become an option of the program.
TEST_F(ExternalProgramTest, FilesAreGivenByWholePaths) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_);
  Session session;
  session.apply(action::SaveFileAs{"-x.tic"});
  open_in_program(session, ProgramId::tic80, commands(), copies_);
  fs::current_path(before);
  EXPECT_EQ(told(), path("-x.tic") + "\n");
}

TEST_F(ExternalProgramTest, AWrongCommandIsReportedBeforeAnySave) {
  Session session;
  save_and_paint(session, "game.tic");
  ProgramCommands wrong = commands();
  wrong[0] = "tic80 {fil}";
  open_in_program(session, ProgramId::tic80, wrong, copies_);
  ASSERT_TRUE(session.message());
  EXPECT_TRUE(session.message()->is_error);
  EXPECT_NE(session.message()->text.find("{fil} is unknown"), std::string::npos);
  EXPECT_TRUE(session.modified());
}

}  // namespace talus::external_program_test
