// Flags that no cart has: 8 to 31, in levels and in the files that hold them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "edit/sprite_clipboard.h"
#include "export/exporter.h"
#include "export/lua_level.h"
#include "folder_test.h"
#include "formats/tiled/tiled_flags.h"
#include "level/tile_words.h"
#include "native_text.h"
#include "tiled_files.h"
#include "unit/exported_level.h"

namespace talus::more_flags_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr FlagSet kHigh = flag_bit(8) | flag_bit(19) | flag_bit(31);

Level level_with(FlagSet flags) {
  Level level;
  level.sheet(SheetId::tiles).flags[4] = flags;
  return level;
}

void expect_version_6(const Level& level, const std::string& what) {
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, StartsWith("{\n  \"talus\": 6,\n")) << what;
  EXPECT_EQ(level_of_native(text), level) << what;
}

TEST(MoreFlags, AreKeptInVersion6) {
  expect_version_6(level_with(kHigh | 1), "a tile");
  Level level;
  level.sheet(SheetId::sprites).flags[255] = flag_bit(8);
  expect_version_6(level, "a sprite");
  level = Level();
  level.flag_names[31] = "lava";
  expect_version_6(level, "a name");
  level = Level();
  level.roles.solid = 9;
  expect_version_6(level, "a role");
  level = Level();
  level.flag_shapes[10].kind = TileShape::Kind::solid;
  expect_version_6(level, "a shape");
  level = Level();
  level.flag_fields = {{"kind", 7, 8, {"a"}, ""}};
  expect_version_6(level, "a field");
}

TEST(MoreFlags, ALevelWithoutThemKeepsItsBytes) {
  Level level = level_with(0xff);
  level.flag_names[7] = "last";
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, StartsWith("{\n  \"talus\": 1,\n"));
  const std::string until_last = "\"\",\n    \"last\"";
  EXPECT_THAT(text, HasSubstr(until_last + "\n  ]"));
  level.flag_names[9] = "later";
  EXPECT_THAT(native_of_level(level), HasSubstr(until_last + ",\n    \"\",\n    \"later\"\n  ]"));
}

TEST(MoreFlags, HaveRolesAndShapes) {
  Level level = level_with(flag_bit(31));
  level.flag_shapes[31] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  EXPECT_EQ(shape_of_tile(level, 4), level.flag_shapes[31]);
  level.roles.solid = 31;
  EXPECT_EQ(shape_of_tile(level, 4).kind, TileShape::Kind::solid);
  const FlagField field{"", 24, 8, {}, ""};
  EXPECT_EQ(field.mask(), 0xff000000);
  EXPECT_EQ(field.value_of(flag_bit(31)), 128);
  EXPECT_EQ(field.pattern(255).put_in(1), 0xff000001);
}

TEST(MoreFlags, AreUsedByTilesNamesRolesShapesAndFields) {
  Level level = level_with(flag_bit(20));
  level.sheet(SheetId::sprites).flags[0] = flag_bit(21);
  level.flag_names[22] = "x";
  level.flag_shapes[23].kind = TileShape::Kind::solid;
  level.roles.ceiling = 24;
  level.flag_fields = {{"", 25, 2, {}, ""}};
  EXPECT_EQ(used_flags(level), 0x07f0000f) << "0 to 3 have roles";
}

TEST(MoreFlags, AreCopiedAsEightDigits) {
  Level level = level_with(kHigh);
  level.sheet(SheetId::tiles).images[4].fill(7);
  const SpriteArea from{SheetId::tiles, {4, 0, 1, 1}}, to{SheetId::sprites, {2, 2, 1, 1}};
  const std::string text = tiles_to_text(level, from);
  EXPECT_EQ(text, "tiles 1x1 flags\n" + std::string(64, '7') + "00108008");
  const auto edit = paste_tiles(level, to, text);
  ASSERT_TRUE(edit);
  apply_edit(level, *edit);
  EXPECT_EQ(level.sheet(SheetId::sprites).flags[34], kHigh);
  EXPECT_FALSE(paste_tiles(level, to, text.substr(0, text.size() - 1)));
}

