// Native levels: how they are written, what they keep, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include <talus/formats/format.h>
#include "formats/tic80/tic_cart.h"
#include "formats/tic80/tic_text.h"
#include "native_text.h"

namespace talus::native_test {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

Level small_level() {
  Level level;
  level.tuning.solver = SolverKind::article;
  level.map = TileMap(3, 4);
  level.map.set({1, 1}, 0x2a);
  level.sheet(SheetId::tiles).images[3].fill(14);
  level.sheet(SheetId::tiles).images[3][9] = 0;
  level.sheet(SheetId::tiles).flags[3] = 0b101;
  level.sheet(SheetId::sprites).flags[255] = 0x80;
  level.flag_names[2] = "ramp";
  level.roles.ball = FlagRoles::kUnused;
  level.spawns.push_back({"hero", {8, 0.5}, {-1, 0}, ""});
  return level;
}

constexpr const char* kSmallLevel = R"({
  "talus": 1,
  "palette": [
    "1a1c2c",
    "5d275d",
    "b13e53",
    "ef7d57",
    "ffcd75",
    "a7f070",
    "38b764",
    "257179",
    "29366f",
    "3b5dc9",
    "41a6f6",
    "73eff7",
    "f4f4f4",
    "94b0c2",
    "566c86",
    "333c57"
  ],
  "flag_names": [
    "",
    "",
    "ramp",
    "",
    "",
    "",
    "",
    ""
  ],
  "roles": {"solid": 0, "up_slope": 2, "down_slope": 3, "ball": null},
  "tuning": {
    "solver": "article",
    "cell_size": 24,
    "fall_speed": 5,
    "fall_blend": 0.075,
    "drift_speed": 0,
    "drift_blend": 0.03,
    "floor_bounce": 0.9,
    "floor_grip": 0.75,
    "wall_bounce": 0.9,
    "slope_bounce": 0.5,
    "slope_width": 16,
    "slope_height": 8,
    "drag_blend": 0.3,
    "drag_offset": 4,
    "drag_probe": 1,
    "bodies": "block"
  },
  "spawns": [
    {"name": "hero", "x": 8, "y": 0.5, "vx": -1, "vy": 0}
  ],
  "tiles": {
    "3": {"flags": [0, 2], "pixels": "eeeeeeee e.eeeeee eeeeeeee eeeeeeee eeeeeeee eeeeeeee eeeeeeee eeeeeeee"}
  },
  "sprites": {
    "255": {"flags": [7]}
  },
  "map": {
    "width": 3,
    "height": 4,
    "rows": [
      "",
      "..2a"
    ]
  }
}
)";

TEST(Native, IsWrittenAsInThisFile) { EXPECT_EQ(native_of_level(small_level()), kSmallLevel); }

TEST(Native, ReadsWhatItWrites) { EXPECT_EQ(level_of_native(kSmallLevel), small_level()); }

TEST(Native, MissingKeysMeanTheDefaults) { EXPECT_EQ(level_of_native(R"({"talus": 1})"), Level()); }

TEST(Native, OneChangedCellIsOneChangedLine) {
  Level level = small_level();
  level.map.set({2, 0}, 1);
  std::string expected = kSmallLevel;
  const std::string row = "      \"\",\n      \"..2a\"";
  expected.replace(expected.find(row), row.size(), "      \"....01\",\n      \"..2a\"");
  EXPECT_EQ(native_of_level(level), expected);
}

TEST(Native, KeepsUnknownKeysWhereTheyWere) {
  const std::string text = R"({
    "talus": 1,
    "future": {"a": [1, {"b": null}], "c": 0.1},
    "roles": {"solid": 1, "ladder": 5},
    "tuning": {"fall_speed": 4, "wind": "west"},
    "spawns": [{"x": 1, "worth": "coin"}],
    "tiles": {"7": {"flags": [1], "sound": 3}, "300th": true},
    "map": {"width": 2, "height": 2, "rows": ["01"], "wraps": true}
  })";
  const Level level = level_of_native(text);
  EXPECT_EQ(level.spawns[0].extra, R"({"worth":"coin"})");
  const std::string written = native_of_level(level);
  for (const char* part : {R"("a": [)", R"("b": null)", R"("c": 0.1)", R"("ladder": 5)", R"("wind": "west")",
                           R"("worth": "coin")", R"("sound": 3)", R"("300th": true)", R"("wraps": true)"}) {
    EXPECT_THAT(written, HasSubstr(part));
  }
  EXPECT_EQ(level_of_native(written), level);
  EXPECT_EQ(native_of_level(level_of_native(written)), written);
}

