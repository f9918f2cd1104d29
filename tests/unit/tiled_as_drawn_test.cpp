// Maps of Tiled become what Tiled itself draws of them.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>

#include <talus/level/ground.h>
#include "cli_answer.h"
#include "folder_test.h"
#include "formats/pictures/png_picture.h"
#include "level/tile_color.h"
#include "tiled_files.h"

namespace talus::tiled_as_drawn_test {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class TiledAsDrawn : public FolderTest {
 protected:
  LoadedLevel load(const std::string& name) const {
    auto loaded = load_level(path(name));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), name);
    return loaded ? *loaded : LoadedLevel{Level(), nullptr};
  }
  std::string error_of(const std::string& name) const {
    const auto loaded = load_level(path(name));
    return loaded ? "" : to_string(loaded.error(), name);
  }
  // A picture whose pixel at (x, y) has the red x and the green y.
  void put_picture(const std::string& name, int width, int height) const {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x)
        pixels.insert(pixels.end(), {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), 0, 255});
    }
    put(name, encode_png(width, height, 4, pixels.data()));
  }
  // A map of cells of 4x4 px with one row.
  void put_map(const std::string& tilesets, const std::string& cells, const std::string& more = "",
               const std::string& head = "") const {
    const auto width = std::to_string(std::count(cells.begin(), cells.end(), ',') + 1);
    put("m.tmx", "<map orientation=\"orthogonal\" width=\"" + width +
                     "\" height=\"1\" tilewidth=\"4\" tileheight=\"4\"" + head + ">" + tilesets +
                     "<layer name=\"l\" width=\"" + width + "\" height=\"1\"><data encoding=\"csv\">" +
                     cells + "</data></layer>" + more + "</map>");
  }
};

std::string tileset(const std::string& attributes, const std::string& inside, int first = 1) {
  return "<tileset firstgid=\"" + std::to_string(first) + "\" name=\"t\" " + attributes + ">" + inside +
         "</tileset>";
}
const std::string kSize = "tilewidth=\"4\" tileheight=\"4\" ";
const std::string kPicture = "<image source=\"t.png\"/>";

// The red and the green of the top left pixel of a tile.
std::array<int, 2> corner_of(const Level& level, int tile) {
  const SheetLayout layout = level.sheet(SheetId::tiles).layout();
  const TileSize size = level.map.tile_size();
  const Cell place = layout.place_of(tile);
  const std::uint8_t* pixel =
      level.sheet(SheetId::tiles).picture->at(place.x * size.width, place.y * size.height);
  return {pixel[0], pixel[1]};
}

TEST_F(TiledAsDrawn, TheMarginOfATilesetCountsOnce) {
  put_picture("t.png", 12, 11);  // two tiles and gaps of 1 px, with a margin at the left and at the top
  for (const std::string said : {"", "tilecount=\"4\"", "columns=\"2\" tilecount=\"4\"", "columns=\"1\""}) {
    put_map(tileset(kSize + said + " spacing=\"1\" margin=\"2\"", kPicture), "1,2,3,4");
    const Level level = load("m.tmx").level;
    EXPECT_EQ(corner_of(level, level.map.tile_at({1, 0})), (std::array{7, 2})) << said;
    EXPECT_EQ(corner_of(level, level.map.tile_at({2, 0})), (std::array{2, 7})) << said;
    EXPECT_EQ(corner_of(level, level.map.tile_at({3, 0})), (std::array{7, 7})) << said;
  }
}

TEST_F(TiledAsDrawn, AGrownPictureHasMoreTiles) {
  put_picture("t.png", 8, 12);
  put_map(
      tileset(kSize + "tilecount=\"2\" columns=\"2\"", "<image source=\"t.png\" width=\"8\" height=\"4\"/>"),
      "1,2,6");
  const LoadedLevel loaded = load("m.tmx");
  EXPECT_EQ(corner_of(loaded.level, loaded.level.map.tile_at({2, 0})), (std::array{4, 8}));
  EXPECT_THAT(loaded.dropped, Not(Contains(HasSubstr("which no tileset has"))));
}

