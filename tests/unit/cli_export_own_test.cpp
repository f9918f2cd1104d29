// talus export into places with files: the user's own files stay, and files of exports are replaced.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <talus/formats/format.h>
#include "cli_answer.h"
#include "folder_test.h"

namespace talus::cli_export_own_test {

namespace fs = std::filesystem;
using testing::HasSubstr;

class CliOwnFiles : public FolderTest {
 protected:
  void SetUp() override { save(level_); }
  void save(const Level& level) const {
    ASSERT_TRUE(save_level(level, *find_format("native"), path("cave.talus.json")));
  }
  // Changes the level so that every export of it changes.
  void change() {
    ++level_.sheet(SheetId::tiles).images[1][0];
    level_.map.set({3, 3}, level_.sheet(SheetId::tiles).images[1][0]);
    save(level_);
  }
  int run(std::vector<std::string> words) {
    words.insert(words.begin(), {"export", path("cave.talus.json")});
    answer_ = cli_answer(words);
    return answer_.status;
  }
  int run_to(const char* format, const std::string& name, const char* option = nullptr) {
    std::vector<std::string> words = {"--to", format, "-o", path(name)};
    if (option != nullptr) words.emplace_back(option);
    return run(words);
  }
  void forget() const { fs::remove_all(path(".state")); }

