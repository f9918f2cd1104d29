// Mirrored tiles of LDtk are turned cells, in both directions.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include <talus/formats/format.h>
#include "export/exporter.h"
#include "export/map_paint.h"
#include "folder_test.h"
#include "ldtk_text.h"
#include "paths.h"
#include "png_bytes.h"

namespace talus::ldtk_mirrors_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr TileNumber kRamp = 1, kPicture = 2;
constexpr TileTurn kX = TileTurn::left_right, kY = TileTurn::up_down;

// 5x1 cells: a ramp as it is, mirrored in the three ways, and a picture that is turned right.
Level mirrored_level() {
  Level level;
  level.map = TileMap(5, 1);
  level.tile_shapes[kRamp] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  for (std::size_t i = 0; i < 8; ++i) {
    level.sheet(SheetId::tiles).images[kRamp][i * 9] = 4;  // a diagonal, and a corner
    level.sheet(SheetId::tiles).images[kRamp][1] = 6;
    level.sheet(SheetId::tiles).images[kPicture][i] = 9;
  }
  level.map.set({0, 0}, kRamp);
  level.map.set({1, 0}, {kRamp, kX});
  level.map.set({2, 0}, {kRamp, kY});
  level.map.set({3, 0}, {kRamp, turn_of(false, true, true)});
  level.map.set({4, 0}, {kPicture, kTurnRight});
  return level;
}

Exported exported(const Level& level) {
  const ReadAsset read = [](const std::string& name) { return read_file(source_path("assets/") + name); };
  auto made = find_exporter("ldtk")->make({level, "cave.ldtk", read});
  EXPECT_TRUE(made);
  return made.value_or(Exported());
}

TEST(ExportLdtkMirrors, AreFlipBits) {
  const Exported made = exported(mirrored_level());
  EXPECT_THAT(made.dropped, ElementsAre("that cells turn their tiles: 1 turned tile is a tile of its own"));
  const auto project = nlohmann::json::parse(made.files[0].bytes);
  const auto& layers = project["levels"][0]["layerInstances"];
  std::vector<int> flips, tiles;
  for (const auto& tile : layers[1]["gridTiles"]) {
    flips.push_back(tile["f"]);
    tiles.push_back(tile["t"]);
  }
  EXPECT_THAT(flips, ElementsAre(0, 1, 2, 3, 0));
  EXPECT_THAT(tiles, ElementsAre(kRamp, kRamp, kRamp, kRamp, 256));
  std::vector<std::string> shapes;
  for (const int value : layers[2]["intGridCsv"])
    shapes.push_back(value == 0 ? ""
                                : project["defs"]["layers"][2]["intGridValues"][value - 1]["identifier"]);
  EXPECT_THAT(shapes, ElementsAre("slope_0_to_8", "slope_8_to_0", "ceiling_slope_0_to_8",
                                  "ceiling_slope_8_to_0", ""));
  EXPECT_EQ(project["defs"]["tilesets"][0]["customData"].size(), 1u) << "of the ramp, once";
}

class LdtkMirrors : public FolderTest {
 protected:
  LoadedLevel load(const std::string& text) const {
    auto loaded = load_level(put("p.ldtk", text));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "p.ldtk");
    return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
  }
  // Four tiles, each of which has a red column at its left.
  void put_tiles() const {
    std::vector<Rgb> row;
    for (int x = 0; x < 32; ++x)
      row.push_back(x % 8 == 0 ? Rgb{255, 0, 0} : Rgb{0, static_cast<std::uint8_t>(x), 9});
    std::vector<Rgb> pixels;
    for (int y = 0; y < 8; ++y) pixels.insert(pixels.end(), row.begin(), row.end());
    put("t.png", rgb_png(32, pixels));
  }
  // A layer of tiles with the first one in each way.
  static std::string all_ways() {
    std::string tiles;
    for (int f = 0; f < 4; ++f) tiles += (f == 0 ? "" : ",") + ldtk_tile(8 * f, 0, 0, f);
    return tiles;
  }
};

TEST_F(LdtkMirrors, BecomeTurnsOfOneTile) {
  put_tiles();
  const Level level = load(ldtk_project(ldtk_level(ldtk_tiles(4, 1, all_ways())))).level;
  EXPECT_THAT(level.map.cells().tiles(), ElementsAre(1, 1, 1, 1));
  EXPECT_EQ(level.map.cells().turn_of(1), kX);
  EXPECT_EQ(level.map.cells().turn_of(2), kY);
  EXPECT_EQ(level.map.cells().turn_of(3), turn_of(false, true, true));
  const auto pixels =
      map_pixels(level, 0, static_cast<int>(level.map.px_height()), [](double) { return true; });
  EXPECT_EQ(pixels[0], 255);
  EXPECT_EQ(pixels[4 * 15], 255) << "the second one is mirrored";
}