TEST_F(TiledAsDrawn, NewLevelsCountTheMarginOnce) {
  put_picture("t.png", 12, 12);
  const CliAnswer made = cli_answer({"new", "--tiles", path("t.png"), "--tile-size", "4x4", "--spacing", "1",
                                     "--margin", "3", "-o", path("a.talus.json")});
  EXPECT_THAT(made.out, HasSubstr("4 tiles of 4x4 px")) << made.err;
}

// Whether the ground of the map's only tile is that box, px of its cell.
void expect_box(const Level& level, Cell cell, Vec2 from, Vec2 to) {
  const TileShape shape = shape_of_tile(level, level.map.tile_at(cell));
  ASSERT_EQ(shape.kind, TileShape::Kind::polygon);
  for (const Vec2 p : shape.points) {
    EXPECT_TRUE(p.x == from.x || p.x == to.x) << p.x;
    EXPECT_TRUE(p.y == from.y || p.y == to.y) << p.y;
  }
}

TEST_F(TiledAsDrawn, OblongTilesThatTurnHaveTheirGround) {
  put_picture("t.png", 4, 2);
  const std::string box =
      "<tile id=\"0\"><objectgroup><object width=\"4\" height=\"2\"/></objectgroup></tile>";
  const std::string set = tileset("tilewidth=\"4\" tileheight=\"2\"", kPicture + box);
  for (const std::uint32_t turn : {0x20000000U, 0x60000000U, 0xa0000000U, 0xe0000000U}) {
    put_map(set, "0," + std::to_string(turn + 1));
    expect_box(load("m.tmx").level, {1, 0}, {0, 0}, {2, 4});
  }
}

TEST_F(TiledAsDrawn, BodiesAreWhereTheirTilesetAlignsThem) {
  put_picture("t.png", 4, 6);
  const std::vector<std::pair<std::string, Vec2>> corners = {
      {"unspecified", {20, 14}}, {"topleft", {20, 20}},    {"top", {18, 20}},   {"topright", {16, 20}},
      {"left", {20, 17}},        {"center", {18, 17}},     {"right", {16, 17}}, {"bottomleft", {20, 14}},
      {"bottom", {18, 14}},      {"bottomright", {16, 14}}};
  for (const auto& [word, corner] : corners) {
    for (const std::string size : {" width=\"4\" height=\"6\"", ""}) {
      put_map(tileset("tilewidth=\"4\" tileheight=\"6\" objectalignment=\"" + word + "\"", kPicture), "0,0",
              "<objectgroup><object id=\"1\" type=\"player\" gid=\"1\" x=\"20\" y=\"20\"" + size +
                  "/></objectgroup>");
      LoadedLevel loaded = load("m.tmx");
      ASSERT_EQ(loaded.level.spawns.size(), 1U) << word;
      EXPECT_EQ(loaded.level.spawns[0].position, corner) << word << size;
      loaded.level.spawns[0].position.x += 8;
      loaded.level.spawns[0].size = {2, 2};
      ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
      EXPECT_EQ(load("m.tmx").level.spawns, loaded.level.spawns) << word;
      EXPECT_FALSE(exists("m.tmx.talus.json"));
    }
  }
}