TEST(MoreFlags, AreTheLargerTypeOfTheCHeader) {
  EXPECT_THAT(exported_file("c", level_with(0xff)), HasSubstr("static const uint8_t cave_flags[256]"));
  const std::string header = exported_file("c", level_with(kHigh));
  EXPECT_THAT(header, HasSubstr("static const uint32_t cave_flags[256] = {0,0,0,0,2148008192,0,"));
  EXPECT_THAT(header, HasSubstr("static const uint32_t cave_sprite_flags[256]"));
}

TEST(MoreFlags, AreWholeNumbersOfDataExports) {
  EXPECT_THAT(exported_file("json", level_with(kHigh)), HasSubstr("2148008192"));
  EXPECT_THAT(exported_file("lua", level_with(kHigh)), HasSubstr("2148008192"));
  EXPECT_THAT(exported_file("csv", level_with(kHigh), "flags.csv"), HasSubstr("\n4,2148008192,none"));
}

TEST(MoreFlags, AreFoundByNamesWithBlanksAndByValuesOfFields) {
  Level level = level_with(flag_bit(19) | flag_bit(22));
  level.flag_names[19] = "Win zone";
  level.flag_names[20] = "zone";
  level.sheet(SheetId::tiles).flags[5] = flag_bit(20);
  level.flag_fields = {{"kind", 21, 2, {"none", "ice", "deep water"}, ""}};
  const auto found = [&](const char* text) {
    std::vector<int> tiles;
    const auto all = find_tiles(level, text);
    for (int tile = 0; tile < static_cast<int>(all.size()); ++tile)
      if (all[static_cast<std::size_t>(tile)]) tiles.push_back(tile);
    return tiles;
  };
  using testing::ElementsAre;
  EXPECT_THAT(found("\"win zone\""), ElementsAre(4));
  EXPECT_THAT(found("flag:\"Win zone"), ElementsAre(4)) << "the last quote may be missing";
  EXPECT_THAT(found("flag:zone"), ElementsAre(5));
  EXPECT_THAT(found("zone"), ElementsAre(4, 5));
  EXPECT_THAT(found("flag:19"), ElementsAre(4));
  EXPECT_THAT(found("flag:\"deep water\""), ElementsAre(4));
  EXPECT_THAT(found("flag:none"), ElementsAre());
  level.tile_notes[7].type = "Zone door";
  EXPECT_THAT(found("zone"), ElementsAre(4, 5, 7));
  EXPECT_THAT(found("class:zone"), ElementsAre(7));
}

TEST(MoreFlags, HaveTheirNamesInDataExports) {
  Level level = level_with(kHigh);
  level.flag_names[5] = "solid";  // as the role of flag 0
  level.flag_names[19] = "Win zone!";
  level.flag_names[20] = "win zone";
  const std::string header = exported_file("c", level);
  EXPECT_THAT(header, HasSubstr("#define CAVE_FLAG_SOLID 0\n"));
  EXPECT_THAT(header, HasSubstr("#define CAVE_FLAG_WIN_ZONE 19\n"));
  EXPECT_THAT(header, Not(HasSubstr("SOLID 5")));
  EXPECT_THAT(header, Not(HasSubstr("WIN_ZONE 20")));
  EXPECT_THAT(exported_file("json", level),
              HasSubstr(R"("flag_names":{"5":"solid","19":"Win zone!","20":"win zone"})"));
  EXPECT_THAT(exported_file("lua", level), HasSubstr(R"(flag_names={[5]="solid",[19]="Win zone!")"));
  EXPECT_EQ(exported_file("csv", level, "flag_names.csv"), "flag,name\n5,solid\n19,Win zone!\n20,win zone\n");
  EXPECT_THAT(exported_file("json", Level()), Not(HasSubstr("flag_names")));
  EXPECT_EQ(exported_file("csv", Level(), "flag_names.csv"), "no file flag_names.csv");
}

