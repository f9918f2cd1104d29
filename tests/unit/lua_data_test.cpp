// The part data of the Lua runtime: tiles, flags and objects of a level, in Lua 5.3 and LuaJIT.
#include <gmock/gmock.h>

#include "export/exporter.h"
#include "folder_test.h"
#include "formats/files/atomic_file.h"
#include "paths.h"
#include "unit/program_output.h"

namespace talus::lua_data_test {

using testing::HasSubstr;
using testing::Not;

constexpr TileNumber kFloor = 1, kLadder = 2, kBall = 3, kSign = 4, kUp = 5, kDown = 6, kOther = 7;

// A floor, a ladder before it and a ball above.
Level flat_level() {
  Level level;
  level.map = TileMap(4, 2);
  level.flag_names[7] = "ladder";
  level.flag_names[9] = level.flag_names[10] = "win zone";
  level.sheet(SheetId::tiles).flags[kFloor] = 1;
  level.sheet(SheetId::tiles).flags[kBall] = 2;
  level.sheet(SheetId::tiles).flags[kLadder] = flag_bit(7);
  level.sheet(SheetId::tiles).flags[kSign] = flag_bit(7) | flag_bit(10) | flag_bit(31);
  level.map.cells() = MapCells(std::vector<TileNumber>{0, 0, kBall, 0, kFloor, kLadder, kFloor, kFloor});
  level.layers.list.front().name = "ground";
  return level;
}

// With a layer in front, which is hidden and moved, and objects between both.
Level layered_level() {
  Level level = flat_level();
  TileLayer front{.name = "front", .is_ground = false, .visible = false, .offset = {100, 0}};
  front.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{0, kSign, 0, 0, 0, 0, kLadder, 0});
  level.layers.list.push_back(front);
  ObjectLayer things{.name = "things", .place = 1};
  things.objects = {{.name = "a", .type = "coin", .position = {1, 2}, .properties = R"({"worth": 5})"},
                    {.name = "b", .type = "coin"},
                    {.name = "a", .type = "door"}};
  level.objects = {things};
  return level;
}

Exported made(const char* id, const Level& level, std::string_view parts = {}) {
  const ReadAsset assets = [](const std::string& name) { return read_file(source_path("assets/") + name); };
  return find_exporter(id)->make({level, "cave", assets, parts}).value();
}

class LuaDataPart : public FolderTest {
 protected:
  // Expects that both Luas print this for a program that has the world.
  void expect_printed(const Level& level, const std::string& program, const std::string& expected,
                      const char* id = "lua-runtime") const {
    for (const char* lua : {"lua5.3", "luajit"}) EXPECT_EQ(printed(level, program, lua, id), expected) << lua;
  }

  std::string printed(const Level& level, const std::string& program, const std::string& lua,
                      const char* id = "lua-runtime") const {
    for (const ExportedFile& file : made(id, level).files) put(file.name, file.bytes);
    put("program.lua", "local world = require('talus').new(require('level'))\n" + program);
    return output_of("cd '" + folder_.string() + "' && " + lua + " program.lua 2>&1");
  }
};

TEST_F(LuaDataPart, TellsTheTileAtAPoint) {
  const std::string program =
      "print(world:tile_at(0, 8), world:tile_at(15.9, 15.9), world:tile_at(0, 0), world:tile_at(16, 0))\n"
      "print(world:tile_at(-0.1, 0), world:tile_at(0, 16), world:tile_at(32, 0), world:tile_at(0 / 0, 0))\n"
      "print(world:tile_at(16, 8), world:tile_at(16, 8, 'ground'), world:tile_at(8, 0, 'ground'))\n";
  const std::string ends = "1\t2\t0\t0\nnil\tnil\tnil\tnil\n";
  expect_printed(flat_level(), program, ends + "1\t1\t0\n");
  expect_printed(layered_level(), program, ends + "2\t1\t0\n");
  expect_printed(layered_level(), "print(world:tile_at(16, 8, 2), world:tile_at(16, 8, 1))\n", "2\t1\n");
  expect_printed(flat_level(), "world.terrain:set_tile(0, 0, 4)\nprint(world:tile_at(0, 0, 1))\n", "4\n");
}

TEST_F(LuaDataPart, TellsTheFlagsAtAPoint) {
  const std::string program =
      "local on = world:flags_at(8, 8)\n"
      "print(on.ladder, on['win zone'], on[7], on[0], on[31], on == world:flags_at(9, 9))\n"
      "on = world:flags_at(16, 8)\n"
      "print(on.ladder, on[0], world:flags_at(16, 8, 'ground').ladder, world:flags_at(-1, 0).ladder)\n"
      "on = world:flags_at(8, 0)\n"
      "print(on.ladder, on['win zone'], on[9], on[10], on[31])\n";
  expect_printed(flat_level(), program,
                 "true\tfalse\ttrue\tfalse\tfalse\ttrue\nfalse\ttrue\tfalse\tfalse\n"
                 "false\tfalse\tfalse\tfalse\tfalse\n");
  for (const char* id : {"lua-runtime", "love"})
    expect_printed(layered_level(), program,
                   "true\tfalse\ttrue\tfalse\tfalse\ttrue\ntrue\ttrue\tfalse\tfalse\n"
                   "true\ttrue\tfalse\ttrue\ttrue\n",
                   id);
}