TEST(Native, UnknownKeysSurviveTheDataBesideThem) {
  Level level =
      level_of_native(native_with(R"("tiles": {"7": {"flags": [1], "sound": 3}}, "cart": {"label": "x"})"));
  level.sheet(SheetId::tiles).flags[7] = 0;
  const std::string written = native_of_level(level);
  EXPECT_THAT(written, HasSubstr(R"("7": {"sound": 3})"));
  EXPECT_THAT(written, HasSubstr(R"("cart": {"label": "x"})"));
  EXPECT_EQ(level_of_native(written), level);
}

TEST(Native, ANewerVersionIsRefused) {
  expect_native_error(R"({"talus": 9, "palette": 7})", "key talus",
                      "has version 9, but this Talus reads only up to version 8");
  expect_native_error(R"({"talus": "1"})", "key talus", "must be the version, a whole number from 1");
  expect_native_error(R"({"map": {}})", "key talus", "is missing, so this is not a Talus level");
  expect_native_error("[]", "", "is JSON, but not a Talus level");
}

TEST(Native, OtherTilesThan8x8AreKeptInVersion2) {
  Level level;
  level.map = TileMap(3, 2, {16, 24});
  level.map.set({2, 1}, 5);
  level.tile_shapes[5] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 192}};
  level.curves.push_back({"", {Segment{{0, 48}, {48, 0}}, Curve::Faces::up}, ""});
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, StartsWith("{\n  \"talus\": 2,\n"));
  EXPECT_THAT(text, HasSubstr("\"tile_size\": [16, 24]"));
  EXPECT_EQ(level_of_native(text), level);
  level.map = TileMap(3, 2);
  level.tile_shapes[5].heights = {0, 64};
  level.curves.clear();
  EXPECT_THAT(native_of_level(level), StartsWith("{\n  \"talus\": 1,\n"));
  EXPECT_EQ(level_of_native(native_with(R"("tile_size": [16, 1])")).map, TileMap(240, 136, {16, 1}));
}

TEST(Native, SizesOfTilesAreChecked) {
  for (const char* size : {"8", "[8]", "[0, 8]", "[8, 257]", "[8, 8.5]", "[8, 8, 8]", "[\"8\", 8]"})
    expect_native_error(native_with(R"("tile_size": )" + std::string(size)), "key tile_size",
                        "must be [width, height], whole numbers from 1 to 256 px");
  expect_native_error(
      native_with(R"("tile_size": [4, 8], "tile_shapes": {"1": {"kind": "slope", "heights": [0, 64.5]}})"),
      "key tile_shapes.1", "has a height that is not from 0 to 64 px");
  expect_native_error(native_with(R"("tile_size": [16, 8], "map": {"width": 1048577, "height": 1})"),
                      "key map", "is longer than 16777216 px");
}

TEST(Native, ErrorsSayWhere) {
  expect_native_error("{\n\"talus\": 1,\n]", "line 3, column 1", "this is not valid JSON");
  expect_native_error("{\"talus\": 1e999}", "line 1, key talus", "has a number that is too large");
  expect_native_error(native_with(R"("tuning": {"fall_speed": 900})"), "key tuning.fall_speed",
                      "must be a number from -64 to 64 px/frame");
  expect_native_error(native_with(R"("tuning": {"fall_blend": "x"})"), "key tuning.fall_blend",
                      "must be a number from 0 to 1");
  expect_native_error(native_with(R"("tuning": {"solver": "magic"})"), "key tuning.solver",
                      R"(must be "article", "bump" or "exact")");
  expect_native_error(native_with(R"("tuning": [])"), "key tuning", "must be an object");
  expect_native_error(native_with(R"("roles": {"solid": 32})"), "key roles.solid",
                      "must be a flag from 0 to 31, or null");
  expect_native_error(native_with(R"("palette": ["000000"])"), "key palette", "must be a list of 16 colours");
  expect_native_error(native_with(R"("flag_names": [1])"), "key flag_names",
                      "must be a list of up to 32 strings");
  expect_native_error(native_with(R"("spawns": [{}, {"x": 200000000}])"), "key spawns[1].x",
                      "must be a number from -100000000 to 100000000");
  expect_native_error(native_with(R"("spawns": [7])"), "key spawns[0]", "must be an object");
  expect_native_error(native_with(R"("tiles": {"256": {}})"), "key tiles.256",
                      "must be a tile number from 0 to 255");
  expect_native_error(native_with(R"("tiles": {"01": {}})"), "key tiles.01",
                      "must be a tile number from 0 to 255");
  expect_native_error(native_with(R"("tiles": {"1": {"flags": [32]}})"), "key tiles.1.flags",
                      "must be a list of flags from 0 to 31");
  expect_native_error(native_with(R"("sprites": {"9": {"pixels": "0"}})"), "key sprites.9.pixels",
                      "must be eight rows of eight hexadecimal digits");
}

