// Levels of LDtk are saved in a companion, and the project is never written.
#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "folder_test.h"
#include "formats/native/companion.h"
#include "ldtk_text.h"

namespace talus::ldtk_companion_test {

using Kind = LdtkMapping::Kind;
using testing::ElementsAre;
using testing::HasSubstr;

class LdtkCompanion : public FolderTest {
 protected:
  std::string project(const std::string& cave = "1,0,0,0", const std::string& player = "[8,0]") const {
    const std::string entities = ldtk_layer(
        "Entities", "E", 2, 2,
        R"("entityInstances":[{"__identifier":"Player","px":)" + player + R"(,"width":8,"height":8}])");
    const std::string levels = ldtk_level(entities + "," + ldtk_grid(2, 2, cave), "Cave", R"("iid":"c",)") +
                               "," + ldtk_level(ldtk_grid(2, 1, "1,1"), "Top", R"("iid":"t",)");
    std::string text = ldtk_project(levels, R"({"value":1,"identifier":"wall"})");
    text.insert(1, R"("iid":"p",)");
    return put("game.ldtk", text);
  }
  LoadedLevel load(const std::string& name, const ImportChoices& choices = {}) const {
    auto loaded = load_level(path(name), choices);
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
  }
  // The level Cave with one more wall and a body.
  Level changed_cave() const {
    Level level = load("game.ldtk", {.level = "Cave"}).level;
    level.map.set({1, 1}, level.map.tile_at({0, 0}));
    Spawn ball;
    ball.name = "Bo";
    level.spawns.push_back(ball);
    level.spawns[0].name = "Ada";
    LevelCurve curve;
    curve.name = "bump";
    curve.curve.form = Segment{{0, 8}, {8, 4}};
    level.curves.push_back(curve);
    level.tile_shapes[200] = {.kind = TileShape::Kind::slope, .heights = {0, 4}};
    level.map.set({1, 0}, 200);
    level.layers.list[0].name = "Walls";
    level.tuning.exact.gravity *= 2;
    level.background = Rgba{1, 2, 3, 4};
    return level;
  }
  FormatResult<SavedLevel> save(const Level& level, const CompanionFile& known = {}) const {
    return save_level(level, *find_format("ldtk"), path("game.ldtk"), known);
  }
};

TEST_F(LdtkCompanion, HoldsAllThatWasAdded) {
  project();
  const std::string before = bytes_of("game.ldtk");
  const Level cave = changed_cave();
  const auto saved = save(cave);
  ASSERT_TRUE(saved) << to_string(saved.error(), "game.ldtk");
  EXPECT_EQ(saved->companion.path, path("game.talus.json"));
  EXPECT_EQ(bytes_of("game.ldtk"), before);
  const LoadedLevel again = load("game.ldtk", {.level = "Cave"});
  EXPECT_TRUE(again.level == cave);
  EXPECT_EQ(again.note, "");
  EXPECT_EQ(again.companion.path, path("game.talus.json"));
  EXPECT_TRUE(load("game.talus.json").level == cave) << "the companion opens the level that was saved last";
  EXPECT_EQ(level_path(path("game.talus.json")), path("game.ldtk"));
}

TEST_F(LdtkCompanion, HoldsSeveralLevelsAndTheMapping) {
  project();
  const Level cave = changed_cave();
  ASSERT_TRUE(save(cave));
  LdtkMapping mapping;
  mapping.set({.kind = Kind::value, .name = "1", .shape = "slope_up"});
  LoadedLevel top = load("game.ldtk", {.level = "t", .mapping = mapping});
  top.level.map.set({0, 0}, 0);
  ASSERT_TRUE(save(top.level, top.companion));
  const Level again = load("game.ldtk", {.level = "Top"}).level;
  EXPECT_TRUE(again == top.level);
  EXPECT_EQ(again.ldtk->mapping, mapping);
  const Level mapped = load("game.ldtk", {.level = "Cave"}).level;
  EXPECT_EQ(mapped.map.at({1, 0}), 200);
  EXPECT_THAT(shape_of_tile(mapped, mapped.map.tile_at({0, 0})).heights, ElementsAre(0, 8))
      << "the mapping is that of the whole project";
}

TEST_F(LdtkCompanion, PaintedCellsWinWhereLdtkChangedNothing) {
  project();
  const Level cave = changed_cave();
  ASSERT_TRUE(save(cave));
  project("0,2,0,0");
  const LoadedLevel both = load("game.ldtk", {.level = "Cave"});
  EXPECT_EQ(both.level.map.at({0, 0}), 0) << "as in LDtk";
  EXPECT_NE(both.level.map.at({1, 0}), 200) << "that cell was changed in LDtk, too";
  EXPECT_EQ(both.level.map.tile_at({1, 1}), cave.map.tile_at({1, 1}));
  EXPECT_EQ(both.note, "LDtk has changed game.ldtk: 1 painted cell is as in LDtk now");
  const auto saved = save(both.level, both.companion);
  ASSERT_TRUE(saved);
  EXPECT_THAT(saved->note, HasSubstr("What was there before is kept as")) << "nothing is lost";
}

TEST_F(LdtkCompanion, BodiesChangedInBothAreThereTwice) {
  project();
  ASSERT_TRUE(save(changed_cave()));
  project("1,0,0,0", "[0,8]");
  const LoadedLevel both = load("game.ldtk", {.level = "Cave"});
  EXPECT_EQ(both.level.spawns.size(), 3u);
  EXPECT_THAT(both.note, HasSubstr("1 body is there both as changed here and as LDtk has it"));
}

TEST_F(LdtkCompanion, LayersOfTalusAreKept) {
  project();
  Level cave = load("game.ldtk", {.level = "Cave"}).level;
  TileLayer mine;
  mine.name = "Mine";
  mine.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{0, 1, 0, 1});
  cave.layers.list.push_back(mine);
  Brush pair;
  pair.w = 2;
  pair.tiles = {0, 1};
  cave.brushes.push_back(pair);
  ASSERT_TRUE(save(cave));
  EXPECT_TRUE(load("game.ldtk", {.level = "Cave"}).level == cave);
  project("0,2,0,0");
  const LoadedLevel both = load("game.ldtk", {.level = "Cave"});
  ASSERT_EQ(both.level.layers.count(), 2) << both.note;
  EXPECT_EQ(both.level.cells_of(1), *mine.cells);
  EXPECT_EQ(both.level.cells_of(0)[0], 0);
  EXPECT_EQ(both.level.brushes.at(0).tiles, cave.brushes[0].tiles) << "cells have more digits now";
  EXPECT_EQ(both.note, "");
}