TEST_F(LuaDataPart, FindsObjects) {
  expect_printed(layered_level(),
                 "print(#world:objects(), #world:objects {class = 'coin'}, #world:objects {name = 'a'})\n"
                 "print(#world:objects {class = 'coin', name = 'a'}, #world:objects {layer = 'other'})\n"
                 "local coin = world:objects {layer = 'things'}[1]\n"
                 "print(coin.x, coin.y, coin.properties.worth)\n",
                 "3\t2\t2\n1\t0\n1\t2\t5\n");
  expect_printed(flat_level(), "print(#world:objects())\n", "0\n");
}

TEST_F(LuaDataPart, FindsTheCellsWhoseTileHasAFlag) {
  const std::string program =
      "for _, cell in ipairs(world:tiles_with('ladder')) do\n"
      "  print(cell.layer, cell.column, cell.row, cell.tile, cell.turn, cell.x == 8 * cell.column, cell.h == "
      "8)\n"
      "  world:set_tile(cell.column, cell.row, 0, cell.layer)\n"
      "end\n"
      "print(#world:tiles_with('ladder'), world:has_flag('ladder'), world:has_flag('lader'))\n"
      "print((select(2, pcall(world.tiles_with, world, 'lader')):gsub('^.*lua:%d+: ', '')))\n";
  const std::string ends = "0\ttrue\tfalse\nno flag \"lader\"; this level names \"ladder\", \"win zone\"\n";
  const std::string of_ground = "1\t1\t1\t2\t0\ttrue\ttrue\n";
  expect_printed(flat_level(), program, of_ground + ends);
  expect_printed(layered_level(), program,
                 of_ground + "2\t1\t0\t4\t0\ttrue\ttrue\n2\t2\t1\t2\t0\ttrue\ttrue\n" + ends);
}

TEST_F(LuaDataPart, ATileIsChangedInOneWorldAlone) {
  const std::string program =
      "world:set_tile(1, 0, 1)\n"
      "print(world:tile_at(8, 0, 'ground'), world:overlaps(8, 0, 8, 8), world.changes)\n"
      "print(table.concat(world:tiles_of(1), ' '))\n"
      "local other = require('talus').new(require('level'))\n"
      "print(other:tile_at(8, 0, 'ground'), other:overlaps(8, 0, 8, 8), other.changes)\n"
      "print(pcall(world.set_tile, world, 4, 0, 1))\nprint(pcall(world.set_tile, world, 0, 0, 0.5))\n";
  const std::string printed =
      "1\ttrue\t1\n0 1 3 0 1 2 1 1\n0\tfalse\t0\n"
      "false\tthe level has no cell 4, 0\nfalse\ta tile is a number from 0, not 0.5\n";
  expect_printed(flat_level(), program, printed);
  expect_printed(layered_level(), program, printed);
  expect_printed(layered_level(),
                 "world:set_tile(0, 0, 1, 'front')\n"
                 "print(world:tile_at(0, 0), world:tile_at(0, 0, 'ground'), world:overlaps(0, 0, 8, 8))\n",
                 "1\t0\tfalse\n");
}

// Two layers of ground: full tiles, slopes to the right and to the left, and one that is turned.
Level stacked_level() {
  Level level = flat_level();
  const auto slope = [&](TileNumber tile, std::vector<double> heights) {
    level.tile_shapes[tile] = {.kind = TileShape::Kind::slope, .heights = std::move(heights)};
  };
  slope(kUp, {0, 8});
  slope(kDown, {8, 0});
  level.sheet(SheetId::tiles).flags[kOther] = 1;
  level.map.cells() = MapCells(std::vector<TileNumber>{kUp, 0, kUp, 0, kFloor, 0, kLadder, kFloor});
  TileLayer front{.name = "front"};
  MapCells cells(std::vector<TileNumber>{kDown, kUp, 0, kUp, 0, kOther, kLadder, 0});
  cells.set(3, {kUp, TileTurn::left_right});
  front.cells = std::make_shared<const MapCells>(std::move(cells));
  level.layers.list.push_back(front);
  return level;
}

