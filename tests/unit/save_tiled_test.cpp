// Maps of Tiled that are saved into their own files: nothing changes but what was edited.
#include <gmock/gmock.h>

#include "folder_test.h"
#include "formats/text/base64.h"
#include "formats/text/unpack.h"

namespace talus::save_tiled_test {

using testing::HasSubstr;

struct Encoded {
  const char* name;
  std::string head;                          // attributes of the <data>
  std::string (*with)(std::uint32_t cell0);  // the cells cell0, 2, 0, 0x80000001, 3, 0
};

std::string bytes_with(std::uint32_t cell0) {
  std::string bytes;
  for (const std::uint32_t cell : {cell0, 2U, 0U, 0x80000001U, 3U, 0U}) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(cell >> shift & 0xff);
  }
  return bytes;
}
std::string csv_with(std::uint32_t cell0) {
  return "\r\n" + std::to_string(cell0) + ", 2,0,\r\n  2147483649,3,0\r\n";
}
std::string raw_with(std::uint32_t cell0) { return "\n   " + encode_base64(bytes_with(cell0)) + "\n  "; }
std::string zlib_with(std::uint32_t cell0) { return encode_base64(pack_zlib(bytes_with(cell0))); }
std::string gzip_with(std::uint32_t cell0) { return encode_base64(pack_gzip(bytes_with(cell0))); }
std::string zstd_with(std::uint32_t cell0) { return encode_base64(pack_zstd(bytes_with(cell0))); }
std::string tiles_with(std::uint32_t cell0) {
  return "\n<tile gid=\"" + std::to_string(cell0) +
         "\"/>\n<tile gid='2' />\n<tile/><tile gid=\"2147483649\"/>\n<tile gid=\"3\"></tile><tile/>\n ";
}
const std::vector<Encoded> kEncodings = {
    {"csv", " encoding=\"csv\"", csv_with},
    {"raw", " encoding='base64'", raw_with},
    {"zlib", " compression=\"zlib\"\n  encoding=\"base64\"", zlib_with},
    {"gzip", " encoding=\"base64\" compression=\"gzip\"", gzip_with},
    {"zstd", " encoding=\"base64\" compression=\"zstd\" ", zstd_with},
    {"tiles", "", tiles_with},
};

// With attributes in an odd order, comments, and elements that nobody knows.
std::string map_with(const std::string& data, const std::string& objects = "",
                     const std::string& size = "height=\"2\" width=\"3\"") {
  return "\xef\xbb\xbf<?xml version=\"1.0\"?>\r\n<!-- a > b -->\n"
         "<map tileheight=\"8\" " +
         size +
         " tilewidth=\"8\" orientation=\"orthogonal\" nextobjectid='9'>\n"
         " <strange a=\"&lt;b/>\"><layer/></strange>\n"
         " <tileset name=\"t\" firstgid=\"1\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"4\" "
         "columns=\"2\"/>\n"
         " <group name=\"g\"><layer name=\"ground\" " +
         size +
         ">\n"
         "  <properties><property name=\"p\" value=\"1\"/></properties>\n  " +
         data + "\n </layer><!-- </layer> --></group>" + objects + "\n</map>\n\n";
}
std::string map_in(const Encoded& encoded, std::uint32_t cell0) {
  return map_with("<data" + encoded.head + ">" + encoded.with(cell0) + "</data>");
}

class SaveTiled : public FolderTest {
 protected:
  // Opens the file, edits its level and saves it. Returns the error; empty if there is none.
  template <class Edit>
  std::string edit(const std::string& name, Edit change, const std::string& as = "") {
    auto loaded = load_level(path(name));
    if (!loaded) return to_string(loaded.error(), name);
    change(loaded->level);
    const auto saved =
        save_level(loaded->level, *loaded->format, path(as.empty() ? name : as), loaded->companion);
    return saved ? "" : to_string(saved.error(), name);
  }
  Level level_of(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? loaded->level : Level();
  }
};

void nothing(Level&) {}

TEST_F(SaveTiled, AnUnchangedMapKeepsItsBytes) {
  for (const Encoded& encoded : kEncodings) {
    const std::string text = map_in(encoded, 1);
    put("a.tmx", text);
    EXPECT_EQ(edit("a.tmx", nothing), "") << encoded.name;
    EXPECT_EQ(bytes_of("a.tmx"), text) << encoded.name;
    EXPECT_FALSE(exists("a.tmx.talus.json")) << encoded.name;
  }
}

