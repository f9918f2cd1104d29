// The folder for games with bump.lua.
#include <gtest/gtest.h>

#include "export/export_targets.h"
#include "export/lua_level.h"
#include "formats/files/atomic_file.h"
#include "paths.h"

namespace talus::export_bump_test {

FormatResult<std::string> read_asset(const std::string& name) {
  return read_file(source_path("assets/") + name);
}

FormatResult<Exported> exported(const Level& level, const ReadAsset& read = read_asset) {
  return find_exporter("bump")->write({level, "game", read});
}

Level small_level() {
  Level level;
  level.map = TileMap(4, 3);
  level.map.set({1, 2}, 1);
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid};
  return level;
}

TEST(ExportBump, WritesTheCompanionTheLevelAndAnExample) {
  const auto got = exported(small_level());
  ASSERT_TRUE(got) << got.error().message;
  std::vector<std::string> names;
  for (const ExportedFile& file : got->files) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"level.lua", "sheet.png", "bump_slopes.lua", "main.lua",
                                             "conf.lua", "area.lua", "camera.lua", "controls.lua",
                                             "frames.lua", "pictures.lua", "LICENSE-talus.txt"}));
  EXPECT_EQ(got->files[0].bytes, lua_level(small_level()));
  EXPECT_EQ(got->files[2].bytes, read_asset("runtime/bump_slopes.lua").value());
  EXPECT_EQ(got->dropped, std::vector<std::string>{});
}

TEST(ExportBump, SaysThatCurvesAreDropped) {
  Level level = small_level();
  level.curves.push_back({.name = "", .curve = {.form = Segment{{0, 8}, {16, 8}}}, .extra = ""});
  EXPECT_EQ(exported(level)->dropped, std::vector<std::string>{"1 curve, which bump does not know"});
  level.curves.push_back(level.curves.front());
  EXPECT_EQ(exported(level)->dropped, std::vector<std::string>{"2 curves, which bump does not know"});
}

// level.lua has their speeds.
TEST(ExportBump, SaysThatConveyorsMoveNothing) {
  Level level = small_level();
  level.tile_shapes[1].conveyor = 1;
  EXPECT_EQ(exported(level)->dropped,
            std::vector<std::string>{"what a conveyor does to bodies, which bump does not know"});
  level.map.set({2, 2}, 2);
  level.tile_shapes[2] = level.tile_shapes[1];
  EXPECT_EQ(exported(level)->dropped,
            std::vector<std::string>{"what 2 conveyors do to bodies, which bump does not know"});
}

TEST(ExportBump, FailsWhereAFileOfTheProgramIsMissing) {
  const ReadAsset read = [](const std::string& name) -> FormatResult<std::string> {
    if (name == "templates/camera.lua") return tl::unexpected(FormatError{"", "it is not there"});
    return read_asset(name);
  };
  const auto got = exported(small_level(), read);
  ASSERT_FALSE(got);
  EXPECT_EQ(got.error().message, "it is not there");
}

TEST(ExportBump, IsAFolder) {
  EXPECT_TRUE(find_exporter("bump")->is_folder());
  EXPECT_EQ(name_problem(*find_exporter("bump"), "game"), "");
}

}  // namespace talus::export_bump_test