TEST(MoreFlags, GiveGamesInLuaTheirTilesByName) {
  Level level = level_with(flag_bit(19) | 1);
  level.flag_names[19] = level.flag_names[20] = "win zone";
  EXPECT_THAT(lua_level(level), HasSubstr("  flags = {\n    [\"win zone\"] = {[4] = true},\n  },\n"));
  EXPECT_THAT(lua_level(level, LuaForm::small), Not(HasSubstr("flags")));
  level.flag_names = {};
  EXPECT_THAT(lua_level(level), Not(HasSubstr("  flags = {")));
}

TEST(MoreFlags, AreToldWhenACartIsExported) {
  const auto files = exported("tic", level_with(kHigh | 2), "cave.tic");
  ASSERT_TRUE(files);
  EXPECT_THAT(files->dropped,
              testing::ElementsAre(
                  "the flags above 7 of 1 tile: a cart has flags 0 to 7, and its companion the others"));
  const auto few = exported("tic", level_with(0xff), "cave.tic");
  ASSERT_TRUE(few);
  EXPECT_THAT(few->dropped, IsEmpty());
}

class MoreFlagsOfCarts : public FolderTest {
 protected:
  void save(const Level& level) const {
    const auto saved = save_level(level, *find_format("tic"), path("game.tic"), {});
    ASSERT_TRUE(saved) << to_string(saved.error(), "game.tic");
  }
  Level load() const {
    auto loaded = load_level(path("game.tic"));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "game.tic");
    return loaded ? std::move(loaded->level) : Level();
  }
};

TEST_F(MoreFlagsOfCarts, AreKeptInTheCompanion) {
  Level level = level_with(kHigh | 3);
  level.flag_names[19] = "ice";
  save(level);
  const auto cart = find_format("tic")->read(bytes_of("game.tic"), context_for_file("game.tic"));
  ASSERT_TRUE(cart);
  EXPECT_EQ(cart->tile_flags(4), 3u) << "the cart has its eight";
  EXPECT_EQ(load().tile_flags(4), kHigh | 3);
  EXPECT_EQ(load().flag_names[19], "ice");
}

TEST_F(MoreFlagsOfCarts, AreAddedToTilesThatTheCartChanged) {
  Level level = level_with(kHigh | 3);
  level.sheet(SheetId::tiles).flags[5] = flag_bit(9) | 1;
  level.sheet(SheetId::tiles).flags[6] = flag_bit(10);
  save(level);
  auto cart = find_format("tic")->read(bytes_of("game.tic"), context_for_file("game.tic"));
  ASSERT_TRUE(cart);
  cart->sheet(SheetId::tiles).flags[4] = 4;
  cart->sheet(SheetId::tiles).flags[5] = 0;
  cart->sheet(SheetId::tiles).flags[7] = 5;
  put("game.tic", find_format("tic")->write(*cart, context_for_file("game.tic")).value().bytes);
  const Level joined = load();
  EXPECT_EQ(joined.tile_flags(4), kHigh | 4);
  EXPECT_EQ(joined.tile_flags(5), flag_bit(9)) << "the cart's flag is gone";
  EXPECT_EQ(joined.tile_flags(6), flag_bit(10));
  EXPECT_EQ(joined.tile_flags(7), 5u);
}

// A map of Tiled with one tile of these properties.
std::string map_with(const std::string& properties) {
  return R"(<map version="1.10" orientation="orthogonal" width="1" height="1" tilewidth="16" tileheight="16">
 <tileset firstgid="1" name="t" tilewidth="16" tileheight="16" tilecount="1" columns="1">
  <image source="t.png" width="16" height="16"/>
  <tile id="0"><properties>)" +
         properties + R"(</properties></tile>
 </tileset>
 <layer id="1" name="l" width="1" height="1"><data encoding="csv">1</data></layer>
</map>
)";
}
std::string bools(int count) {
  std::string text;
  for (int i = 10; i < 10 + count; ++i)
    text += "<property name=\"b" + std::to_string(i) + R"(" type="bool" value="true"/>)";
  return text;
}

class MoreFlagsOfTiled : public FolderTest {
 protected:
  LoadedLevel load(const std::string& properties) const {
    put("a.tmx", map_with(properties));
    auto loaded = load_level(path("a.tmx"));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "a.tmx");
    return loaded ? *std::move(loaded) : LoadedLevel();
  }
  static FlagSet flags_of(const Level& level) { return level.tile_flags(level.map.tile_at({0, 0})); }
};

