// Games in Lua: they move by the exact solver, whatever the level was played by, and carry what draws them.
#include <gtest/gtest.h>

#include "export/exporter.h"
#include "formats/atomic_file.h"

namespace talus::export_love_test {

FormatResult<std::string> read_asset(const std::string& name) {
  return read_file(TALUS_SOURCE_DIR "/assets/" + name);
}

Exported exported(const Level& level, std::string_view id) {
  const ReadAsset read = read_asset;
  return find_exporter(id)->write({level, "game", read}).value();
}

TEST(ExportLove, SaysThatTheGameMovesByExact) {
  Level level;
  level.map = TileMap(40, 20);  // which a cart's code has, too
  level.map.set({39, 19}, 7);
  for (const char* id : {"love", "lua-runtime", "tic-playable", "tic-text-playable"}) {
    level.tuning.solver = SolverKind::exact;
    EXPECT_EQ(exported(level, id).dropped, std::vector<std::string>{}) << id;
    level.tuning.solver = SolverKind::article;
    EXPECT_EQ(exported(level, id).dropped,
              std::vector<std::string>{"the solver article: the game moves by exact"})
        << id;
  }
}

TEST(ExportLove, ACartHasTheMapAtItsTopLeft) {
  Level level;
  level.map = TileMap(40, 20);
  level.map.set({39, 19}, 7);
  level.map.set({0, 1}, 5);
  const auto cart = read_level(exported(level, "tic-playable").files.front().bytes, {"tic"});
  ASSERT_TRUE(cart);
  TileMap map;
  map.set({39, 19}, 7);
  map.set({0, 1}, 5);
  EXPECT_EQ(cart->level.map, map);
}

TEST(ExportLove, WritesAFolderThatNeedsNothingElse) {
  std::vector<std::string> names;
  for (const ExportedFile& file : exported(Level(), "love").files) names.push_back(file.name);
  EXPECT_EQ(names, (std::vector<std::string>{"talus.lua", "level.lua", "sheet.png", "main.lua", "conf.lua",
                                             "camera.lua", "curve_points.lua"}));
}

// What draws curves is of no use to a cart without them, and a cart is short of bytes.
TEST(ExportLove, ACartDrawsCurvesOnlyWhereThereAreSome) {
  Level level;
  const auto has_curves = [&] {
    return exported(level, "tic-text-playable").files.front().bytes.find("curve_points=(function()") !=
           std::string::npos;
  };
  EXPECT_FALSE(has_curves());
  level.curves.push_back({.name = "", .curve = {.form = Segment{{0, 8}, {16, 8}}}, .extra = ""});
  EXPECT_TRUE(has_curves());
}

}  // namespace talus::export_love_test
