// talus export --all: where the presets of a level may write when there is nobody to ask.
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <talus/formats/format.h>
#include "cli_answer.h"
#include "folder_test.h"
#include "platform/user_folder.h"
#include "session/files/export_permissions.h"

namespace talus::cli_export_safety_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CliPresetPaths : public FolderTest {
 protected:
  void SetUp() override { fs::create_directories(path("level")); }
  void save(const std::string& exporter, const std::string& to, TileNumber tile = 0) const {
    Level level;
    level.map.set({1, 1}, tile);
    level.exports = {{.name = "game", .exporter = exporter, .path = to, .extra = ""}};
    ASSERT_TRUE(save_level(level, *find_format("native"), path("level/cave.talus.json")));
  }
  int all(const char* option = nullptr) {
    std::vector<std::string> words = {"export", path("level/cave.talus.json"), "--all"};
    if (option != nullptr) words.emplace_back(option);
    answer_ = cli_answer(words);
    return answer_.status;
  }

  CliAnswer answer_;
};

TEST_F(CliPresetPaths, WriteInTheFolderOfTheLevelWithoutAQuestion) {
  save("lua-runtime", "build/game");
  EXPECT_EQ(all(), 0) << answer_.err;
  EXPECT_TRUE(exists("level/build/game/level.lua"));
  fs::remove_all(path(".state"));
  EXPECT_EQ(all(), 0) << "as on another machine, which has the files and no record: " << answer_.err;
}

TEST_F(CliPresetPaths, StayThereUnlessAllowOutsideIsGiven) {
  fs::create_directories(path("home"));
  fs::create_symlink(path("home"), path("level/link"));
  for (const std::string& to :
       {std::string("../home/a.lua"), path("home/a.lua"), std::string("link/a.lua")}) {
    save("lua", to);
    EXPECT_EQ(all(), 1) << to;
    EXPECT_THAT(answer_.err, HasSubstr("outside of " + fs::canonical(path("level")).string() +
                                       ": to write there, use --allow-outside\n"));
    EXPECT_EQ(all("--force"), 1) << "that is about other things";
    EXPECT_FALSE(exists("home/a.lua"));
    EXPECT_EQ(all("--allow-outside"), 0) << answer_.err;
    EXPECT_TRUE(exists("home/a.lua"));
    fs::remove(path("home/a.lua"));
  }
}

TEST_F(CliPresetPaths, AreNotLedOutByLinksInTheirFolder) {
  fs::create_directories(path("level/export"));
  fs::create_symlink("../../init.lua", path("level/export/level.lua"));
  save("lua-runtime", "export");
  for (const char* option : {static_cast<const char*>(nullptr), "--force", "--fresh"}) {
    EXPECT_EQ(all(option), 1);
    EXPECT_THAT(answer_.err, HasSubstr("level.lua leads to "));
    EXPECT_FALSE(exists("init.lua"));
    EXPECT_FALSE(exists("level/export/talus.lua")) << "nothing of it is written";
  }
  // Nor may an export into a folder that was typed.
  const CliAnswer typed = cli_answer({"export", path("level/cave.talus.json"), "--to", "lua-runtime", "-o",
                                      path("level/export"), "--force"});
  EXPECT_EQ(typed.status, 1);
  EXPECT_FALSE(exists("init.lua"));
}

TEST_F(CliPresetPaths, WithCircularLinksAreNotAdvisedToAllowOutside) {
  fs::create_directories(path("level/export"));
  fs::create_symlink("level.lua", path("level/export/level.lua"));
  save("lua-runtime", "export");
  EXPECT_EQ(all(), 1);
  EXPECT_THAT(answer_.err, HasSubstr("level.lua leads through links in a circle\n"));
}

TEST_F(CliPresetPaths, ReplaceOnlyFilesThatAnExportWrote) {
  save("lua", "main.lua");
  put("level/main.lua", "local talus = require \"talus\"\n");
  EXPECT_EQ(all(), 1);
  EXPECT_EQ(answer_.err,
            path("level/main.lua") +
                ": error: exists, and is not an export: move it away, or replace it with --force\n");
  EXPECT_THAT(bytes_of("level/main.lua"), HasSubstr("require"));
  EXPECT_EQ(all("--force"), 0) << answer_.err;
  EXPECT_EQ(all(), 0) << "by now it is an export";
  fs::remove_all(path(".state"));
  EXPECT_EQ(all(), 0) << "and is known as one without a record: " << answer_.err;
  // Another level is no export, even if an export could have written it.
  save("native", "other.talus.json", 4);
  ASSERT_TRUE(save_level(Level(), *find_format("native"), path("level/other.talus.json")));
  EXPECT_EQ(all(), 1);
  // The target of a link in the folder is not replaced either.
  save("lua", "linked.lua", 5);
  fs::create_symlink("main.lua", path("level/linked.lua"));
  fs::remove_all(path(".state"));
  EXPECT_EQ(all(), 1) << answer_.out;
}