  Level level_;
  CliAnswer answer_;
};

TEST_F(CliOwnFiles, ChangedStartersAreKept) {
  const std::pair<const char*, std::vector<const char*>> starters[] = {
      {"love", {"main.lua", "conf.lua"}},
      {"bump", {"main.lua", "conf.lua"}},
      {"cpp", {"main.cpp", "CMakeLists.txt", "bodies.cpp", "painter.h"}}};
  for (const auto& [format, names] : starters) {
    const std::string game = format;
    ASSERT_EQ(run_to(format, game), 0) << answer_.err;
    const std::string begun = bytes_of(game + "/" + names[0]);
    for (const char* name : names) put(game + "/" + name, "mine");
    ASSERT_EQ(run_to(format, game), 0) << answer_.err;
    for (const char* name : names) {
      EXPECT_EQ(bytes_of(game + "/" + name), "mine");
      EXPECT_THAT(answer_.err,
                  HasSubstr(path(game + "/" + name) +
                            ": note: kept, as this file is yours now; --fresh writes it anew\n"));
    }
    ASSERT_EQ(run_to(format, game, "--fresh"), 0) << answer_.err;
    EXPECT_EQ(bytes_of(game + "/" + names[0]), begun);
    EXPECT_THAT(answer_.err, testing::Not(HasSubstr("kept")));
  }
}

TEST_F(CliOwnFiles, StartersOfAnotherExportAreReplaced) {
  ASSERT_EQ(run_to("bump", "game"), 0) << answer_.err;
  const std::string of_bump = bytes_of("game/main.lua");
  ASSERT_EQ(run_to("love", "game"), 0) << answer_.err;
  EXPECT_NE(bytes_of("game/main.lua"), of_bump);
}

TEST_F(CliOwnFiles, FilesThatWereNotNamedAreNotReplaced) {
  put("cave-tiles.png", "art");
  EXPECT_EQ(run_to("tmj", "cave.tmj"), 1);
  EXPECT_EQ(answer_.err,
            path("cave-tiles.png") +
                ": error: exists, and is not an export: move it away, or replace it with --force\n");
  EXPECT_EQ(bytes_of("cave-tiles.png"), "art");
  EXPECT_FALSE(exists("cave.tmj")) << "nothing is written";
  put("cave.tmj", "a map of mine");
  EXPECT_EQ(run_to("tmj", "cave.tmj"), 1) << "it names nothing of Talus";
  EXPECT_EQ(run_to("tmj", "cave.tmj", "--force"), 0) << answer_.err;
  EXPECT_NE(bytes_of("cave-tiles.png"), "art");
}

TEST_F(CliOwnFiles, ANamedFileIsReplaced) {
  put("cave.tic", "old");
  EXPECT_EQ(run_to("tic", "cave.tic"), 0) << answer_.err;
  EXPECT_NE(bytes_of("cave.tic"), "old");
}

TEST_F(CliOwnFiles, ExportsAreReplacedWheneverTheLevelChanges) {
  for (const auto& [format, name] : {std::pair("tmj", "cave.tmj"), std::pair("sti", "cave.lua"),
                                     std::pair("csv", "tables"), std::pair("love", "game")}) {
    for (int i = 0; i < 3; ++i) {
      ASSERT_EQ(run_to(format, name), 0) << format << answer_.err;
      EXPECT_EQ(answer_.err, "");
      change();
    }
  }
}

TEST_F(CliOwnFiles, FilesChangedSinceAreNotReplaced) {
  ASSERT_EQ(run_to("love", "game"), 0) << answer_.err;
  put("game/level.lua", "mine");
  const std::string talus = bytes_of("game/talus.lua");
  EXPECT_EQ(run_to("love", "game"), 1);
  EXPECT_EQ(answer_.err,
            path("game/level.lua") +
                ": error: was changed since it was exported: move it away, or replace it with --force\n");
  EXPECT_EQ(bytes_of("game/level.lua"), "mine");
  EXPECT_EQ(bytes_of("game/talus.lua"), talus);
}

// The export was made on another machine, or its folder was moved.
TEST_F(CliOwnFiles, AWholeExportIsKnownWithoutARecord) {
  ASSERT_EQ(run_to("tmj", "cave.tmj"), 0) << answer_.err;
  ASSERT_EQ(run_to("lua-runtime", "game"), 0) << answer_.err;
  forget();
  change();
  EXPECT_EQ(run_to("tmj", "cave.tmj"), 0) << answer_.err;
  EXPECT_EQ(run_to("lua-runtime", "game"), 0) << answer_.err;
  forget();
  fs::remove(path("game/talus.lua"));
  change();
  EXPECT_EQ(run_to("lua-runtime", "game"), 1) << "level.lua alone may be anybody's";
}

TEST_F(CliOwnFiles, TheLevelIsNeverReplacedByAFileBesideTheExport) {
  const std::string file = path("level.talus.json");
  fs::rename(path("cave.talus.json"), file);
  const std::string before = bytes_of("level.talus.json");
  const CliAnswer answer =
      cli_answer({"export", file, "--to", "cpp", "-o", folder_.string(), "--force", "--fresh"});
  EXPECT_EQ(answer.status, 1);
  EXPECT_EQ(
      answer.err,
      file + ": error: is an input of this command, which the export would overwrite: name another place\n");
  EXPECT_EQ(bytes_of("level.talus.json"), before);
  EXPECT_FALSE(exists("main.cpp"));
}

TEST_F(CliOwnFiles, PresetsThatOverwriteEachOtherWriteNothing) {
  level_.exports = {{.name = "data", .exporter = "lua", .path = "out/a.lua", .extra = ""},
                    {.name = "cart", .exporter = "tic", .path = "out/a.tic", .extra = ""},
                    {.name = "map", .exporter = "sti", .path = "out/a.lua", .extra = ""}};
  save(level_);
  EXPECT_EQ(run({"--all"}), 1);
  EXPECT_EQ(answer_.err, path("cave.talus.json") +
                             ": error: the presets \"data\" and \"map\" would both write out/a.lua: give one "
                             "of them another path\n");
  EXPECT_FALSE(exists("out"));
  EXPECT_EQ(run({"--preset", "map", "--preset", "cart"}), 0) << answer_.err;
  EXPECT_TRUE(exists("out/a-tiles.png"));
}

TEST_F(CliOwnFiles, ATextCartHasTheNameOfItsLanguage) {
  for (const char* ending : {"js", "wren", "rb", "fnl", "moon"}) {
    const std::string name = std::string("x.") + ending;
    for (const char* option : {static_cast<const char*>(nullptr), "--playable"}) {
      EXPECT_EQ(run_to("tic-text", name, option), 1);
      EXPECT_EQ(answer_.err, path("cave.talus.json") + ": error: the cart's code does not fit the name " +
                                 name + ": in its language the name must end with .lua\n");
      EXPECT_FALSE(exists(name));
    }
  }
  EXPECT_EQ(run_to("tic-text", "x.lua", "--playable"), 0) << answer_.err;
  put("mine.js",
      "// script: js\nfunction TIC() {}\n// <TILES>\n// 000:" + std::string(64, '1') + "\n// </TILES>\n");
  const CliAnswer kept = cli_answer({"export", path("mine.js"), "--to", "tic-text", "-o", path("out.js")});
  EXPECT_EQ(kept.status, 0) << kept.err;
  const CliAnswer other = cli_answer({"export", path("mine.js"), "--to", "tic-text", "-o", path("out.lua")});
  EXPECT_EQ(other.status, 1);
  EXPECT_THAT(other.err, HasSubstr("the name must end with .js\n"));
}

TEST_F(CliOwnFiles, ATextCartOfYueHasOneOfTwoExtensions) {
  put("mine.yue",
      "-- script: yue\nTIC = -> cls 0\n-- <TILES>\n-- 000:" + std::string(64, '1') + "\n-- </TILES>\n");
  for (const char* name : {"out.yue", "out.lua"}) {
    const CliAnswer answer = cli_answer({"export", path("mine.yue"), "--to", "tic-text", "-o", path(name)});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(bytes_of(name), bytes_of("mine.yue"));
  }
  EXPECT_EQ(cli_answer({"import", path("out.lua"), "-o", path("level.talus.json")}).status, 0);
  EXPECT_EQ(cli_answer({"export", path("level.talus.json"), "--to", "tic-text", "-o", path("out.moon")}).err,
            path("level.talus.json") +
                ": error: the cart's code does not fit the name out.moon: in its language the name must end "
                "with .yue\n");
}

TEST_F(CliOwnFiles, ACartWithTooMuchCodeGivesAWarning) {
  // The shapes alone make the level larger than a cart.
  for (int i = 0; i < 2000; ++i) {
    const double at = i % 200;
    level_.curves.push_back({"", {Segment{{at, i / 10.0}, {at + 3.25, 100.125}}, Curve::Faces::up}, ""});
  }
  save(level_);
  EXPECT_EQ(run_to("tic", "cave.tic", "--playable"), 0);
  EXPECT_THAT(answer_.err,
              testing::ContainsRegex("cave.tic: warning: the code has [0-9,]+ bytes, but TIC-80's free "
                                     "version allows only 65,536: use fewer shapes or kinds of bodies\n"));
  EXPECT_EQ(run_to("tic", "cave.tic"), 0);
  EXPECT_EQ(answer_.err.find("the code has"), std::string::npos) << "that is the user's own";
}

TEST_F(CliOwnFiles, AFolderThatCannotBeMadeIsNamed) {
  EXPECT_EQ(run({"--to", "love", "-o", "/proc/x"}), 1);
  EXPECT_THAT(answer_.err, testing::StartsWith("/proc/x: error: the folder /proc/x cannot be created: "));
}

}  // namespace talus::cli_export_own_test