TEST_F(TiledAsDrawn, ATilesetMayHaveNoTiles) {
  put_picture("t.png", 4, 4);
  const std::string empty =
      "<tileset name=\"e\" tilewidth=\"0\" tileheight=\"0\" tilecount=\"0\" columns=\"0\"/>";
  put("e.tsx", empty);
  put_map("<tileset firstgid=\"1\" source=\"e.tsx\"/>" + tileset(kSize, kPicture), "0,1");
  const LoadedLevel loaded = load("m.tmx");
  EXPECT_NE(loaded.level.map.tile_at({1, 0}), 0);
  const std::string text = bytes_of("m.tmx");
  ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
  EXPECT_EQ(bytes_of("m.tmx"), text);
  put_map("<tileset firstgid=\"1\" source=\"e.tsx\"/>", "0,1");
  EXPECT_THAT(load("m.tmx").dropped, Contains("tile 1 in cells, which no tileset has"));
  EXPECT_EQ(load("e.tsx").level.map.tile_at({3, 3}), 0);
}

TEST_F(TiledAsDrawn, AMapIsNoTileset) {
  put("o.tmx", "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"4\" tileheight=\"4\"/>");
  put("o.tmj",
      R"({"type":"map","orientation":"orthogonal","width":1,"height":1,"tilewidth":4,"tileheight":4,)"
      R"("layers":[],"tilesets":[]})");
  put("o.tx", "<template><object/></template>");
  for (const std::string name : {"o.tmx", "o.tmj", "o.tx"}) {
    put_map("<tileset firstgid=\"1\" source=\"" + name + "\"/>", "0,1");
    EXPECT_EQ(error_of("m.tmx"), "m.tmx:file " + name + ": error: is a " +
                                     (name == "o.tx" ? "template" : "map") +
                                     " of Tiled, but must be a tileset");
  }
}

TEST_F(TiledAsDrawn, AnAbsoluteTilesetIsListedAndBoxed) {
  put_map("<tileset firstgid=\"1\" source=\"/nowhere/none.tsx\"/>", "0,2");
  const LoadedLevel loaded = load("m.tmx");
  EXPECT_THAT(loaded.dropped,
              Contains("the tileset, file /nowhere/none.tsx: must be relative to the folder of the map"));
  EXPECT_NE(loaded.level.map.tile_at({1, 0}), 0);
}

TEST_F(TiledAsDrawn, PicturesAreAsLongAsTheirPixelsAllow) {
  put_picture("t.png", 4, 8192);
  put_map(tileset(kSize, kPicture), "0,2048");
  const Level level = load("m.tmx").level;
  EXPECT_EQ(corner_of(level, level.map.tile_at({1, 0})), (std::array{0, 8188 % 256}));
}

TEST_F(TiledAsDrawn, WideTilesetsAndLongOnesGoTogether) {
  put_picture("t.png", 4 * 200, 4);
  put_picture("u.png", 4, 4 * 400);
  put_map(tileset(kSize, kPicture) + tileset(kSize, "<image source=\"u.png\"/>", 201), "0,200,201,600");
  const LoadedLevel loaded = load("m.tmx");
  EXPECT_EQ(corner_of(loaded.level, loaded.level.map.tile_at({1, 0})), (std::array{796 % 256, 0}));
  EXPECT_EQ(corner_of(loaded.level, loaded.level.map.tile_at({3, 0})), (std::array{0, 1596 % 256}));
  const std::string text = bytes_of("m.tmx");
  ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
  EXPECT_EQ(bytes_of("m.tmx"), text);
}

// The palette is fitted to the few colours of the tiles when either map is read.
TEST_F(TiledAsDrawn, AnExportHasTheBackgroundOfTheMap) {
  std::vector<std::uint8_t> pixels;
  for (int i = 0; i < 8 * 4; ++i)
    pixels.insert(pixels.end(), {250, static_cast<std::uint8_t>(i % 8 < 4 ? 240 : 0), 50, 255});
  put("t.png", encode_png(8, 4, 4, pixels.data()));
  put_map(tileset(kSize, kPicture), "2,0,1", "", " backgroundcolor=\"#102030\"");
  const Level level = load("m.tmx").level;
  EXPECT_EQ(level.background, (Rgba{0x10, 0x20, 0x30, 255}));
  EXPECT_EQ(level.palette[0], default_palette()[0]);
  for (const ExportedFile& file : tiled_export_of(level, "tmx", "x.tmx").files)
    put(file.name.empty() ? "x.tmx" : file.name, file.bytes);
  const LoadedLevel again = load("x.tmx");
  EXPECT_EQ(again.level.background, (Rgba{0x10, 0x20, 0x30, 255}));
  EXPECT_THAT(again.dropped, Not(Contains(HasSubstr("backgroundcolor"))));
  EXPECT_EQ(color_on_map(again.level, again.level.map.tile_at({2, 0}), 0, 0), (Rgb{250, 240, 50}));
}

