// talus export to folders: what is written, and what is refused.
#include <gtest/gtest.h>

#include "cli_answer.h"
#include "export/exporter.h"
#include "export/lua_level.h"
#include "folder_test.h"

namespace talus::cli_export_test {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + " ";
  return text;
}

Level flat_level() {
  Level level;
  level.map = TileMap(8, 4);
  level.sheet(SheetId::tiles).flags[1] = 1;  // solid
  for (int x = 0; x < 8; ++x) level.map.set({x, 3}, 1);
  return level;
}

TEST(LuaParts, ALevelOfTilesShipsNothingElse) {
  EXPECT_EQ(joined(lua_runtime_parts(flat_level(), false)),
            "base terrain edit cast queries mover balls world ");
}

TEST(LuaParts, WhatALevelUsesIsAdded) {
  Level level = flat_level();
  level.sheet(SheetId::tiles).flags[2] = 1 << 2;  // up-slope
  level.map.set({2, 2}, 2);
  EXPECT_EQ(joined(lua_runtime_parts(level, false)),
            "base slopes terrain details edit cast cast_slopes queries queries_slopes mover balls world ");
  level.spawns.emplace_back().kind = BodyKind::player;
  level.spawns.emplace_back();
  level.curves.push_back({"", {Arc{{30, 20}, 8, 24, 36, true}, Curve::Faces::up}, ""});
  EXPECT_EQ(joined(lua_runtime_parts(level, true)),
            "base slopes curves stretches terrain details edit cast cast_slopes cast_stretches queries "
            "queries_slopes mover mover_stretches balls pairs players mouse world ");
  level.tuning.article.balls_block = 0;
  EXPECT_EQ(joined(lua_runtime_parts(level, false)).find("pairs"), std::string::npos);
}

TEST(LuaParts, WhatLuaDoesNotNeedIsLeftOut) {
  EXPECT_EQ(join_lua_parts(
                {"-- Head.\nlocal a = 1  -- px\n", "\n-- More.\nif a then\n  a = 2 - -a * \"b  c\"\nend\n"}),
            "-- Head.\nlocal a=1\nif a then\na=2- -a*\"b  c\"\nend\n");
}

TEST(LuaLevel, HoldsWhatTheSolverNeeds) {
  Level level = flat_level();
  Spawn& spawn = level.spawns.emplace_back();
  spawn.name = "a \"b\"\n";
  spawn.position = {0.1, 2};
  const std::string text = lua_level(level);
  EXPECT_EQ(text.find("return {width=8,height=4,tiles={0,0,"), 0U);
  EXPECT_NE(text.find("shapes={[1]={kind=\"solid\"}},balls={},curves={}"), std::string::npos);
  EXPECT_NE(text.find("{kind=\"ball\",name=\"a \\034b\\034\\010\",x=0.1,y=2,w=8,h=8,vx=0,vy=0,foot=\"box\"}"),
            std::string::npos);
  EXPECT_NE(text.find("fall_speed=5,"), std::string::npos);
}

TEST(Exporters, AMissingPartIsAnErrorAndWritesNothing) {
  const ReadAsset nothing = [](const std::string& name) -> FormatResult<std::string> {
    return tl::unexpected(FormatError{name, "is missing"});
  };
  const auto exported = find_exporter("lua-runtime")->write({flat_level(), "game", nothing});
  ASSERT_FALSE(exported);
  EXPECT_EQ(exported.error().place, "runtime/base.lua");
}

class CliExport : public FolderTest {
 protected:
  int run(std::vector<std::string> words) {
    words.insert(words.begin(), {"export", TALUS_SOURCE_DIR "/assets/demo.talus.json", "--to"});
    answer_ = cli_answer(words);
    return answer_.status;
  }

  CliAnswer answer_;
};

TEST_F(CliExport, OneFileGoesToStandardOutput) {
  const std::pair<const char*, const char*> beginnings[] = {{"lua", "-- A level exported by Talus"},
                                                            {"json", "{\n \"width\":240,"},
                                                            {"c", "/* A level exported by Talus"},
                                                            {"png", "\x89PNG\r\n"},
                                                            {"svg", "<?xml version=\"1.0\"?>\n<svg "}};
  for (const auto& [format, beginning] : beginnings) {
    EXPECT_EQ(run({format, "-o", "-"}), 0) << answer_.err;
    EXPECT_EQ(answer_.out.substr(0, std::string(beginning).size()), beginning) << format;
  }
}

TEST_F(CliExport, TablesAreAFolder) {
  ASSERT_EQ(run({"csv", "-o", path("tables")}), 0) << answer_.err;
  for (const char* name : {"map.csv", "flags.csv", "polygons.csv", "lines.csv", "spawns.csv"})
    EXPECT_TRUE(exists(std::string("tables/") + name)) << name;
  EXPECT_EQ(run({"csv", "-o", "-"}), 1);
  EXPECT_NE(answer_.err.find("is a folder: name one"), std::string::npos) << answer_.err;
}

TEST_F(CliExport, LoveIsAFolder) {
  ASSERT_EQ(run({"love", "-o", path("game")}), 0) << answer_.err;
  for (const char* name : {"main.lua", "conf.lua", "talus.lua", "level.lua", "sheet.png"})
    EXPECT_TRUE(exists(std::string("game/") + name)) << name;
}

TEST_F(CliExport, AFolderIsNoStandardOutput) {
  EXPECT_EQ(run({"love", "-o", "-"}), 1);
  EXPECT_NE(answer_.err.find("is a folder: name one"), std::string::npos) << answer_.err;
}

TEST_F(CliExport, AFolderUnderAFileIsRefused) {
  const std::string file = TALUS_SOURCE_DIR "/README.md/game";
  EXPECT_EQ(run({"lua-runtime", "-o", file}), 1);
  EXPECT_NE(answer_.err.find("cannot be made"), std::string::npos) << answer_.err;
}

}  // namespace talus::cli_export_test