TEST_F(MoreFlagsOfTiled, BoolsHave32FlagsAndTheOthersAreKept) {
  EXPECT_EQ(flags_of(load(bools(28)).level), 0xfffffff0);
  const LoadedLevel all = load(bools(32));
  EXPECT_EQ(flags_of(all.level), 0xffffffff);
  EXPECT_EQ(all.level.roles.solid, FlagRoles::kUnused) << "no tile had it";
  EXPECT_THAT(all.dropped, Not(testing::Contains(HasSubstr("property"))));
  const LoadedLevel more = load(bools(33));
  const TileNumber tile = more.level.map.tile_at({0, 0});
  EXPECT_THAT(note_of(more.level.tile_notes, tile).properties, HasSubstr("b42")) << "as its property";
  EXPECT_EQ(more.level.flag_names[0], "b38") << "flags without a role come first";
}

TEST_F(MoreFlagsOfTiled, ARoleThatTilesHaveKeepsItsFlag) {
  const Level level = load(bools(32) + R"(<property name="ball" type="bool" value="true"/>)").level;
  EXPECT_EQ(level.roles.ball, 1);
  EXPECT_EQ(level.flag_names[1], "");
  EXPECT_EQ(flags_of(level), 0xffffffff);
}

TEST_F(MoreFlagsOfTiled, TheNumberHasASignAsInTiled) {
  EXPECT_EQ(tiled_number_of(flag_bit(31) | 1), -2147483647);
  EXPECT_EQ(tiled_number_of(flag_bit(30)), 1 << 30);
  for (const FlagSet flags : {FlagSet{0}, FlagSet{0xff}, kHigh, ~FlagSet{0}})
    EXPECT_EQ(flags_of_tiled_number(tiled_number_of(flags)), flags);
  EXPECT_EQ(flags_of_tiled_number(4294967295), ~FlagSet{0}) << "from other programs";
  EXPECT_EQ(flags_of_tiled_number(4294967296), std::nullopt);
  EXPECT_EQ(flags_of_tiled_number(-2147483649), std::nullopt);
  EXPECT_EQ(flags_of(load(R"(<property name="flags" type="int" value="-2147483647"/>)").level),
            flag_bit(31) | 1);
}

TEST_F(MoreFlagsOfTiled, SurviveTheExport) {
  Level level = level_for_tiled();
  level.sheet(SheetId::tiles).flags[1] |= kHigh;
  level.flag_names[19] = "wet";
  for (const char* const id : {"tmx", "tmj"}) {
    const Exported files = tiled_export_of(level, id, std::string("a.") + id);
    const auto read = read_level(files.files.front().bytes, context_for_file(path(std::string("a.") + id)));
    ASSERT_TRUE(read) << to_string(read.error(), id);
    EXPECT_EQ(read->level.tile_flags(1), kHigh | 1) << id;
    EXPECT_EQ(read->level.flag_names[19], "wet") << id;
  }
}

TEST_F(MoreFlagsOfTiled, AreSavedByTheirNames) {
  LoadedLevel loaded = load(bools(5));
  EXPECT_EQ(loaded.level.flag_names[8], "b14");
  const TileNumber tile = loaded.level.map.tile_at({0, 0});
  FlagSet& flags = loaded.level.sheet(SheetId::tiles).flags[tile];
  flags = (flags & ~flag_bit(8)) | flag_bit(31);
  const FlagSet wanted = flags;
  const auto saved = save_level(loaded.level, *loaded.format, path("a.tmx"), loaded.companion);
  ASSERT_TRUE(saved) << to_string(saved.error(), "a.tmx");
  EXPECT_THAT(bytes_of("a.tmx"), Not(HasSubstr("b14")));
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(R"(<property name="flag31" type="bool" value="true"/>)"));
  const auto again = load_level(path("a.tmx"));
  ASSERT_TRUE(again);
  EXPECT_EQ(flags_of(again->level), wanted);
}

}  // namespace talus::more_flags_test