TEST_F(TiledAsDrawn, ColoursHaveThreeSixOrEightDigits) {
  put_picture("t.png", 4, 4);
  const auto read = [&](const std::string& tint, const std::string& background) {
    put("m.tmx",
        "<map orientation=\"orthogonal\" width=\"1\" height=\"1\" tilewidth=\"4\" tileheight=\"4\" "
        "backgroundcolor=\"" +
            background + "\">" + tileset(kSize, kPicture) + "<layer name=\"a\" tintcolor=\"" + tint +
            "\"><data encoding=\"csv\">1</data></layer><layer name=\"b\"><data "
            "encoding=\"csv\">0</data></layer></map>");
    return load("m.tmx");
  };
  LoadedLevel loaded = read("#80ff8000", "#FFE0F8D0");
  EXPECT_EQ(loaded.level.layers.list[0].tint, (Rgb{128, 64, 0}));
  EXPECT_DOUBLE_EQ(loaded.level.layers.list[0].opacity, 128 / 255.0);
  EXPECT_EQ(loaded.level.background, (Rgba{0xe0, 0xf8, 0xd0, 255}));
  EXPECT_THAT(loaded.dropped, Not(Contains(HasSubstr("backgroundcolor"))));
  loaded = read("#f80", "#000000ff");
  EXPECT_EQ(loaded.level.layers.list[0].tint, (Rgb{255, 136, 0}));
  EXPECT_EQ(loaded.level.background, (Rgba{0, 0, 255, 0})) << "it is clear";
}

std::string layer(const std::string& name, const std::string& cells, const std::string& more = "") {
  return "<layer name=\"" + name + "\">" + more + "<data encoding=\"csv\">" + cells + "</data></layer>";
}
std::string map_of(const std::string& layers, const std::string& tiles = "") {
  return "<map orientation=\"orthogonal\" width=\"2\" height=\"1\" tilewidth=\"4\" tileheight=\"4\">" +
         tileset(kSize + "tilecount=\"2\"", "<image source=\"t.png\"/>" + tiles) + layers + "</map>";
}
std::string bool_property(const std::string& name, bool value) {
  return "<properties><property name=\"" + name + "\" type=\"bool\" value=\"" + (value ? "true" : "false") +
         "\"/></properties>";
}
std::vector<bool> ground_of_layers(const Level& level) {
  std::vector<bool> ground;
  for (const TileLayer& layer : level.layers.list) ground.push_back(layer.is_ground);
  return ground;
}

TEST_F(TiledAsDrawn, LayersWithANameOfGroundAreGround) {
  using testing::ElementsAre;
  put_picture("t.png", 8, 4);
  const auto ground = [&](const std::string& layers) {
    put("m.tmx", map_of(layers));
    return ground_of_layers(load("m.tmx").level);
  };
  EXPECT_THAT(ground(layer("sky", "1,1") + layer("Collision", "0,1")), ElementsAre(false, true));
  EXPECT_THAT(ground(layer("sky", "1,1") + layer("things", "0,1")), ElementsAre(true, true));
  EXPECT_THAT(ground(layer("sky", "1,1", bool_property("collides", true)) + layer("walls", "0,1")),
              ElementsAre(true, true));
  EXPECT_THAT(ground(layer("a", "1,1") + layer("walls", "0,1", bool_property("ground", false))),
              ElementsAre(true, false));
  EXPECT_THAT(ground("<group name=\"g\">" + bool_property("ground", true) + layer("a", "1,1") + "</group>" +
                     layer("solids", "0,1")),
              ElementsAre(true, true));
}