TEST_F(SaveTiled, APaintedCellChangesOnlyTheData) {
  for (const Encoded& encoded : kEncodings) {
    put("a.tmx", map_in(encoded, 1));
    const auto paint = [](Level& level) {
      ASSERT_EQ(level.map.width(), 3);
      level.map.set({0, 0}, level.map.tile_at({1, 1}));  // the tile with the number 3
    };
    EXPECT_EQ(edit("a.tmx", paint), "") << encoded.name;
    EXPECT_EQ(bytes_of("a.tmx"), map_in(encoded, 3)) << encoded.name;
    EXPECT_FALSE(exists("a.tmx.talus.json")) << encoded.name;
  }
}

TEST_F(SaveTiled, MirroredTilesKeepTheirBits) {
  put("a.tmx", map_in(kEncodings[0], 1));
  const auto paint = [](Level& level) { level.map.set({0, 0}, level.map.at({0, 1})); };
  EXPECT_EQ(edit("a.tmx", paint), "");
  EXPECT_EQ(bytes_of("a.tmx"), map_in(kEncodings[0], 0x80000001));
}

TEST_F(SaveTiled, EachTurnIsWrittenAsItsBits) {
  for (const Encoded& encoded : kEncodings) {
    for (std::uint32_t turn = 0; turn < kTileTurns; ++turn) {
      put("a.tmx", map_in(encoded, 1));
      MapCell painted;
      const auto paint = [&](Level& level) {
        painted = {level.map.tile_at({1, 1}), static_cast<TileTurn>(turn)};  // the tile with the number 3
        level.map.set({0, 0}, painted);
      };
      EXPECT_EQ(edit("a.tmx", paint), "");
      EXPECT_EQ(bytes_of("a.tmx"), map_in(encoded, turn << 29 | 3)) << encoded.name << turn;
      EXPECT_FALSE(exists("a.tmx.talus.json"));
      EXPECT_EQ(level_of("a.tmx").map.at({0, 0}), painted);
    }
  }
}

TEST_F(SaveTiled, TilesThatNoTilesetHasStayInCells) {
  const std::string unknown = map_with("<data encoding=\"csv\">99,2,0,1,1,1</data>");
  put("a.tmx", unknown);
  const auto paint = [](Level& level) { level.map.set({2, 0}, level.map.tile_at({1, 0})); };
  EXPECT_EQ(edit("a.tmx", paint), "");
  EXPECT_EQ(bytes_of("a.tmx"), map_with("<data encoding=\"csv\">99,2,2,1,1,1</data>"));
}

TEST_F(SaveTiled, EmptyDataIsFilled) {
  const auto paint = [](Level& level) { level.map.set({1, 0}, 1); };
  put("a.tmx", map_with("<data encoding=\"csv\"/>"));
  EXPECT_EQ(edit("a.tmx", paint), "");
  EXPECT_EQ(bytes_of("a.tmx"), map_with("<data encoding=\"csv\">\n0,2,0,\n0,0,0\n</data>"));
}

TEST_F(SaveTiled, AnotherSizeIsWrittenToMapAndLayer) {
  const std::string data = "<data encoding=\"csv\">\n1,2,0,\n3,3,3\n</data>";
  put("a.tmx", map_with(data));
  const auto grow = [](Level& level) {
    TileMap larger(4, 3, level.map.tile_size());
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 3; ++x) larger.set({x, y}, level.map.tile_at({x, y}));
    level.map = larger;
  };
  EXPECT_EQ(edit("a.tmx", grow), "");
  EXPECT_EQ(bytes_of("a.tmx"), map_with("<data encoding=\"csv\">\n1,2,0,0,\n3,3,3,0,\n0,0,0,0\n</data>", "",
                                        "height=\"3\" width=\"4\""));
}

TEST_F(SaveTiled, WhatTheMapCannotHoldIsInItsCompanion) {
  const std::string text = map_in(kEncodings[0], 1);
  put("a.tmx", text);
  const auto change = [](Level& level) {
    level.tuning.shared.fall_blend = 0.125;
    level.brushes.push_back({.name = "b", .tiles = {3}, .extra = ""});
  };
  EXPECT_EQ(edit("a.tmx", change), "");
  EXPECT_EQ(bytes_of("a.tmx"), text);
  const Level again = level_of("a.tmx");
  EXPECT_EQ(again.tuning.shared.fall_blend, 0.125);
  ASSERT_EQ(again.brushes.size(), 1U);
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.tuning = level.tiled->opened->tuning;
                   level.brushes.clear();
                 }),
            "");
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

