// Lua maps for Simple Tiled Implementation: the text. tests/games/sti_test loads one.
#include <gmock/gmock.h>

#include "tiled_files.h"

namespace talus::export_sti_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

std::string sti_of(const Level& level) { return tiled_export_of(level, "sti", "cave.lua").files[0].bytes; }

// The tile's properties.
std::string properties_of(const std::string& lua, int id) {
  const std::size_t at = lua.find("id = " + std::to_string(id) + ",\n     properties");
  if (at == std::string::npos) return "";
  const std::size_t from = lua.find('{', at);
  return lua.substr(from, lua.find('\n', from) - from);
}

Level level_with(const TileShape& shape, const std::vector<TileNumber>& cells, int width) {
  Level level;
  level.map = TileMap(width, static_cast<int>(cells.size()) / width);
  level.map.cells() = cells;
  level.tile_shapes[2] = shape;
  return level;
}

// The objects of the layer "slopes", without the fields that all of them share.
std::vector<std::string> slopes_of(const std::string& lua) {
  std::vector<std::string> objects;
  for (std::size_t at = lua.find("name = \"slopes\""); (at = lua.find("{id = ", at)) != std::string::npos;) {
    const std::size_t from = lua.find(" x = ", at) + 1, end = lua.find('\n', at);
    std::string object = lua.substr(from, end - from);
    for (const std::string common :
         {" rotation = 0, visible = true, properties =", "[\"collidable\"] = true"})
      if (const std::size_t place = object.find(common); place != std::string::npos)
        object.erase(place, common.size());
    objects.push_back(object);
    at = end;
  }
  return objects;
}

TEST(ExportSti, HasTheTablesThatStiReads) {
  const std::string lua = sti_of(level_for_tiled());
  EXPECT_TRUE(lua.starts_with("return {\n luaversion = \"5.1\",\n version = \"1.10\",\n"))
      << lua.substr(0, 100);
  EXPECT_THAT(lua, HasSubstr("tileoffset = {x = 0, y = 0},\n   properties = {},"));
  EXPECT_THAT(lua, HasSubstr("backgroundcolor = {26, 28, 44}"));
  EXPECT_THAT(lua, HasSubstr("objectGroup = {"));
  EXPECT_THAT(lua, HasSubstr("encoding = \"lua\","));
  EXPECT_THAT(lua, HasSubstr("offsetx = 0,"));
  EXPECT_THAT(lua, HasSubstr("polygon = {{x = 0, y = 8}, {x = 16, y = 0}, {x = 16, y = 8}}"));
  EXPECT_THAT(lua, HasSubstr("name = \"a <b> & \\034c\\034\""));
  EXPECT_THAT(lua, testing::Not(HasSubstr("talus_level")));
}

TEST(ExportSti, AWideSlopeIsOneBox) {
  const TileShape slope = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {2, 6}};
  const std::string lua = sti_of(level_with(slope, {0, 2, 0}, 3));
  EXPECT_THAT(slopes_of(lua), ElementsAre("x = 8, y = 2, width = 16, height = 4, "
                                          "{, [\"slope\"] = \"floor\", [\"h0\"] = 0, [\"h1\"] = 4}},",
                                          "x = 8, y = 6, width = 16, height = 2, {}}"));
  EXPECT_EQ(properties_of(lua, 2), "{[\"shape\"] = \"slope\", [\"shape_heights\"] = \"2 6\"},")
      << "the tile itself stops nothing";
}

TEST(ExportSti, AProfileIsABoxForEachStraightPart) {
  const TileShape profile = {.kind = TileShape::Kind::profile,
                             .side = TileShape::Side::ceiling,
                             .one_way = true,
                             .heights = {2, 4, 6, 6, 2}};
  EXPECT_THAT(slopes_of(sti_of(level_with(profile, {2, 0}, 1))),
              ElementsAre(HasSubstr("x = 0, y = 1, width = 4, height = 5, {, [\"one_way\"] = true, "
                                    "[\"slope\"] = \"ceiling\", [\"h0\"] = 1, [\"h1\"] = 5}"),
                          HasSubstr("x = 4, y = 5, width = 2, height = 1, {, [\"one_way\"] = true, "
                                    "[\"slope\"] = \"ceiling\", [\"h0\"] = 1, [\"h1\"] = 1}"),
                          HasSubstr("x = 6, y = 1, width = 2, height = 5, {, [\"one_way\"] = true, "
                                    "[\"slope\"] = \"ceiling\", [\"h0\"] = 5, [\"h1\"] = 1}")));
}