TEST_F(TiledAsDrawn, NumbersAndPlainWordsDoNotHideANameOfGround) {
  put_picture("t.png", 8, 4);
  const auto is_ground = [&](const std::string& name) {
    put("m.tmx", map_of(layer("sky", "1,1") + layer(name, "0,1")));
    return ground_of_layers(load("m.tmx").level) == std::vector<bool>{false, true};
  };
  for (const char* name : {"WALLS", "Walls 2", "walls1", "CollisionLayer", "Ground tiles", "solid_map",
                           "Platforms (one way)", "Tile Layer: Ground"})
    EXPECT_TRUE(is_ground(name)) << name;
  for (const char* name : {"Ground decoration", "underground", "Background", "Tile Layer 1", "(walls)", ""})
    EXPECT_FALSE(is_ground(name)) << name;
}

TEST_F(TiledAsDrawn, ALayerGetsANameOfGroundAndStaysAsItIs) {
  put_picture("t.png", 8, 4);
  put("m.tmx", map_of(layer("a", "1,1") + layer("b", "0,1")));
  LoadedLevel loaded = load("m.tmx");
  loaded.level.layers.list[1].name = "collision";
  ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
  EXPECT_EQ(load("m.tmx").level.layers, loaded.level.layers);
}

TEST_F(TiledAsDrawn, TilesOfACollisionLayerAreSolid) {
  put_picture("t.png", 8, 4);
  const auto kind = [](const Level& level, Cell cell) {
    return shape_of_tile(level, level.map.tile_at(cell)).kind;
  };
  using enum TileShape::Kind;
  put("m.tmx", map_of(layer("sky", "2,2") + layer("collision", "0,1")));
  LoadedLevel loaded = load("m.tmx");
  EXPECT_EQ(loaded.level.layers.chosen, 1);
  EXPECT_EQ(kind(loaded.level, {1, 0}), solid);
  loaded.level.tile_shapes[loaded.level.map.tile_at({1, 0})] = {};
  ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
  EXPECT_EQ(kind(load("m.tmx").level, {1, 0}), none) << "what the user made is kept";
  std::filesystem::remove(path("m.tmx.talus.json"));
  put("m.tmx",
      map_of(layer("collision", "2,1"), "<tile id=\"1\">" + bool_property("collides", true) + "</tile>"));
  const Level by_word = load("m.tmx").level;
  EXPECT_EQ(kind(by_word, {0, 0}), solid);
  EXPECT_EQ(kind(by_word, {1, 0}), none) << "tiles say which are solid";
}

// As a collision layer; where several names say it, the clearest counts alone.
TEST_F(TiledAsDrawn, TilesOfALayerCalledWallsOrGroundAreSolid) {
  put_picture("t.png", 8, 4);
  const auto solid_in = [&](const std::string& layers) {
    put("m.tmx", map_of(layers));
    const Level level = load("m.tmx").level;
    std::vector<bool> solid;
    for (int i = 0; i < level.layers.count(); ++i)
      solid.push_back(level.layers.list[static_cast<std::size_t>(i)].is_ground &&
                      shape_of_tile(level, level.cells_of(i).tiles().back()).kind == TileShape::Kind::solid);
    return solid;
  };
  for (const char* const name : {"Ground", "walls", "WALL", "platform", "Platforms"})
    EXPECT_THAT(solid_in(layer("sky", "2,2") + layer(name, "0,1")), testing::ElementsAre(false, true))
        << name;
  EXPECT_THAT(solid_in(layer("sky", "2,2") + layer("underground", "0,1")),
              testing::ElementsAre(false, false));
}