TEST_F(SaveTiled, NumbersOfTilesStayWithACompanion) {
  put("a.tmx", map_with("<data encoding=\"csv\">2147483649,1073741826,0,1,1,1</data>"));
  MapCell second;
  const auto change = [&](Level& level) {
    second = level.map.at({1, 0});
    level.map.set({0, 0}, 0);
    level.map.set({1, 0}, 0);
    level.brushes.push_back({.name = "b", .tiles = {second}, .extra = ""});
  };
  EXPECT_EQ(edit("a.tmx", change), "");
  EXPECT_EQ(edit("a.tmx",
                 [&](Level& level) {
                   ASSERT_EQ(level.brushes.size(), 1U);
                   level.map.set({0, 1}, level.brushes[0].tiles[0]);
                 }),
            "");
  EXPECT_EQ(bytes_of("a.tmx"), map_with("<data encoding=\"csv\">0,0,0,1073741826,1,1</data>"));
}

TEST_F(SaveTiled, TilesOfNoTilesetAreRefused) {
  const std::string text = map_in(kEncodings[0], 1);
  put("a.tmx", text);
  EXPECT_THAT(edit("a.tmx",
                   [](Level& level) {
                     level.map.set({0, 0}, 200);
                   }),
              HasSubstr("shows tile 200, which no tileset of the map has"));
  EXPECT_EQ(bytes_of("a.tmx"), text);
}

TEST_F(SaveTiled, OnlyALevelOfTiledIsWritten) {
  const auto saved = save_level(Level(), *find_format("tmx"), path("b.tmx"));
  ASSERT_FALSE(saved);
  EXPECT_THAT(saved.error().message, HasSubstr("only a level that came from it can be saved"));
  put("a.tmx", map_in(kEncodings[0], 1));
  std::filesystem::create_directory(path("other"));
  EXPECT_THAT(edit("a.tmx", nothing, "other/a.tmx"), HasSubstr("is not in the folder of the map"));
  EXPECT_THAT(edit("a.tmx", nothing, "a.tsx"), HasSubstr("which ends with .tmx"));
  EXPECT_EQ(edit("a.tmx", nothing, "b.tmx"), "");
  EXPECT_EQ(bytes_of("b.tmx"), bytes_of("a.tmx"));
}

std::string two_layers(const std::string& first, const std::string& second, const std::string& looks = "") {
  const std::string data = "<data encoding=\"csv\">";
  return map_with(data + first + "</data>", "\n <layer name=\"front\" width=\"3\" height=\"2\"" + looks +
                                                ">" + data + second + "</data></layer>");
}

TEST_F(SaveTiled, EachLayerIsWrittenIntoItsOwn) {
  put("a.tmx", two_layers("1,2,0,1,1,1", "0,0,0,3,3,3"));
  const auto change = [](Level& level) {
    ASSERT_EQ(level.layers.count(), 2);
    level.choose_layer(1);
    level.map.set({2, 1}, 0);
    level.layers.list[1].visible = false;
    level.layers.list[1].opacity = 0.5;
  };
  EXPECT_EQ(edit("a.tmx", change), "");
  EXPECT_EQ(bytes_of("a.tmx"), two_layers("1,2,0,1,1,1", "0,0,0,3,3,0", " visible=\"0\" opacity=\"0.5\""));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

// The cells of both layers, from the back, as they come from the file again.
std::vector<std::vector<TileNumber>> cells_of_layers(const Level& level) {
  std::vector<std::vector<TileNumber>> all;
  for (int layer = 0; layer < level.layers.count(); ++layer) all.push_back(level.cells_of(layer).tiles());
  return all;
}

// By layer, from the back, whether it is ground.
std::vector<bool> ground_of_layers(const Level& level) {
  std::vector<bool> all;
  for (const TileLayer& layer : level.layers.list) all.push_back(layer.is_ground);
  return all;
}

TEST_F(SaveTiled, SwappedNamesOfLayersAreNames) {
  put("a.tmx", two_layers("1,2,0,1,1,1", "0,0,0,3,3,3"));
  const auto change = [](Level& level) {
    TileLayer &behind = level.layers.list[0], &front = level.layers.list[1];
    std::swap(behind.name, front.name);
    std::swap(behind.is_ground, front.is_ground);  // which their names say
  };
  EXPECT_EQ(edit("a.tmx", change), "");
  std::string wanted = two_layers("1,2,0,1,1,1", "0,0,0,3,3,3");
  wanted.replace(wanted.find("\"ground\""), 8, "\"front\"");
  wanted.replace(wanted.rfind("\"front\""), 7, "\"ground\"");
  EXPECT_EQ(bytes_of("a.tmx"), wanted);
}

// The layer moves with its group, which is half transparent.
TEST_F(SaveTiled, MovedLayersKeepTheirText) {
  std::string text = two_layers("1,2,0,1,1,1", "0,0,0,3,3,3");
  text.insert(text.find("<group name") + 6, " opacity=\"0.5\"");
  put("a.tmx", text);
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.choose_layer(1);
                   TileLayer back = level.layers.list[0];
                   level.layers.list.erase(level.layers.list.begin());
                   level.layers.list.push_back(back);
                   level.layers.chosen = 0;
                 }),
            "");
  const Level again = level_of("a.tmx");
  ASSERT_EQ(again.layers.count(), 2);
  EXPECT_EQ(again.layers.list[1].name, "ground");
  EXPECT_EQ(shown_looks(again.layers.groups, again.layers.list[1]).opacity, 0.5);
  EXPECT_EQ(again.layers.list[0].name, "front");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<properties><property name=\"p\" value=\"1\"/></properties>\n  "
                                           "<data encoding=\"csv\">1,2,0,1,1,1</data>\n </layer>"));
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("<data encoding=\"csv\">0,0,0,3,3,3</data></layer>"));
}

