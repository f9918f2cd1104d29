// Lua maps for Simple Tiled Implementation: the text. tests/games/sti_test loads one.
#include <gmock/gmock.h>

#include "formats/png_picture.h"
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

Level level_with(const TileShape& shape, const std::vector<std::uint8_t>& cells, int width) {
  Level level;
  level.map = TileMap(width, static_cast<int>(cells.size()) / width);
  level.map.cells() = cells;
  level.tile_shapes[2] = shape;
  return level;
}

std::string cells_of(const std::string& lua) {
  const std::size_t from = lua.find("data = {") + 8;
  std::string cells = lua.substr(from, lua.find('}', from) - from);
  std::erase_if(cells, [](char c) { return c == ' ' || c == '\n'; });
  return cells;
}

TEST(ExportSti, HasTheTablesThatStiReads) {
  const std::string lua = sti_of(level_for_tiled());
  EXPECT_TRUE(lua.starts_with("return {\n luaversion = \"5.1\",\n version = \"1.10\",\n"))
      << lua.substr(0, 100);
  EXPECT_THAT(lua, HasSubstr("tileoffset = {x = 0, y = 0},\n   properties = {},"));
  EXPECT_THAT(lua, HasSubstr("objectGroup = {"));
  EXPECT_THAT(lua, HasSubstr("encoding = \"lua\","));
  EXPECT_THAT(lua, HasSubstr("offsetx = 0,"));
  EXPECT_THAT(lua, HasSubstr("polygon = {{x = 0, y = 8}, {x = 16, y = 0}, {x = 16, y = 8}}"));
  EXPECT_THAT(lua, HasSubstr("name = \"a <b> & \\034c\\034\""));
  EXPECT_THAT(lua, testing::Not(HasSubstr("talus_level")));
}

TEST(ExportSti, ASlopeIsCutIntoItsCells) {
  const TileShape slope = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {2, 6}};
  const std::string lua = sti_of(level_with(slope, {0, 2, 0}, 3));
  EXPECT_EQ(cells_of(lua), "0,3,257");
  EXPECT_THAT(properties_of(lua, 2),
              StartsWith("{[\"collidable\"] = true, [\"slope\"] = \"floor\", [\"h0\"] = 2, [\"h1\"] = 4}"));
  EXPECT_THAT(properties_of(lua, 256),
              StartsWith("{[\"collidable\"] = true, [\"slope\"] = \"floor\", [\"h0\"] = 4, [\"h1\"] = 6}"));
}

TEST(ExportSti, AHighSlopeReachesIntoTheCellAbove) {
  const TileShape slope = {.kind = TileShape::Kind::slope, .heights = {4, 12}};
  const std::string lua = sti_of(level_with(slope, {0, 2}, 1));
  EXPECT_EQ(cells_of(lua), "257,3");
  EXPECT_THAT(properties_of(lua, 2), HasSubstr("[\"h0\"] = 4, [\"h1\"] = 12"));
  EXPECT_THAT(properties_of(lua, 256), HasSubstr("[\"h0\"] = -4, [\"h1\"] = 4"));
}

TEST(ExportSti, CeilingsReachDownAndProfilesHaveNineHeights) {
  const TileShape profile = {.kind = TileShape::Kind::profile,
                             .side = TileShape::Side::ceiling,
                             .one_way = true,
                             .heights = {2, 4, 10}};
  const std::string lua = sti_of(level_with(profile, {2, 0}, 1));
  EXPECT_THAT(
      properties_of(lua, 2),
      StartsWith("{[\"collidable\"] = true, [\"one_way\"] = true, [\"slope\"] = \"ceiling\", [\"h0\"] = 2, "
                 "[\"h1\"] = 10, [\"heights\"] = \"2 2.5 3 3.5 4 5.5 7 8.5 10\"}"));
  EXPECT_THAT(properties_of(lua, 256), HasSubstr("[\"heights\"] = \"-6 -5.5 -5 -4.5 -4 -2.5 -1 0.5 2\""));
}

TEST(ExportSti, FlagsStayWithTheTileWhateverReachesIntoItsCell) {
  Level level = level_with({.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 8}}, {2, 3, 0, 3}, 4);
  level.sheet(SheetId::tiles).flags[3] = 1 << 6;
  const Exported files = tiled_export_of(level, "sti", "cave.lua");
  const std::string lua = files.files[0].bytes;
  EXPECT_EQ(cells_of(lua), "3,257,0,4");
  EXPECT_THAT(properties_of(lua, 3), StartsWith("{[\"flags\"] = 64, [\"flag6\"] = true}"));
  EXPECT_THAT(
      properties_of(lua, 256),
      StartsWith("{[\"flags\"] = 64, [\"flag6\"] = true, [\"collidable\"] = true, [\"slope\"] = \"floor\", "
                 "[\"h0\"] = 4, [\"h1\"] = 8}"));
  EXPECT_THAT(lua, HasSubstr("tilecount = 272,"));
  const auto picture = read_rgba(files.files[1].bytes);
  EXPECT_EQ(picture->height, 136) << "a row more for the tiles from 256 on";
}

TEST(ExportSti, TellsWhatBumpDoesNotHave) {
  const TileShape slope = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {1, 8}};
  Level level = level_with(slope, {2, 2}, 2);
  level.curves.push_back({"", {Segment{{0, 0}, {8, 8}}, Curve::Faces::up}, ""});
  EXPECT_THAT(tiled_export_of(level, "sti", "a.lua").dropped,
              ElementsAre("the second of two slopes that reach into 1 cell",
                          "collision, which bump.lua has none of, with 1 curve"));
}

}  // namespace talus::export_sti_test