// The first tile of the tileset is clear, so that empty cells keep its number.
TEST_F(TiledAsDrawn, EmptyCellsOfANamedLayerAreNoGround) {
  std::vector<std::uint8_t> pixels(4 * 8 * 4, 255);
  for (std::size_t i = 0; i < pixels.size(); i += 4)
    if (i / 4 % 8 < 4) pixels[i + 3] = 0;
  put("t.png", encode_png(8, 4, 4, pixels.data()));
  for (const char* const name : {"Collision", "Ground"}) {
    put("m.tmx", map_of(layer("sky", "0,2") + layer(name, "0,2")));
    const Level level = load("m.tmx").level;
    const Terrain terrain = terrain_of(level);
    EXPECT_EQ(terrain.shape_at({0, 0}).kind, TileShape::Kind::none) << name;
    EXPECT_EQ(terrain.shape_at({1, 0}).kind, TileShape::Kind::solid) << name;
  }
}

// A tile that was not shown is ground as soon as it is painted, and saving needs no companion for it.
TEST_F(TiledAsDrawn, WhatIsPaintedOnNamedGroundIsGround) {
  put_picture("t.png", 8, 4);
  put("m.tmx", map_of(layer("sky", "2,2") + layer("walls", "0,1")));
  LoadedLevel loaded = load("m.tmx");
  const TileNumber other = loaded.level.cells_of(0).tiles().front();
  loaded.level.map.set({0, 0}, other);
  loaded.level.map.set({1, 0}, 0);
  EXPECT_EQ(shape_of_tile(loaded.level, other).kind, TileShape::Kind::solid);
  ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
  EXPECT_FALSE(exists("m.tmx.talus.json"));
  EXPECT_EQ(shape_of_tile(load("m.tmx").level, other).kind, TileShape::Kind::solid);
}

TEST_F(TiledAsDrawn, TilesThatCollideAreSolid) {
  put_picture("t.png", 8, 4);
  for (const std::string word : {"collides", "collidable", "solid"}) {
    put("m.tmx", map_of(layer("a", "0,2"), "<tile id=\"1\">" + bool_property(word, true) + "</tile>"));
    LoadedLevel loaded = load("m.tmx");
    const TileNumber tile = loaded.level.map.tile_at({1, 0});
    EXPECT_EQ(shape_of_tile(loaded.level, tile).kind, TileShape::Kind::solid) << word;
    if (word == "solid") continue;  // a flag
    EXPECT_EQ(loaded.level.tile_flags(tile), 0U);
    loaded.level.tile_shapes[tile] = {};
    ASSERT_TRUE(save_level(loaded.level, *loaded.format, path("m.tmx"), loaded.companion));
    EXPECT_EQ(load("m.tmx").level.tile_shapes[tile].kind, TileShape::Kind::none) << word;
  }
}

TEST_F(TiledAsDrawn, APointInATileIsNoOutline) {
  put_picture("t.png", 8, 4);
  const std::string point = "<object x=\"2\" y=\"2\"><point/></object>";
  const auto shape = [&](const std::string& objects, const std::string& more = "") {
    put("m.tmx", map_of(layer("a", "0,2"),
                        "<tile id=\"1\">" + more + "<objectgroup>" + objects + "</objectgroup></tile>"));
    const LoadedLevel loaded = load("m.tmx");
    EXPECT_THAT(loaded.dropped, Not(Contains(HasSubstr("outline"))));
    return shape_of_tile(loaded.level, loaded.level.map.tile_at({1, 0})).kind;
  };
  EXPECT_EQ(shape(point), TileShape::Kind::none);
  EXPECT_EQ(shape(point + "<object width=\"4\" height=\"4\"/>"), TileShape::Kind::solid);
  EXPECT_EQ(shape(point, bool_property("collides", true)), TileShape::Kind::solid);
}

}  // namespace talus::tiled_as_drawn_test