TEST_F(SaveTiled, NewLayersHaveTheEncodingOfTheOthers) {
  for (const Encoded& encoded : kEncodings) {
    put("a.tmx", map_in(encoded, 1));
    std::vector<std::vector<TileNumber>> wanted;
    const auto add = [&](Level& level) {
      TileLayer added;
      added.name = "new";
      added.is_ground = false;
      added.opacity = 0.25;
      added.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{0, 0, 16, 0, 0, 1});
      level.layers.list.push_back(added);
      wanted = cells_of_layers(level);
    };
    EXPECT_EQ(edit("a.tmx", add), "") << encoded.name;
    const Level again = level_of("a.tmx");
    EXPECT_EQ(cells_of_layers(again), wanted) << encoded.name;
    EXPECT_EQ(again.layers.list.at(1).name, "new");
    EXPECT_EQ(again.layers.list.at(0).name, "ground");
    EXPECT_EQ(again.layers.list.at(1).opacity, 0.25);
    EXPECT_FALSE(again.layers.list.at(1).is_ground);
    EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(encoded.with(1))) << "the first layer's data stay";
    EXPECT_FALSE(exists("a.tmx.talus.json"));
  }
}

TEST_F(SaveTiled, RemovedLayersTakeTheirText) {
  put("a.tmx", two_layers("1,2,0,1,1,1", "0,0,0,3,3,3"));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.layers.list.pop_back(); }), "");
  EXPECT_EQ(bytes_of("a.tmx"), map_with("<data encoding=\"csv\">1,2,0,1,1,1</data>"));
  EXPECT_FALSE(exists("a.tmx.talus.json"));
}

// The name of the only named layer made the others drawn alone. Once it is no ground, they say so themselves.
TEST_F(SaveTiled, AnyLayerCanBeGroundOrNot) {
  const std::string text = two_layers("1,2,0,1,1,1", "0,0,0,3,3,3");
  ASSERT_NE(text.find("name=\"front\""), text.npos);
  for (const bool is_removed : {false, true}) {
    for (int ground = 0; ground < 8; ++ground) {
      std::string map = text;
      map.insert(map.find("<group"),
                 "<layer name=\"sky\" width=\"3\" height=\"2\"><data encoding=\"csv\">"
                 "3,0,0,0,0,0</data></layer>");
      put("a.tmx", map);
      std::vector<bool> wanted;
      const auto change = [&](Level& level) {
        ASSERT_EQ(level.layers.count(), 3);
        for (std::size_t i = 0; i < 3; ++i) level.layers.list[i].is_ground = (ground >> i & 1) != 0;
        level.choose_layer(0);
        if (is_removed) level.layers.list.erase(level.layers.list.begin() + 1);
        tidy_groups(level.layers, level.objects);
        wanted = ground_of_layers(level);
      };
      EXPECT_EQ(edit("a.tmx", change), "") << ground;
      EXPECT_EQ(ground_of_layers(level_of("a.tmx")), wanted) << ground;
      EXPECT_EQ(exists("a.tmx.talus.json"), is_removed) << "no layer has a name that makes its tiles solid";
    }
  }
}