TEST(Native, MapErrorsNameTheRow) {
  expect_native_error(native_with(R"("map": {"width": 2097153})"), "key map.width",
                      "must be a whole number from 1 to 2097152");
  expect_native_error(native_with(R"("map": {"height": 0})"), "key map.height",
                      "must be a whole number from 1 to 2097152");
  expect_native_error(native_with(R"("map": {"width": 2097152, "height": 9})"), "key map",
                      "has more than 16777216 cells");
  expect_native_error(native_with(R"("map": {"width": 2097152, "height": 2097152})"), "key map",
                      "has more than 16777216 cells");
  expect_native_error(native_with(R"("map": {"height": 1, "rows": ["", ""]})"), "key map.rows",
                      "has 2 rows, more than the map's height of 1");
  expect_native_error(native_with(R"("map": {"width": 2, "rows": ["", "010101"]})"), "map row 1",
                      "is longer than the map's width of 2 cells");
  expect_native_error(native_with(R"("map": {"rows": ["010"]})"), "map row 0",
                      "must have two characters for each cell");
  expect_native_error(native_with(R"("map": {"rows": ["", "", "01.1"]})"), "map row 2",
                      "has a cell, number 1, that is not two hexadecimal digits");
}

TEST(Native, DeepAndHugeJsonIsRefused) {
  expect_native_error(std::string(100'000, '['), "line 1", "the JSON is nested deeper than 64 levels here");
  expect_native_error(native_with("\n\"x\": " + std::string(100'000, '[') + std::string(100'000, ']')),
                      "line 2", "the JSON is nested deeper than 64 levels here");
  std::string many = "[0";
  for (int i = 0; i < 5'000'001; ++i) many += ",0";
  expect_native_error(many, "line 1", "the JSON has more than 5000000 values");
  EXPECT_EQ(level_of_native(native_with(R"("x": "[[[[\"[[[")")).extra, R"({"x":"[[[[\"[[["})");
}

// Writes and reads a map whose tiles are all different from their neighbours. most: bytes of the file.
void expect_read_again(int width, int height, std::size_t most) {
  Level level;
  level.map = TileMap(width, height);
  for (std::size_t i = 0; i < level.map.cells().size(); ++i)
    level.map.cells().tiles()[i] = static_cast<std::uint8_t>(i * 7 + 1);
  const std::string text = native_of_level(level);
  EXPECT_LT(text.size(), most);
  EXPECT_EQ(level_of_native(text), level);
}

TEST(Native, HighAndWideMapsAreReadAgain) {
  expect_read_again(8, 1 << 15, 860'000);
  expect_read_again(1 << 15, 8, 540'000);
}

TEST(LargeLevels, TheLargestMapsAreReadAgain) {
  expect_read_again(8, kMaxTerrainCells / 8, 55'000'000);
  expect_read_again(1 << 21, kMaxTerrainCells >> 21, 34'000'000);
}

TEST(Native, NumbersKeepEveryBit) {
  Level level;
  level.spawns.push_back({"", {0.1, -0.0}, {1.0 / 3, 1e-300}, ""});
  const Level again = level_of_native(native_of_level(level));
  EXPECT_EQ(again, level);
  EXPECT_TRUE(std::signbit(again.spawns[0].position.y));
}

TEST(Native, LevelsThatCannotBeReadAreNotWritten) {
  Level level;
  level.spawns.push_back({"", {std::numeric_limits<double>::quiet_NaN(), 0}, {}, ""});
  EXPECT_EQ(write_native(level, {}).error().place, "key spawns[0].x");
  level.spawns[0] = {"\xff", {}, {}, ""};
  EXPECT_EQ(write_native(level, {}).error().place, "key spawns[0].name");
  EXPECT_EQ(write_native(level, {}).error().message, "is not valid UTF-8");
  level.spawns.clear();
  level.tuning.shared.cell_size = 0;
  EXPECT_EQ(write_native(level, {}).error().place, "key tuning.cell_size");
}

std::string sample_cart() {
  std::string bytes;
  append_tic_chunk(bytes, {.type = 12, .data = std::string(96, 'p')});
  append_tic_chunk(bytes, {.type = 4, .data = "abc"});
  append_tic_chunk(bytes, {.type = 9, .bank = 2, .reserved = 7, .data = std::string(70, '\x5a')});
  append_tic_chunk(bytes, {.type = 27, .data = "?"});
  append_tic_chunk(bytes, {.type = kTicCode, .bank = 1, .data = std::string(65536, '\xff')});
  append_tic_chunk(bytes, {.type = kTicCode, .data = "-- \"code\"\n\treturn"});
  return bytes;
}

TEST(Native, ACartIsReadable) {
  const std::string text = native_of_level(read_tic(sample_cart(), {}).value());
  EXPECT_THAT(text, HasSubstr(R"({"chunk": "MAP", "data": "level"})"));
  EXPECT_THAT(text,
              HasSubstr("\"code\": [\n          \"-- \\\"code\\\"\",\n          \"\\treturn\"\n        ]"));
  EXPECT_THAT(text, HasSubstr("\"chunk\": 27,\n        \"data\": [\n          \"3f\"\n        ]"));
  EXPECT_THAT(text, HasSubstr("\"chunk\": \"SAMPLES\",\n        \"bank\": 2,\n        \"reserved\": 7,"));
  EXPECT_EQ(write_tic(level_of_native(text), {})->bytes, sample_cart());
}

TEST(Native, AnEditOfACartLevelIsOneLine) {
  Level level = read_tic(sample_cart(), {}).value();
  const std::string before = native_of_level(level);
  level.map.set({1, 0}, 0x11);
  std::string expected = before;
  expected.replace(expected.find("\"616263\""), 8, "\"611163\"");
  EXPECT_EQ(native_of_level(level), expected);
  EXPECT_EQ(write_tic(level_of_native(expected), {})->bytes, write_tic(level, {})->bytes);
}

TEST(Native, AMapTooLargeForItsCartLeavesTheCartAsItIs) {
  Level level = read_tic(sample_cart(), {}).value();
  level.map = TileMap(300, 300);
  const std::string text = native_of_level(level);
  const Level again = level_of_native(text);
  EXPECT_EQ(again, level);
  EXPECT_EQ(again.cart->bytes, sample_cart());
}

TEST(Native, ATextProjectIsKeptLineByLine) {
  const std::string rows = "-- 000:1" + std::string(511, '0');
  const std::string project = "code \"x\"\r\n\n-- <FLAGS>\n" + rows + "\n-- </FLAGS>\n-- <SFX>\n-- </SFX>";
  const Level level = read_text(project, {"lua"}).value();
  EXPECT_EQ(level_of_native(native_of_level(level)), level);
  std::string plain = project;
  std::erase(plain, '\r');
  const std::string text = native_of_level(read_text(plain, {"lua"}).value());
  EXPECT_THAT(text, HasSubstr("{\"level\": \"FLAGS\"}"));
  EXPECT_THAT(text, Not(HasSubstr(rows)));
  EXPECT_EQ(write_text(level_of_native(text), {"lua"})->bytes, plain);
}

TEST(Native, ATextProjectOutsideUtf8IsKept) {
  const std::string project = "-- \xff\xfe\n-- <MAP>\n-- </MAP>\n";
  EXPECT_EQ(write_text(level_of_native(native_of_level(read_text(project, {"lua"}).value())), {"lua"})->bytes,
            project);
}

TEST(Native, CartErrorsSayWhere) {
  const auto expect = [](const std::string& cart, const std::string& place, const std::string& message) {
    expect_native_error(native_with("\"cart\": {" + cart + "}"), place, message);
  };
  expect(R"("kind": "png")", "key cart.kind", "must be \"tic\" or \"text\"");
  expect(R"("kind": "tic")", "key cart.chunks", "must be a list");
  expect(R"("kind": "tic", "chunks": [])", "key cart", "is damaged: the file is empty");
  expect(R"("kind": "tic", "chunks": [{"chunk": "MAPS"}])", "key cart.chunks[0].chunk",
         "must be the name of a chunk, or its number from 0 to 31");
  expect(R"("kind": "tic", "chunks": [{"chunk": 1, "bank": 8}])", "key cart.chunks[0].bank",
         "must be a whole number from 0 to 7");
  expect(R"("kind": "tic", "chunks": [{"chunk": 1, "data": ["0"]}])", "key cart.chunks[0].data",
         "has a row that is not pairs of hexadecimal digits");
  expect(R"("kind": "tic", "chunks": [{"chunk": "CODE"}])", "key cart.chunks[0]",
         "has 0 bytes, which a chunk's header cannot express");
  expect(R"("kind": "tic", "chunks": [{"chunk": 1, "date": []}])", "key cart.chunks[0]",
         "has the key \"date\", which no chunk has");
  expect(R"("kind": "tic", "chunks": [{"chunk": "CODE_ZIP", "data": ["00"]}])", "key cart",
         "is damaged at byte 0: the compressed code is damaged");
  expect(R"("kind": "text", "comment": "%")", "key cart.comment", "must be \"--\", \"//\", \";;\" or \"#\"");
  expect(R"("kind": "text", "comment": "#", "lines": [{"level": "SFX"}])", "key cart.lines[0]",
         "names a section that the level does not have, or a map that is too large for a cart");
}

}  // namespace talus::native_test