// The ground is as in the program, which exports the level with these tiles.
TEST_F(LuaDataPart, ALayerOfSeveralOfGroundIsChanged) {
  const std::string heights =
      "for x = 0.5, 31.5 do\n"
      "  local y = world:floor(x, -8, 0, 4, 30)\n"
      "  io.write(('%.17g '):format(y or -1), world:overlaps(x, 10, 0, 2) and 'in ' or '')\n"
      "end\n";
  const std::string changes =
      "world:set_tile(2, 0, 6, 'front')\n"   // as in cell 0, 0
      "world:set_tile(0, 0, 0, 'ground')\n"  // the slope in front alone
      "world:set_tile(1, 1, 0, 'front')\n"   // nothing
      "world:set_tile(3, 1, 7, 'front')\n";  // two of the same shape
  Level changed = stacked_level();
  changed.map.cells().set(0, {});
  MapCells front = changed.cells_of(1);
  front.set(2, {kDown});
  front.set(5, {});
  front.set(7, {kOther});
  changed.layers.list[1].cells = std::make_shared<const MapCells>(std::move(front));
  for (const char* lua : {"lua5.3", "luajit"}) {
    const std::string wanted = printed(changed, heights, lua);
    EXPECT_NE(printed(stacked_level(), heights, lua), wanted);
    EXPECT_EQ(printed(stacked_level(), changes + heights, lua), wanted);
  }
}

TEST_F(LuaDataPart, GroundThatTheLevelLacksIsAnError) {
  const std::string program =
      "local function tell(...) print((select(2, pcall(world.set_tile, world, ...)):gsub('^.*lua:%d+: ', "
      "''))) end\n"
      "tell(0, 1, 6, 'front')\ntell(0, 0, 1)\ntell(0, 0, 1, 'typo')\n"
      "tell(1, nil, 1, 'front')\ntell(0, 0, nil, 'front')\n"
      "print(world:tile_at(0, 8, 'front'), world.changes)\n"
      "print((select(2, pcall(function() world:set_tile(0, 1, 6, 'front') "
      "end)):match('^program.lua:%d+:')))\n";
  expect_printed(
      stacked_level(), program,
      "the ground of cell 0, 1 cannot be changed: it would be the tiles 1, 6 at once, which no cell "
      "of the level is\n"
      "the level has several layers of ground: name the layer\n"
      "no layer of tiles \"typo\"; this level names \"ground\", \"front\"\n"
      "the level has no cell 1, nil\n"
      "a tile is a number from 0, not nil\n"
      "0\t0\nprogram.lua:9:\n");
}

TEST_F(LuaDataPart, GroundOfObjectsStaysWhereItIs) {
  Level level = flat_level();
  ObjectLayer things{.name = "things", .is_ground = true, .place = 1};
  things.objects = {{.position = {0, 0}, .size = {8, 8}}};
  level.objects = {things};
  expect_printed(
      level,
      "print(world:overlaps(0, 0, 8, 8), pcall(world.set_tile, world, 0, 0, 1))\n"
      "world:set_tile(1, 0, 1)\nprint(world:overlaps(8, 0, 8, 8))\n",
      "true\tfalse\tthe ground of cell 0, 0 cannot be changed: an object of the level may be ground "
      "there\ntrue\n");
}

TEST_F(LuaDataPart, ErrorsNameWhatIsWrong) {
  const std::string program =
      "local function tell(...) print((select(2, pcall(...)):gsub('^.*lua:%d+: ', ''))) end\n"
      "tell(world.tile_at, world, 0, 0, 'typo')\n"
      "tell(world.flags_at, world, -1, 0, 'things')\n"
      "tell(world.tile_at, world, 'x')\n"
      "tell(function() return world:flags_at(0, 0).lader end)\n"
      "tell(world.objects, world, {clas = 'coin'})\n"
      "tell(world.objects, world, 'coin')\n"
      "tell(world.tiles_of, world)\n"
      "print((select(2, pcall(function() return world:flags_at(0, 0).lader "
      "end)):match('^program.lua:%d+:')))\n";
  expect_printed(layered_level(), program,
                 "no layer of tiles \"typo\"; this level names \"ground\", \"front\"\n"
                 "no layer of tiles \"things\"; this level names \"ground\", \"front\"\n"
                 "a point is two numbers, x and y in px, not x and nil\n"
                 "no flag \"lader\"; this level names \"ladder\", \"win zone\"\n"
                 "objects have no \"clas\" to be found by, but class, name and layer\n"
                 "objects are found by a table, such as {class = \"coin\"}\n"
                 "no layer of tiles \"nil\"; this level names \"ground\", \"front\"\n"
                 "program.lua:10:\n");
  expect_printed(Level(), "print(pcall(world.flags_at, world, 0, 0, 'a'))\n",
                 "false\tno layer of tiles \"a\"; this level names none\n");
}

TEST(LuaDataParts, AreInCartsByNameAlone) {
  const std::string cart = made("tic-text-playable", layered_level()).files[0].bytes;
  for (const char* word : {"flags_at", "coin", "ladder", "tile_flags"})
    EXPECT_THAT(cart, Not(HasSubstr(word)));
  const std::string with_data = made("tic-text-playable", layered_level(), "data").files[0].bytes;
  for (const char* word : {"flags_at(", "coin", "ladder", "tile_flags={"})
    EXPECT_THAT(with_data, HasSubstr(word));
}

}  // namespace talus::lua_data_test
