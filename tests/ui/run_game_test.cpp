// Run in LÖVE, by its key: the game is exported first, and runs in the folder of the export.
#include <sys/stat.h>

#include <fstream>

#include "edit/export_presets.h"
#include "harness.h"

namespace talus::run_game_test {

class UiRunGame : public UiTest {
 protected:
  // Opens a level. Instead of LÖVE, a program runs that writes down its folder.
  void open(const Level& level) {
    ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
    start(path("level.talus.json"));
    const std::string program = path("program");
    std::ofstream(program) << "#!/bin/sh\nprintf '%s' \"$1\" > '" << told << ".part'\nmv '" << told
                           << ".part' '" << told << "'\n";
    ASSERT_EQ(::chmod(program.c_str(), 0755), 0);
    app().ui().view.preferences.programs[static_cast<std::size_t>(ProgramId::love)] =
        "'" + program + "' {folder}";
  }
  const std::string told = path("told");
};

TEST_F(UiRunGame, WithoutAPresetItRunsInAFolderOfTalus) {
  Level level = test_level();
  level.tuning.solver = SolverKind::exact;
  open(level);
  click(on_sheet(1));
  click(on_map({12, 9}));
  for (int i = 0; i < 2; ++i) {
    std::filesystem::remove(told);
    key(ctrl_shift('l'));
    ASSERT_TRUE(frames_until([&] { return std::filesystem::exists(told); }));
    EXPECT_EQ(bytes_of(told), path("state/game"));
    EXPECT_TRUE(std::filesystem::exists(path("state/game/main.lua")));
  }
  EXPECT_TRUE(session().modified()) << "the level is not saved for it";
  EXPECT_TRUE(session().level().exports.empty());
}

TEST_F(UiRunGame, ThePresetIsExportedAndRun) {
  Level level = test_level();
  level.exports = {{.name = "game", .exporter = "love", .path = "my game", .extra = ""}};
  open(level);
  key(ctrl_shift('l'));
  ASSERT_TRUE(frames_until([&] { return session().question().has_value(); }));
  frames(3);
  EXPECT_FALSE(std::filesystem::exists(path("my game"))) << "the preset came with the file";
  click("question/allow");
  ASSERT_TRUE(frames_until([&] { return std::filesystem::exists(told); }));
  EXPECT_EQ(bytes_of(told), path("my game"));
  EXPECT_TRUE(std::filesystem::exists(path("my game/main.lua")));

  const std::string saved = bytes_of(session().path());
  std::filesystem::remove(told);
  click(on_sheet(1));
  click(on_map({12, 9}));
  const std::string game = bytes_of(path("my game/level.lua"));
  key(ctrl_shift('l'));
  ASSERT_TRUE(frames_until([&] { return std::filesystem::exists(told); }));
  EXPECT_NE(bytes_of(path("my game/level.lua")), game) << "the edit is in the game";
  EXPECT_EQ(bytes_of(session().path()), saved) << "the level is not saved for it";
  EXPECT_TRUE(session().modified());
}

TEST_F(UiRunGame, ALevelWithoutAFileIsSavedFirst) {
  open(test_level());
  session().apply(action::NewLevel{});
  frames(3);
  session().apply(action::EditLevel{
      add_export(session().level(), {.name = "game", .exporter = "love", .path = "my game", .extra = ""})});
  frames(2);
  key(ctrl_shift('l'));
  frames(2);
  ASSERT_TRUE(session().wants_save_as());
  session().apply(action::SaveFileAs{path("mine.talus.json")});
  frames(3);
  if (session().question()) click("question/allow");
  ASSERT_TRUE(frames_until([&] { return std::filesystem::exists(told); }));
  EXPECT_EQ(bytes_of(told), path("my game"));
}

}  // namespace talus::run_game_test
