// What the user says that values, tags and entities of a project of LDtk stand for.
#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "formats/ldtk/ldtk_meanings.h"
#include "ldtk_text.h"

namespace talus::ldtk_mapping_test {

using Kind = LdtkMapping::Kind;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr const char* kTwoValues =
    R"({"value":1,"identifier":"wall","color":"#FF8000"},{"value":2,"identifier":"ice"})";

Level level_of(const std::string& text, const LdtkMapping& mapping,
               const std::vector<std::string>& tiles = {}) {
  FormatContext context{"ldtk"};
  context.choices.mapping = mapping;
  context.choices.ldtk_tiles = tiles;
  auto loaded = read_level(text, context);
  EXPECT_TRUE(loaded) << to_string(loaded.error(), "file");
  return loaded ? loaded->level : Level();
}
TileShape shape_in(const Level& level, int column) { return shape_of_cell(level, level.map.at({column, 0})); }
// The definition of the layer has no name.
LdtkMapping value_to(const std::string& number, const std::string& shape, const std::string& flag = "") {
  LdtkMapping mapping;
  mapping.set({.kind = Kind::value, .name = number, .shape = shape, .flag = flag});
  return mapping;
}

TEST(LdtkMapping, AValueStandsForTheChosenShape) {
  const std::string text = ldtk_project(ldtk_level(ldtk_grid(2, 1, "1,2")), kTwoValues);
  EXPECT_EQ(shape_in(level_of(text, {}), 0).kind, TileShape::Kind::solid);
  EXPECT_THAT(shape_in(level_of(text, value_to("1", "slope_up")), 0).heights, ElementsAre(0, 8));
  EXPECT_THAT(shape_in(level_of(text, value_to("1", "slope_down_high")), 0).heights, ElementsAre(8, 4));
  EXPECT_EQ(shape_in(level_of(text, value_to("1", "none")), 0).kind, TileShape::Kind::none);
  EXPECT_TRUE(shape_in(level_of(text, value_to("1", "one_way")), 0).one_way);
  EXPECT_EQ(shape_in(level_of(text, value_to("1", "none")), 1).kind, TileShape::Kind::solid)
      << "of another value";
}

TEST(LdtkMapping, AValueHasTheChosenFlag) {
  const std::string text = ldtk_project(ldtk_level(ldtk_grid(2, 1, "1,2")), kTwoValues);
  const Level own = level_of(text, value_to("1", "", "own"));
  EXPECT_EQ(own.flag_names[5], "wall");
  EXPECT_EQ(own.tile_flags(own.map.tile_at({0, 0})), 1 | 1 << 5);
  const Level none = level_of(text, value_to("2", "", "none"));
  EXPECT_EQ(none.flag_names[4], "");
  const Level role = level_of(text, value_to("2", "", "one_way"));
  EXPECT_EQ(role.roles.one_way, 4);
  EXPECT_TRUE(shape_in(role, 1).one_way);
  const Level slope = level_of(text, value_to("2", "none", "up_slope"));
  EXPECT_EQ(slope.role_at({1, 0}), TileRole::up_slope);
}

TEST(LdtkMapping, TagsAndEntitiesStandForWhatIsChosen) {
  const std::string entities = R"({"__identifier":"Chest","px":[0,0],"width":8,"height":8},)"
                               R"({"__identifier":"Player","px":[8,0],"width":8,"height":8})";
  const std::string layers = ldtk_layer("Entities", "E", 2, 1, R"("entityInstances":[)" + entities + "]") +
                             "," + ldtk_tiles(2, 1, ldtk_tile(0, 0, 1) + "," + ldtk_tile(8, 0, 1, 1));
  const std::string tileset = ldtk_tileset(R"("enumTags":[{"enumValueId":"Hill","tileIds":[1]}])");
  LdtkMapping mapping;
  mapping.set({.kind = Kind::tag, .of = "Tiles", .name = "Hill", .shape = "slope_up_low", .flag = "none"});
  mapping.set({.kind = Kind::entity, .name = "Chest", .body = "ball"});
  mapping.set({.kind = Kind::entity, .name = "Player", .body = "none"});
  const Level level = level_of(ldtk_project(ldtk_level(layers), "", tileset), mapping);
  EXPECT_THAT(shape_in(level, 0).heights, ElementsAre(0, 4));
  EXPECT_THAT(shape_in(level, 1).heights, ElementsAre(4, 0)) << "a mirrored tile mirrors its slope";
  EXPECT_EQ(level.flag_names[4], "");
  ASSERT_EQ(level.spawns.size(), 1u);
  EXPECT_EQ(level.spawns[0].kind, BodyKind::ball);
}

TEST(LdtkMapping, TilesKeepTheirNumbersWhenTheProjectChanges) {
  const Level before = level_of(ldtk_project(ldtk_level(ldtk_grid(3, 1, "1,2,0")), kTwoValues), {});
  const Level after = level_of(ldtk_project(ldtk_level(ldtk_grid(3, 1, "0,3,2")), kTwoValues),
                               value_to("2", "slope_up"), before.ldtk->tiles);
  EXPECT_EQ(after.map.tile_at({2, 0}), before.map.tile_at({1, 0}));
  EXPECT_NE(after.map.tile_at({1, 0}), before.map.tile_at({0, 0})) << "that number is taken";
  EXPECT_THAT(shape_in(after, 2).heights, ElementsAre(0, 8));
  const Level broken = level_of(ldtk_project(ldtk_level(ldtk_grid(2, 1, "1,2")), kTwoValues), {},
                                {"", "x", "2 1 9 9", "2 1", "2 1"});
  EXPECT_EQ(broken.map.at({0, 0}), 3);
  EXPECT_EQ(broken.map.at({1, 0}), 5);
}

TEST(LdtkMapping, ThingsAreListedWithTheirNumbers) {
  LdtkProject project;
  LdtkLayerDef& grid = project.layers.emplace_back();
  grid.uid = 1;
  grid.name = "Grid";
  grid.values = {{1, "wall", {}}, {2, "", {}}};
  project.entities = {{"Chest", {}}, {"Ball", {}}};
  LdtkLevel level;
  level.layers.resize(2);
  level.layers[0].type = LdtkLayer::Type::int_grid;
  level.layers[0].def = 0;
  level.layers[0].values = {1, 1, 0};
  level.layers[1].type = LdtkLayer::Type::entities;
  level.layers[1].entities.emplace_back().type = "Chest";
  const auto things = ldtk_things_of(project, level);
  ASSERT_EQ(things.size(), 4u);
  EXPECT_EQ(things[0].label, "wall");
  EXPECT_EQ(things[0].usual, "solid");
  EXPECT_EQ(things[0].count, 2);
  EXPECT_EQ(things[1].label, "value 2");
  EXPECT_EQ(things[1].count, 0);
  EXPECT_EQ(things[2].label, "Ball");
  EXPECT_EQ(things[2].usual, "ball");
  EXPECT_EQ(things[3].count, 1);
}

TEST(LdtkMapping, AThingHasOneChoice) {
  LdtkMapping mapping = value_to("1", "solid");
  mapping.set({.kind = Kind::value, .name = "1", .shape = "none"});
  ASSERT_EQ(mapping.choices.size(), 1u);
  EXPECT_TRUE(is_good(mapping.choices[0]));
  mapping.set({.kind = Kind::value, .name = "1"});
  EXPECT_THAT(mapping.choices, IsEmpty());
  EXPECT_FALSE(is_good({.kind = Kind::value, .shape = "spiral"}));
  EXPECT_FALSE(is_good({.kind = Kind::entity, .shape = "solid"}));
}

}  // namespace talus::ldtk_mapping_test