TEST_F(SaveTiled, LooksOfLayersAreAttributes) {
  const std::string text = two_layers("1,2,0,1,1,1", "0,0,0,3,3,3", " offsetx=\"1\"");
  put("a.tmx", text);
  EXPECT_EQ(edit("a.tmx",
                 [](Level& level) {
                   level.layers.list[1].tint = {1, 2, 3};
                   level.layers.list[1].name = "far";
                   level.layers.list[1].offset = {2.5, 0};
                   level.layers.list[1].parallax = {0.5, 1};
                   level.layers.list[1].is_ground = true;  // the other one is by its name
                 }),
            "");
  std::string wanted =
      two_layers("1,2,0,1,1,1", "0,0,0,3,3,3", " offsetx=\"2.5\" tintcolor=\"#010203\" parallaxx=\"0.5\"");
  wanted.replace(wanted.find("\"front\""), 7, "\"far\"");
  EXPECT_FALSE(exists("a.tmx.talus.json"));
  std::string written = bytes_of("a.tmx");
  const std::string ground = "<property name=\"ground\" type=\"bool\" value=\"true\"/>";
  EXPECT_THAT(written, HasSubstr(ground));
  const std::size_t begin = written.rfind("<properties>", written.find(ground));
  written.erase(begin, written.find("<data", begin) - begin);
  EXPECT_EQ(written, wanted);
}

std::string infinite(const std::string& chunks) {
  return "<map orientation=\"orthogonal\" width=\"4\" height=\"4\" tilewidth=\"8\" tileheight=\"8\" "
         "infinite=\"1\">\n"
         " <tileset firstgid=\"1\" name=\"t\" tilewidth=\"8\" tileheight=\"8\" tilecount=\"4\" "
         "columns=\"2\"/>\n"
         " <layer name=\"l\" width=\"4\" height=\"4\">\n  <data encoding=\"csv\">" +
         chunks + "</data>\n </layer>\n</map>\n";
}
std::string chunk(int x, int y, const std::string& cells) {
  return "\n   <chunk x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) +
         "\" width=\"2\" height=\"2\">" + cells + "</chunk>";
}

TEST_F(SaveTiled, OnlyChangedChunksOfInfiniteMapsAreWritten) {
  const std::string first = chunk(-2, -2, "\n0,2,\n1,1\n"), last = chunk(2, 0, "3,3,0,0");
  put("a.tmx", infinite(first + last + "\n  "));
  const auto check = [](Level& level) {
    ASSERT_EQ(level.map.width(), 6);
    ASSERT_EQ(level.map.height(), 3);
    level.map.set({0, 0}, level.map.tile_at({5, 2}));  // at (-2, -2)
  };
  EXPECT_EQ(edit("a.tmx", nothing), "");
  EXPECT_EQ(bytes_of("a.tmx"), infinite(first + last + "\n  "));
  EXPECT_EQ(edit("a.tmx", check), "");
  EXPECT_EQ(bytes_of("a.tmx"), infinite(chunk(-2, -2, "\n3,2,\n1,1\n") + last + "\n  "));
}

TEST_F(SaveTiled, CellsOutsideOfChunksGetNewOnes) {
  const std::string both = chunk(-2, -2, "\n0,2,\n1,1\n") + chunk(2, 0, "3,3,0,0");
  put("a.tmx", infinite(both + "\n  "));
  EXPECT_EQ(edit("a.tmx", [](Level& level) { level.map.set({3, 1}, level.map.tile_at({5, 2})); }), "");
  EXPECT_EQ(bytes_of("a.tmx"), infinite(both + chunk(0, -2, "\n0,0,\n0,3\n") + "\n  "));
}

std::string json_map(const std::string& cells, const std::string& encoding = "") {
  return "{ \"layers\":[\n  {\"type\":\"group\", \"layers\":[\n    {\n     \"data\":" + cells +
         ",\n     \"height\":2,\n     \"name\":\"l\\\"}\",\"type\":\"tilelayer\",\n     \"width\":3" +
         encoding +
         "}]}],\n \"orientation\":\"orthogonal\", \"width\":3, \"height\":2, \"tilewidth\":8, "
         "\"tileheight\":8,\n \"own\":[{\"data\":[1]}, -2.50e1],\n \"tilesets\":[{\"firstgid\":1, "
         "\"name\":\"t\", \"tilewidth\":8, \"tileheight\":8, \"tilecount\":4, \"columns\":2}]}\n";
}