TEST(ExportSti, FullTilesAreCollidableAndKeepTheirFlags) {
  Level level = level_with({.kind = TileShape::Kind::solid}, {2, 3, 0, 3}, 4);
  level.sheet(SheetId::tiles).flags[2] = 1 << 6;
  level.tile_shapes[3] = {.kind = TileShape::Kind::solid, .one_way = true};
  const std::string lua = sti_of(level);
  EXPECT_THAT(properties_of(lua, 2),
              StartsWith("{[\"flags\"] = 64, [\"flag6\"] = true, [\"shape\"] = \"solid\", "
                         "[\"collidable\"] = true}"));
  EXPECT_EQ(slopes_of(lua).size(), 2U) << "the one-way tiles";
  EXPECT_THAT(lua, HasSubstr("visible = false"));
}

TEST(ExportSti, BoxesSayTheFlagsOfAllTilesOfTheirCell) {
  Level level = level_with({.kind = TileShape::Kind::slope, .heights = {0, 8}, .conveyor = -1.5}, {2}, 1);
  level.sheet(SheetId::tiles).flags[2] = 1 << 6;
  level.sheet(SheetId::tiles).flags[3] = 1 << 4;
  level.sheet(SheetId::tiles).flags[4] = 1 << 5;
  level.flag_names[4] = "ice";
  const std::string lua = sti_of(level);
  EXPECT_THAT(properties_of(lua, 2), HasSubstr("[\"shape_conveyor\"] = -1.5"));
  EXPECT_THAT(slopes_of(lua), ElementsAre(HasSubstr("{[\"flags\"] = 64, [\"flag6\"] = true, "
                                                    "[\"shape_conveyor\"] = -1.5,")));
  for (const TileNumber tile : {TileNumber{3}, TileNumber{4}}) {
    TileLayer layer{.name = "more", .is_ground = tile == 3};
    layer.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{tile});
    level.layers.list.push_back(std::move(layer));
  }
  const ReadAsset no_asset;
  const Exported made = find_exporter("sti")->make({level, "cave.lua", no_asset}).value();
  EXPECT_THAT(slopes_of(made.files[0].bytes),
              ElementsAre(HasSubstr("{[\"flags\"] = 80, [\"ice\"] = true, [\"flag6\"] = true, ")));
}

// LuaJIT allows only a limited number of tables in one function.
TEST(ExportSti, ALongLayerIsInParts) {
  Level level = level_with({.kind = TileShape::Kind::slope, .heights = {0, 8}}, {2}, 1);
  level.map = TileMap(100, 100);
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{2});
  const std::string lua = sti_of(level);
  EXPECT_TRUE(lua.starts_with("local function join(parts)"));
  EXPECT_EQ(slopes_of(lua).size(), 10'000U);
  EXPECT_NE(lua.find("objects = join{\n    function() return {\n"), std::string::npos);
}

TEST(ExportSti, MoreThanAMillionBoxesAreRefused) {
  Level level =
      level_with({.kind = TileShape::Kind::profile, .heights = {0, 8, 0, 8, 0, 8, 0, 8, 0}}, {2}, 1);
  level.map = TileMap(400, 400);
  std::fill(level.map.cells().tiles().begin(), level.map.cells().tiles().end(), TileNumber{2});
  const ReadAsset no_asset;
  const auto exported = find_exporter("sti")->write({level, "a.lua", no_asset});
  ASSERT_FALSE(exported);
  EXPECT_EQ(exported.error().message,
            "the slopes need more than 1000000 boxes, too many for an STI map: make the map smaller");
}

TEST(ExportSti, WarnsOfGroundThatBumpDoesNotHave) {
  Level level = level_with({.kind = TileShape::Kind::slope, .tiles = 2, .heights = {1, 8}}, {2, 2}, 2);
  level.curves.push_back({"", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""});
  EXPECT_THAT(tiled_export_of(level, "sti", "a.lua").dropped,
              ElementsAre("collision, which bump.lua cannot have, with 1 curve"));
}

}  // namespace talus::export_sti_test