// A text project with a name that another program looks for would be run by that program.
TEST_F(CliPresetPaths, BringNoCodeUnlessItIsAllowed) {
  Level level;
  level.cart = std::make_shared<const CartOrigin>(CartOrigin{
      .kind = CartOrigin::Kind::text, .comment = "#", .bytes = "# script: python\nprint('run')\n"});
  level.exports = {{.name = "code", .exporter = "tic-text", .path = "json.py", .extra = ""},
                   {.name = "data", .exporter = "lua", .path = "data.lua", .extra = ""}};
  ASSERT_TRUE(save_level(level, *find_format("native"), path("level/cave.talus.json")));
  EXPECT_EQ(all(), 1);
  EXPECT_EQ(answer_.err,
            path("level/cave.talus.json") +
                ":preset \"code\": error: writes the level's own code to json.py, which has not been "
                "allowed: allow it in the editor, in File > Export, or by --allow-code\n");
  EXPECT_FALSE(exists("level/json.py"));
  EXPECT_TRUE(exists("level/data.lua")) << "this preset writes no code";
  EXPECT_EQ(all("--force"), 1) << "that is about other things";
  EXPECT_EQ(all("--allow-code"), 0) << answer_.err;
  EXPECT_THAT(bytes_of("level/json.py"), HasSubstr("print('run')"));
  EXPECT_EQ(all(), 1) << "--allow-code holds for one run";

  ExportPermissions permissions(state_folder() + "/" + kPermissionsFile);
  permissions.open(path("level/cave.talus.json"));
  ASSERT_TRUE(permissions.allow(level.exports));
  EXPECT_EQ(all(), 0) << "as after an answer in the window: " << answer_.err;
  level.exports[0].path = "conftest.py";
  ASSERT_TRUE(save_level(level, *find_format("native"), path("level/cave.talus.json")));
  EXPECT_EQ(all(), 1) << "another path was not allowed";
}

// A copy of a level has all of its text, and npm or an editor would run what they find under their names.
TEST_F(CliPresetPaths, CopyALevelOnlyToANameOfLevels) {
  for (const std::string& to : {std::string("package.json"), std::string(".vscode/tasks.json")}) {
    Level level;
    level.extra = R"({"scripts":{"postinstall":"touch /tmp/x"}})";
    level.exports = {{.name = "game", .exporter = "native", .path = to, .extra = ""}};
    ASSERT_TRUE(save_level(level, *find_format("native"), path("level/cave.talus.json")));
    const std::string map = path("level/m.tmx"), cave = path("level/cave.talus.json");
    ASSERT_EQ(cli_answer({"export", cave, "--to", "tmx", "-o", map}).status, 0);
    for (const std::string& file : {cave, map}) {
      for (const char* option : {"--allow-code", "--force", "--allow-outside"}) {
        const CliAnswer answer = cli_answer({"export", file, "--all", option});
        EXPECT_EQ(answer.status, 1);
        EXPECT_THAT(answer.err, HasSubstr(fs::path(to).filename().string() +
                                          " is not a name for a Talus level that a preset writes: it must "
                                          "end with .talus.json, as another program could run"));
      }
      EXPECT_FALSE(exists("level/" + to));
    }
  }
  save("native", "copy.talus.json");
  EXPECT_EQ(all(), 0) << answer_.err;
  const CliAnswer typed = cli_answer(
      {"export", path("level/cave.talus.json"), "--to", "native", "-o", path("level/package.json")});
  EXPECT_EQ(typed.status, 0) << "it is the user's word: " << typed.err;
}

TEST_F(CliPresetPaths, AreRefusedAtOnceForAPipe) {
  ASSERT_EQ(::mkfifo(path("level/data.lua").c_str(), 0600), 0);
  save("lua", "data.lua");
  EXPECT_EQ(all("--force"), 1);
  EXPECT_THAT(answer_.err, HasSubstr("is a device or a pipe, but must be a regular file\n"));
}

TEST_F(CliPresetPaths, FromAMapOfTiledFollowTheSameRules) {
  Level level;
  level.exports = {{.name = "game", .exporter = "lua", .path = "../a.lua", .extra = ""}};
  ASSERT_TRUE(save_level(level, *find_format("native"), path("level/cave.talus.json")));
  ASSERT_EQ(
      cli_answer({"export", path("level/cave.talus.json"), "--to", "tmx", "-o", path("level/m.tmx")}).status,
      0);
  const CliAnswer answer = cli_answer({"export", path("level/m.tmx"), "--all"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_FALSE(exists("a.lua"));
}

}  // namespace talus::cli_export_safety_test