TEST_F(SaveTiled, NewLayersOfInfiniteMapsGetChunks) {
  const std::string first = chunk(-2, -2, "\n0,2,\n1,1\n"), last = chunk(2, 0, "3,3,0,0");
  put("a.tmx", infinite(first + last + "\n  "));
  const auto add = [](Level& level) {
    TileLayer added;
    added.name = "new";
    std::vector<TileNumber> cells(level.map.cells().size());
    cells.back() = 1;
    added.cells = std::make_shared<const MapCells>(cells);
    level.layers.list.insert(level.layers.list.begin(), added);
    level.layers.chosen = 1;
  };
  EXPECT_EQ(edit("a.tmx", add), "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr(first + last));
  EXPECT_LT(bytes_of("a.tmx").find("name=\"new\""), bytes_of("a.tmx").find("name=\"l\""));
  EXPECT_EQ(level_of("a.tmx").layers.count(), 2);
}

TEST_F(SaveTiled, JsonKeepsItsTextBesideTheCells) {
  const auto paint = [](Level& level) { level.map.set({0, 0}, level.map.tile_at({1, 1})); };
  const std::string zlib = ", \"encoding\":\"base64\",\"compression\":\"zlib\"";
  for (const auto& [before, after, how] : std::vector<std::array<std::string, 3>>{
           {"[1, 2, 0,\n  2147483649, 3, 0]", "[3, 2, 0,\n  2147483649, 3, 0]", ""},
           {"\"" + zlib_with(1) + "\"", "\"" + zlib_with(3) + "\"", zlib}}) {
    put("a.tmj", json_map(before, how));
    EXPECT_EQ(edit("a.tmj", nothing), "");
    EXPECT_EQ(bytes_of("a.tmj"), json_map(before, how));
    EXPECT_EQ(edit("a.tmj", paint), "");
    EXPECT_EQ(bytes_of("a.tmj"), json_map(after, how));
  }
}

// Tiled reads no layer of a finite map that has fewer cells than the map.
TEST_F(SaveTiled, NewEmptyLayersHaveAllCells) {
  put("a.tmj", json_map("[1, 2, 0,\n  2147483649, 3, 0]", ""));
  put("a.tmx", map_in(kEncodings[0], 1));
  const auto add = [](Level& level) {
    TileLayer added;
    added.name = "new";
    added.cells = std::make_shared<const MapCells>(6);
    level.layers.list.push_back(added);
  };
  EXPECT_EQ(edit("a.tmj", add), "");
  EXPECT_THAT(bytes_of("a.tmj"), HasSubstr("\"data\":[\n0,0,0,\n0,0,0\n]"));
  EXPECT_EQ(edit("a.tmx", add), "");
  EXPECT_THAT(bytes_of("a.tmx"), HasSubstr("\n0,0,0,\n0,0,0\n"));
}

TEST_F(SaveTiled, JsonGetsAndLosesLayers) {
  const std::string zlib = ", \"encoding\":\"base64\",\"compression\":\"zlib\"";
  for (const auto& [cells, how] : std::vector<std::pair<std::string, std::string>>{
           {"[1, 2, 0,\n  2147483649, 3, 0]", ""}, {"\"" + zlib_with(1) + "\"", zlib}}) {
    put("a.tmj", json_map(cells, how));
    const auto add = [](Level& level) {
      TileLayer added;
      added.name = "new \"";
      added.cells = std::make_shared<const MapCells>(std::vector<TileNumber>{0, 0, 16, 0, 0, 1});
      level.layers.list.push_back(added);
    };
    EXPECT_EQ(edit("a.tmj", add), "");
    const Level again = level_of("a.tmj");
    ASSERT_EQ(again.layers.count(), 2);
    EXPECT_EQ(again.cells_of(1).tiles(), (std::vector<TileNumber>{0, 0, 16, 0, 0, 1}));
    EXPECT_EQ(edit("a.tmj", [](Level& level) { level.layers.list.pop_back(); }), "");
    EXPECT_EQ(bytes_of("a.tmj"), json_map(cells, how));
  }
}

}  // namespace talus::save_tiled_test