TEST_F(LdtkCompanion, LayersOfOneNameAreKeptApart) {
  const std::string layers = ldtk_grid(2, 1, "1,0") + "," + ldtk_grid(2, 1, "0,1");
  put("game.ldtk", ldtk_project(ldtk_level(layers, "Cave"), R"({"value":1,"identifier":"wall"})"));
  Level cave = load("game.ldtk").level;
  ASSERT_EQ(cave.layers.count(), 2);
  cave.choose_layer(1);
  cave.map.set({1, 0}, 1);
  cave.choose_layer(0);
  cave.map.set({0, 0}, 1);
  ASSERT_TRUE(save(cave));
  EXPECT_TRUE(load("game.ldtk").level == cave);
}

TEST_F(LdtkCompanion, OtherFilesAreNotWrittenOver) {
  project();
  const Level cave = changed_cave();
  put("game.talus.json", R"({"talus":1})");
  const auto native = save(cave);
  ASSERT_FALSE(native);
  EXPECT_THAT(native.error().message,
              HasSubstr("game.talus.json is a level of its own, not what Talus adds to game.ldtk"));
  EXPECT_EQ(bytes_of("game.talus.json"), R"({"talus":1})");
  EXPECT_EQ(load("game.ldtk", {.level = "Cave"}).note, "") << "a level may be beside its export";
  put("game.talus.json", R"({"talus":1,"companion":{"file":"game.ldtk","project":"other"}})");
  const auto other = save(cave);
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message, HasSubstr("belongs to another project than game.ldtk"));
  EXPECT_THAT(load("game.ldtk", {.level = "Cave"}).note, HasSubstr("is left as it is, and not read"));
}

TEST_F(LdtkCompanion, ANativeLevelDoesNotTakeItsName) {
  project();
  const Level cave = changed_cave();
  ASSERT_TRUE(save(cave));
  EXPECT_EQ(companion_place_problem(path("game.talus.json")),
            "is what Talus adds to game.ldtk beside it: choose another name");
  EXPECT_TRUE(save_level(cave, *find_format("native"), path("copy.talus.json")));
  EXPECT_TRUE(load("copy.talus.json").level == cave);
  EXPECT_EQ(load("copy.talus.json").level.ldtk, nullptr);
}

TEST_F(LdtkCompanion, FaultyOnesAreLeftAlone) {
  project();
  for (const std::string levels :
       {R"([])", R"({"c":{"added":{"cells":[{"ldtk":"Grid","runs":[[9,0,[1],[0]]]}],"layers":[7]}}})",
        R"({"c":{"added":{"map":[0,-1]}}})", R"({"c":{"added":{"spawns":{"added":[3]}}}})",
        R"({"c":{"added":{"picture":{"1":["x"]}}}})", R"({"c":{"added":{"members":{"layers":[]}}}})"}) {
    const std::string text =
        R"({"talus":4,"companion":{"file":"game.ldtk","project":"p"},"levels":)" + levels + "}";
    put("game.talus.json", text);
    const LoadedLevel loaded = load("game.ldtk", {.level = "Cave"});
    EXPECT_THAT(loaded.note, HasSubstr("game.talus.json is left as it is, and not read")) << levels;
    EXPECT_NE(loaded.level.map.at({0, 0}), 0);
  }
}

}  // namespace talus::ldtk_companion_test