// Also where the level shows the tile in no other way.
TEST_F(LdtkMirrors, NeedNoTileThatIsNotMirrored) {
  put_tiles();
  const Level level = load(ldtk_project(ldtk_level(ldtk_tiles(2, 1, ldtk_tile(0, 0, 1, 2))))).level;
  EXPECT_EQ(level.map.cells()[0], (MapCell{1, kY}));
  EXPECT_THAT(level.ldtk->tiles.at(1), HasSubstr(" 8 0 1 8 0 255 ")) << "the tile itself, without its flip";
}

TEST_F(LdtkMirrors, SlopesOfTagsAreTurnedWithThem) {
  put_tiles();
  const std::string tags = R"("enumTags":[{"enumValueId":"slope_up","tileIds":[0]}])";
  const Level level =
      load(ldtk_project(ldtk_level(ldtk_tiles(4, 1, all_ways())), "", ldtk_tileset(tags))).level;
  EXPECT_THAT(level.map.cells().tiles(), ElementsAre(1, 1, 1, 1));
  const TileShape slope{.kind = TileShape::Kind::slope, .heights = {0, 8}};
  EXPECT_EQ(shape_of_tile(level, 1), slope);
  EXPECT_EQ(shape_of_cell(level, {1, kX}).heights, (std::vector<double>{8, 0}));
}

// The value of a cell is not mirrored with the tile that LDtk shows there.
TEST_F(LdtkMirrors, SlopesOfValuesStayAsTheyAre) {
  put_tiles();
  const std::string grid =
      ldtk_grid(4, 1, "1,1,2,2", R"("__tilesetDefUid":1,"autoLayerTiles":[)" + all_ways() + "]");
  const std::string values = R"({"value":1,"identifier":"wall"},{"value":2,"identifier":"slope up"})";
  const Level level = load(ldtk_project(ldtk_level(grid), values)).level;
  EXPECT_EQ(level.map.cells()[1], (MapCell{level.map.tile_at({0, 0}), kX})) << "a wall is the same mirrored";
  for (const int x : {2, 3}) {
    EXPECT_EQ(level.map.cells().turn_of(static_cast<std::size_t>(x)), TileTurn::none);
    EXPECT_EQ(shape_of_tile(level, level.map.tile_at({x, 0})).heights, (std::vector<double>{0, 8}));
  }
}

TEST_F(LdtkMirrors, AnExportedLevelHasItsTurnsAgain) {
  Level level = mirrored_level();
  const Exporter& exporter = *find_exporter("ldtk");
  ASSERT_TRUE(write_exported(exporter, exported(level), path("cave.ldtk")));
  const auto again = load_level(path("cave.ldtk"));
  ASSERT_TRUE(again) << to_string(again.error(), "cave.ldtk");
  const int tiles = again->level.layers.count() - 1;
  const auto name = [&](int layer) { return again->level.layers.list[static_cast<std::size_t>(layer)].name; };
  const MapCells& cells = again->level.cells_of(name(tiles) == "Tiles" ? tiles : 0);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(cells.turn_of(i), level.map.cells().turn_of(i)) << i;
  EXPECT_EQ(cells.tiles()[0], cells.tiles()[3]);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_EQ(shape_of_cell(again->level, again->level.map.cells()[i]),
              shape_of_cell(level, level.map.cells()[i]))
        << i;
}

// A companion of an older version, in which a mirrored tile is a tile of its own.
TEST_F(LdtkMirrors, KnownTilesStayTilesOfTheirOwn) {
  put_tiles();
  const std::string text = ldtk_project(ldtk_level(ldtk_tiles(4, 1, all_ways())));
  ImportChoices choices;
  choices.ldtk_tiles = {"", "0 0 1 0 0 0 8 1 255 0 0 0 0"};
  const auto loaded = load_level(put("p.ldtk", text), choices);
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->level.map.cells()[1], (MapCell{1, TileTurn::none}));
  EXPECT_EQ(loaded->level.map.cells()[0], (MapCell{2, TileTurn::none}));
  EXPECT_EQ(loaded->level.map.cells()[2], (MapCell{2, kY}));
}

}  // namespace talus::ldtk_mirrors_test
