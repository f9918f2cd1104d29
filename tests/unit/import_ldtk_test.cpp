// Projects of LDtk as levels: ground, pictures, flags and bodies.
#include <gmock/gmock.h>

#include <regex>

#include <talus/formats/format.h>
#include <talus/level/tile_turns.h>
#include "export/exporter.h"
#include "folder_test.h"
#include "ldtk_text.h"
#include "paths.h"
#include "png_bytes.h"

namespace talus::import_ldtk_test {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr Rgb kRed{255, 0, 0}, kGreen{0, 255, 0}, kBlue{0, 0, 255}, kBack{16, 32, 48};
constexpr const char* kWall = R"({"value":1,"identifier":"wall","color":"#FF8000"})";

// Reads a text, without the files beside it.
FormatResult<LoadedLevel> read(const std::string& text, const ImportChoices& choices = {}) {
  FormatContext context{"ldtk"};
  context.choices = choices;
  return read_level(text, context);
}
LoadedLevel loaded_of(const std::string& text, const ImportChoices& choices = {}) {
  auto loaded = read(text, choices);
  EXPECT_TRUE(loaded) << to_string(loaded.error(), "file");
  return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
}
Level level_of(const std::string& text) { return loaded_of(text).level; }
std::string error_of(const std::string& text, const ImportChoices& choices = {}) {
  const auto loaded = read(text, choices);
  return loaded ? "" : to_string(loaded.error(), "file");
}
TileShape shape_at(const Level& level, int column, int row = 0) {
  const auto cell = static_cast<std::size_t>(row * level.map.width() + column);
  return shape_of_cell(level, level.map.cells()[cell]);
}
std::vector<double> heights_at(const Level& level, int column) { return shape_at(level, column).heights; }
bool is_solid_at(const Level& level, int column) {
  return shape_at(level, column) == TileShape{.kind = TileShape::Kind::solid};
}

TEST(ImportLdtk, ValuesAreSolidUnlessTheirNamesSayOtherwise) {
  const std::string values =
      std::string(kWall) + R"(,{"value":2,"identifier":"Ladder"},{"value":3,"identifier":"OneWayPlatform"})" +
      R"(,{"value":4,"identifier":null})";
  const Level level = level_of(ldtk_project(ldtk_level(ldtk_grid(3, 2, "0,1,2,3,4,9")), values));
  EXPECT_EQ(level.map.width(), 3);
  EXPECT_EQ(level.map.height(), 2);
  EXPECT_EQ(level.map.tile_size(), (TileSize{8, 8}));
  EXPECT_EQ(level.map.at({0, 0}), 0);
  EXPECT_EQ(shape_at(level, 0).kind, TileShape::Kind::none);
  EXPECT_TRUE(is_solid_at(level, 1));
  EXPECT_EQ(shape_at(level, 2).kind, TileShape::Kind::none);
  EXPECT_EQ(shape_at(level, 0, 1), (TileShape{.kind = TileShape::Kind::solid, .one_way = true}));
  EXPECT_EQ(shape_at(level, 1, 1).kind, TileShape::Kind::solid);
  EXPECT_EQ(shape_at(level, 2, 1).kind, TileShape::Kind::solid) << "a value without a definition";
}

TEST(ImportLdtk, NamesOfSlopesGiveTheirHeights) {
  const std::string values =
      R"({"value":1,"identifier":"slope_0_to_8"},{"value":2,"identifier":"SlopeDown"},)"
      R"({"value":3,"identifier":"one_way_ceiling_slope_2p5_to_8_over_2_tiles"},)"
      R"({"value":4,"identifier":"slope_left"},{"value":5,"identifier":"slope_0_to_8_over_2_tiles_part_2"})";
  const LoadedLevel loaded = loaded_of(ldtk_project(ldtk_level(ldtk_grid(5, 1, "1,2,3,4,5")), values));
  EXPECT_THAT(heights_at(loaded.level, 0), ElementsAre(0, 8));
  EXPECT_THAT(heights_at(loaded.level, 1), ElementsAre(8, 0));
  const TileShape wide = shape_at(loaded.level, 2);
  EXPECT_THAT(wide.heights, ElementsAre(2.5, 8));
  EXPECT_EQ(wide.tiles, 2);
  EXPECT_EQ(wide.side, TileShape::Side::ceiling);
  EXPECT_TRUE(wide.one_way);
  EXPECT_TRUE(is_solid_at(loaded.level, 3));
  EXPECT_THAT(
      loaded.dropped,
      Contains("the slope of the value \"slope_left\", as its name does not tell how it goes: it is a "
               "full tile"));
  EXPECT_EQ(shape_at(loaded.level, 4).kind, TileShape::Kind::none) << "a part of another cell's slope";
}

TEST(ImportLdtk, NamesThatAreNotPlainGroundBecomeFlags) {
  const std::string values =
      std::string(kWall) + R"(,{"value":2,"identifier":"ladder"})" + R"(,{"value":3,"identifier":"ice"})";
  const Level level = level_of(ldtk_project(ldtk_level(ldtk_grid(3, 1, "1,2,3")), values));
  EXPECT_EQ(level.flag_names[4], "ice");
  EXPECT_EQ(level.flag_names[5], "ladder");
  EXPECT_EQ(level.tile_flags(level.map.tile_at({0, 0})), 1);
  EXPECT_EQ(level.tile_flags(level.map.tile_at({1, 0})), 1 << 5);
  EXPECT_EQ(level.tile_flags(level.map.tile_at({2, 0})), 1 | 1 << 4);
}

TEST(ImportLdtk, GridsWithoutTilesetsHaveTheColoursOfTheirValues) {
  const Level level = level_of(ldtk_project(ldtk_level(ldtk_grid(2, 1, "1,0", R"("__opacity":1)")), kWall));
  const TileNumber wall = level.map.tile_at({0, 0});
  EXPECT_EQ(level.palette[level.sheet(SheetId::tiles).images[wall][0]], (Rgb{255, 128, 0}));
  EXPECT_EQ(level.background, (Rgba{kBack.r, kBack.g, kBack.b, 255}));
  EXPECT_EQ(level.palette[0], default_palette()[0]);
  EXPECT_EQ(level.map.at({1, 0}), 0);
}

TEST(ImportLdtk, EachGridIsALayerOfTheGround) {
  const std::string layers = ldtk_grid(3, 1, "0,2,0") + "," + ldtk_grid(3, 1, "1,1,0");
  const std::string values = std::string(kWall) + R"(,{"value":2,"identifier":"slope up"})";
  const Level level = level_of(ldtk_project(ldtk_level(layers), values));
  ASSERT_EQ(level.layers.count(), 2);
  EXPECT_EQ(level.layers.chosen, 0) << "the lower layer has more values";
  EXPECT_TRUE(level.layers.list[0].is_ground);
  EXPECT_TRUE(level.layers.list[1].is_ground);
  EXPECT_TRUE(is_solid_at(level, 0));
  EXPECT_THAT(shape_of_tile(level, level.cells_of(1).tiles()[1]).heights, ElementsAre(0, 8));
}

TEST(ImportLdtk, ValuesOfAnotherGridAreLeftOut) {
  const std::string layers =
      ldtk_layer("IntGrid", "Small", 2, 1, R"("intGridCsv":[1,0])", 4) + "," + ldtk_grid(3, 1, "1,1,0");
  const LoadedLevel loaded = loaded_of(ldtk_project(ldtk_level(layers), kWall));
  EXPECT_EQ(loaded.level.map.width(), 3);
  EXPECT_THAT(loaded.dropped, Contains("the values of the layer \"Small\", which has another grid"));
  const LoadedLevel chosen = loaded_of(ldtk_project(ldtk_level(layers), kWall), {.layer = "Small"});
  EXPECT_EQ(chosen.level.map.tile_size(), (TileSize{4, 4}));
  EXPECT_EQ(error_of(ldtk_project(ldtk_level(layers), kWall), {.layer = "Big"}),
            "file: error: has no IntGrid with the name \"Big\", but \"Small\", \"Grid\"");
}

TEST(ImportLdtk, AGridNamedForTheGroundGoesBeforeALargerOne) {
  const std::string large = ldtk_layer("IntGrid", "Terrain", 2, 2, R"("intGridCsv":[1,1,1,1])", 16);
  const auto side_with = [&](const std::string& name, const std::string& values) {
    const std::string small = ldtk_layer("IntGrid", name, 4, 2, R"("intGridCsv":[)" + values + "]", 8);
    return loaded_of(ldtk_project(ldtk_level(large + "," + small), kWall)).level.map.tile_size().width;
  };
  EXPECT_EQ(side_with("Collisions", "1,0,0,0,0,0,0,0"), 8);
  EXPECT_EQ(side_with("Collisions", "0,0,0,0,0,0,0,0"), 16);  // it has no values in this level
  EXPECT_EQ(side_with("Rooms", "1,0,0,0,0,0,0,0"), 16);
  EXPECT_EQ(side_with("Background", "1,1,1,1,1,1,1,1"), 16);
}

TEST(ImportLdtk, EntitiesNamedLikeAKindBecomeBodies) {
  const std::string entities =
      R"({"__identifier":"PlayerStart","px":[20,40],"width":10,"height":20,"__pivot":[0.5,1],)"
      R"("fieldInstances":[{"__identifier":"name","__value":"Ada"},{"__identifier":"vx","__value":2}]},)"
      R"({"__identifier":"Ball","px":[8,0],"width":8,"height":8},)"
      R"({"__identifier":"crate_2","px":[16,0],"width":9,"height":8},)"
      R"({"__identifier":"Chest","px":[0,0]},{"__identifier":"Chest","px":[8,8]})";
  const std::string layers =
      ldtk_layer("Entities", "E", 4, 2, R"("__pxTotalOffsetX":1,"entityInstances":[)" + entities + "]") +
      "," + ldtk_grid(2, 1, "1,0");
  const LoadedLevel loaded = loaded_of(ldtk_project(ldtk_level(layers), kWall));
  ASSERT_EQ(loaded.level.spawns.size(), 3u);
  const Spawn& player = loaded.level.spawns[0];
  EXPECT_EQ(player.kind, BodyKind::player);
  EXPECT_EQ(player.name, "Ada");
  EXPECT_EQ(player.position, (Vec2{16, 20}));
  EXPECT_EQ(player.size, (Vec2{10, 20}));
  EXPECT_EQ(player.velocity, (Vec2{2, 0}));
  EXPECT_EQ(loaded.level.spawns[1].kind, BodyKind::ball);
  EXPECT_EQ(loaded.level.spawns[1].position, (Vec2{9, 0}));
  EXPECT_EQ(loaded.level.spawns[2].kind, BodyKind::crate);
  ASSERT_EQ(loaded.level.objects.size(), 1u) << "what is no body is an object";
  EXPECT_EQ(loaded.level.objects[0].objects.size(), 2u);
  EXPECT_THAT(loaded.dropped, IsEmpty());
}

TEST(ImportLdtk, OtherEntitiesAreObjects) {
  const auto layer = [](const std::string& name, const std::string& entities, const std::string& members) {
    return ldtk_layer("Entities", name, 4, 2, members + R"("entityInstances":[)" + entities + "]");
  };
  const std::string chest =
      R"({"__identifier":"Chest","px":[20,16],"width":8,"height":6,"__pivot":[0.5,1],"fieldInstances":[
          {"__identifier":"name","__value":"old"},{"__identifier":"gold","__value":[1,2]},
          {"__identifier":"key","__value":null}]})";
  const std::string far = R"({"__identifier":"Far","px":[40000000,0]})";
  const Level level =
      level_of(ldtk_project(ldtk_level(layer("Things", chest, R"("__opacity":0.5,"__pxTotalOffsetX":1,)") +
                                       "," + ldtk_grid(2, 1, "1,0") + "," + layer("Back", chest, "")),
                            kWall));
  ASSERT_EQ(level.objects.size(), 2u);
  EXPECT_EQ(level.objects[0].name, "Back");
  EXPECT_EQ(level.objects[0].place, 0);
  EXPECT_EQ(level.objects[1].place, 1);
  EXPECT_EQ(level.objects[1].opacity, 0.5);
  EXPECT_FALSE(level.objects[1].is_ground);
  const MapObject& object = level.objects[1].objects.at(0);
  EXPECT_EQ(object, (MapObject{.name = "old",
                               .type = "Chest",
                               .position = {17, 10},
                               .size = {8, 6},
                               .properties = R"({"gold":[1,2]})"}));
  const LoadedLevel without =
      loaded_of(ldtk_project(ldtk_level(layer("E", far, "") + "," + ldtk_grid(2, 1, "1,0")), kWall));
  EXPECT_TRUE(without.level.objects.empty());
  EXPECT_THAT(without.dropped, ElementsAre("an entity \"Far\""));
}

TEST(ImportLdtk, PlacesAreThoseOnTheGroundsGrid) {
  const std::string entity = R"({"__identifier":"Player","px":[20,40],"width":8,"height":8})";
  const std::string layers =
      ldtk_layer("Entities", "E", 4, 2, R"("entityInstances":[)" + entity + "]") + "," +
      ldtk_grid(2, 1, "1,0", R"("__tilesetDefUid":1,"__pxTotalOffsetX":4,"__pxTotalOffsetY":-8)");
  EXPECT_EQ(level_of(ldtk_project(ldtk_level(layers), kWall)).spawns.at(0).position, (Vec2{16, 48}));
}

// With a picture t.png of three tiles: red, green, and blue on the left half and clear on the right.
class ImportLdtkPictures : public FolderTest {
 protected:
  ImportLdtkPictures() {
    const auto of = [](Rgb color, int opacity) {
      return std::string{static_cast<char>(color.r), static_cast<char>(color.g), static_cast<char>(color.b),
                         static_cast<char>(opacity)};
    };
    std::string row;
    for (int x = 0; x < 24; ++x)
      row += x < 8 ? of(kRed, 255) : x < 16 ? of(kGreen, 255) : of(kBlue, x < 20 ? 255 : 0);
    put("t.png", png_of(24, 6, std::vector<std::string>(8, row)));
  }
  LoadedLevel load(const std::string& text, const ImportChoices& choices = {}) const {
    auto loaded = load_level(put("p.ldtk", text), choices);
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "p.ldtk");
    return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
  }
  std::string error(const std::string& text, const ImportChoices& choices = {}) const {
    const auto loaded = load_level(put("p.ldtk", text), choices);
    return loaded ? "" : to_string(loaded.error(), "p.ldtk");
  }
  // The colour of a pixel in the highest layer that is not clear there.
  static Rgb color(const Level& level, int x, int y = 0) {
    const auto& images = level.sheet(SheetId::tiles).images;
    const auto cell = static_cast<std::size_t>(y / 8 * level.map.width() + x / 8);
    for (int layer = level.layers.count() - 1; layer >= 0; --layer) {
      const auto [tile, turn] = level.cells_of(layer)[cell];
      const Cell from = pixel_before_turn({x % 8, y % 8}, turn, {8, 8});
      const std::uint8_t color = images[tile][static_cast<std::size_t>(8 * from.y + from.x)];
      if (color != 0 && level.layers.list[static_cast<std::size_t>(layer)].visible)
        return level.palette[color];
    }
    const Rgba back = background_of(level);
    return {back.r, back.g, back.b};
  }
};

TEST_F(ImportLdtkPictures, TilesOfOneLayerBecomeOnePicture) {
  const std::string layers =
      ldtk_tiles(3, 1, ldtk_tile(0, 0, 2)) + "," +
      ldtk_tiles(3, 1, ldtk_tile(0, 0, 1) + "," + ldtk_tile(8, 0, 1) + "," + ldtk_tile(8, 0, 0)) + "," +
      ldtk_grid(3, 1, "1,1,1");
  const LoadedLevel loaded = load(ldtk_project(ldtk_level(layers), kWall));
  EXPECT_EQ(color(loaded.level, 3), kBlue);
  EXPECT_EQ(color(loaded.level, 4), kGreen) << "the upper tile is clear there";
  EXPECT_EQ(color(loaded.level, 8), kRed) << "the last tile is the upper one";
  EXPECT_EQ(color(loaded.level, 16), kBack);
  EXPECT_TRUE(is_solid_at(loaded.level, 2));
  ASSERT_EQ(loaded.level.layers.count(), 3);
  EXPECT_EQ(loaded.level.layers.chosen, 0);
  EXPECT_EQ(loaded.level.layers.list[2].name, "Tiles");
  EXPECT_FALSE(loaded.level.layers.list[2].is_ground);
  EXPECT_THAT(loaded.dropped, IsEmpty());
  EXPECT_THAT(loaded.linked, ElementsAre(path("t.png")));
}

// An IntGrid with tiles.
std::string grid_with_tiles(int columns, const std::string& values, const std::string& tiles) {
  return ldtk_grid(columns, 1, values, R"("__tilesetDefUid":1,"autoLayerTiles":[)" + tiles + "]");
}

TEST_F(ImportLdtkPictures, CellsThatLookTheSameAreOneTile) {
  const std::string tiles =
      ldtk_tile(0, 0, 1) + "," + ldtk_tile(0, 0, 0) + "," + ldtk_tile(8, 0, 0) + "," + ldtk_tile(16, 0, 0);
  const Level level = load(ldtk_project(ldtk_level(grid_with_tiles(4, "0,0,1,0", tiles)), kWall)).level;
  EXPECT_EQ(level.layers.count(), 1);
  EXPECT_EQ(level.map.tile_at({0, 0}), level.map.tile_at({1, 0})) << "what is hidden does not count";
  EXPECT_NE(level.map.tile_at({1, 0}), level.map.tile_at({2, 0})) << "its ground differs";
  EXPECT_EQ(level.map.at({3, 0}), 0);
}

TEST_F(ImportLdtkPictures, FlippedTilesAreMirrored) {
  const std::string layers = ldtk_tiles(2, 1, ldtk_tile(0, 0, 2, 1) + "," + ldtk_tile(8, 0, 2, 2));
  const Level level = load(ldtk_project(ldtk_level(layers))).level;
  EXPECT_EQ(color(level, 3), kBack);
  EXPECT_EQ(color(level, 4), kBlue);
  EXPECT_EQ(color(level, 8 + 3), kBlue);
}

TEST_F(ImportLdtkPictures, TilesOffTheGridReachIntoSeveralCells) {
  const std::string layers = ldtk_tiles(2, 2, ldtk_tile(5, 6, 0), R"(,"__pxTotalOffsetX":-1)");
  const Level level = load(ldtk_project(ldtk_level(layers + "," + ldtk_grid(2, 2, "0,0,0,0")))).level;
  EXPECT_EQ(color(level, 3, 6), kBack);
  EXPECT_EQ(color(level, 4, 6), kRed);
  EXPECT_EQ(color(level, 11, 13), kRed);
  EXPECT_EQ(color(level, 12, 13), kBack);
  EXPECT_EQ(color(level, 11, 14), kBack);
}

TEST_F(ImportLdtkPictures, OpacityOfTilesAndLayersIsInTheTrueColours) {
  const std::string layers = ldtk_tiles(1, 1, ldtk_tile(0, 0, 0, 0, "0.5"), R"(,"__opacity":0.5)");
  const Level level = load(ldtk_project(ldtk_level(layers))).level;
  const auto& picture = level.sheet(SheetId::tiles).picture;
  ASSERT_TRUE(picture);
  const Cell place = level.sheet(SheetId::tiles).layout().place_of(level.map.tile_at({0, 0}));
  const std::uint8_t* pixel = picture->at(8 * place.x, 8 * place.y);
  EXPECT_THAT(std::vector<int>(pixel, pixel + 4), ElementsAre(255, 0, 0, 64));
}

TEST_F(ImportLdtkPictures, HiddenLayersStayHidden) {
  const std::string layers = ldtk_tiles(2, 1, ldtk_tile(0, 0, 0), R"(,"visible":false)") + "," +
                             ldtk_grid(2, 1, "0,1", R"("visible":false,"__tilesetDefUid":null)");
  const LoadedLevel loaded = load(ldtk_project(ldtk_level(layers), kWall));
  ASSERT_EQ(loaded.level.layers.count(), 2);
  EXPECT_EQ(color(loaded.level, 0), kBack);
  EXPECT_FALSE(loaded.level.layers.list[0].visible);
  EXPECT_TRUE(is_solid_at(loaded.level, 1));
  EXPECT_THAT(loaded.dropped, IsEmpty());
}

TEST_F(ImportLdtkPictures, EmptyLayersAreLeftOut) {
  const std::string empty = ldtk_tiles(2, 1, "") + "," + ldtk_grid(2, 1, "0,0");
  const Level level = level_of(ldtk_project(ldtk_level(empty + "," + ldtk_grid(2, 1, "1,0")), kWall));
  EXPECT_EQ(level.layers.count(), 1);
  const Level nothing = level_of(ldtk_project(ldtk_level(ldtk_tiles(2, 1, ""))));
  ASSERT_EQ(nothing.layers.count(), 1);
  EXPECT_TRUE(nothing.layers.list[0].is_ground);
  EXPECT_EQ(nothing.map.width(), 2);
}

TEST_F(ImportLdtkPictures, MissingPicturesAreNumberedBoxes) {
  std::filesystem::remove(path("t.png"));
  const LoadedLevel loaded =
      load(ldtk_project(ldtk_level(ldtk_tiles(2, 1, ldtk_tile(0, 0, 0) + "," + ldtk_tile(8, 0, 1)))));
  EXPECT_THAT(
      loaded.dropped,
      ElementsAre(
          "the picture of the tileset \"Tiles\", file t.png: cannot be opened: No such file or directory"));
  EXPECT_NE(loaded.level.map.tile_at({0, 0}), loaded.level.map.tile_at({1, 0}));
  EXPECT_NE(color(loaded.level, 0), kBack);
}

TEST_F(ImportLdtkPictures, TagsOfTilesBecomeFlagsAndShapes) {
  const std::string tileset = ldtk_tileset(
      R"("enumTags":[{"enumValueId":"Grass","tileIds":[0]},{"enumValueId":"SlopeUp","tileIds":[1]},)"
      R"({"enumValueId":"Unused","tileIds":[2]}],"customData":[{"tileId":0,"data":"x"},)"
      R"({"tileId":1,"data":"{\"cost\": 3}"}])");
  const std::string tiles = ldtk_tile(0, 0, 0) + "," + ldtk_tile(8, 0, 1) + "," + ldtk_tile(16, 0, 1, 1) +
                            "," + ldtk_tile(24, 0, 1, 2);
  const LoadedLevel loaded =
      load(ldtk_project(ldtk_level(grid_with_tiles(4, "0,0,1,0", tiles)), kWall, tileset));
  EXPECT_EQ(loaded.level.flag_names[4], "Grass");
  EXPECT_EQ(loaded.level.flag_names[5], "");
  EXPECT_EQ(loaded.level.tile_flags(loaded.level.map.tile_at({0, 0})), 1 << 4);
  EXPECT_THAT(heights_at(loaded.level, 1), ElementsAre(0, 8));
  EXPECT_THAT(heights_at(loaded.level, 2), ElementsAre(8, 0)) << "mirrored, and more than a full value";
  EXPECT_EQ(shape_at(loaded.level, 3).side, TileShape::Side::ceiling);
  const auto properties_at = [&](int x) {
    return note_of(loaded.level.tile_notes, loaded.level.map.tile_at({x, 0})).properties;
  };
  EXPECT_EQ(properties_at(0), R"({"data":"x"})");
  EXPECT_EQ(properties_at(1), R"({"cost":3})");
  EXPECT_EQ(properties_at(2), R"({"cost":3})");
  EXPECT_THAT(loaded.dropped, testing::IsEmpty());
}

TEST_F(ImportLdtkPictures, NamesHave32FlagsAndTheOthersAreTold) {
  const auto load_tags = [&](int count) {
    std::string tags;
    for (int i = 10; i < 10 + count; ++i)
      tags += (i > 10 ? "," : "") + std::string(R"({"enumValueId":"tag)") + std::to_string(i) +
              R"(","tileIds":[0]})";
    const std::string tileset = ldtk_tileset(R"("enumTags":[)" + tags + "]");
    return load(ldtk_project(ldtk_level(ldtk_tiles(2, 1, ldtk_tile(0, 0, 0))), "", tileset));
  };
  const auto flags_of = [](const Level& level) { return level.tile_flags(level.map.tile_at({0, 0})); };
  const Level eight = load_tags(8).level;
  EXPECT_EQ(flags_of(eight), 0xff);
  EXPECT_EQ(eight.roles.solid, FlagRoles::kUnused);
  const LoadedLevel all = load_tags(32);
  EXPECT_EQ(flags_of(all.level), 0xffffffff);
  EXPECT_EQ(all.level.flag_names[31], "tag41");
  EXPECT_THAT(all.dropped, IsEmpty());
  EXPECT_THAT(load_tags(33).dropped,
              ElementsAre("the name \"tag42\" of a value or tag of tiles, as tiles have only 32 flags"));
}

TEST_F(ImportLdtkPictures, MayBeOfAseprite) {
  std::filesystem::remove(path("t.png"));
  const auto number = [](std::size_t value, int size) {
    std::string bytes;
    for (int i = 0; i < size; ++i) bytes += static_cast<char>(value >> (8 * i) & 255);
    return bytes;
  };
  const std::string layer = number(24, 4) + number(0x2004, 2) + number(1, 2) + std::string(16, '\0');
  const std::string pixels("\xff\0\0\xff\0\0\xff\xff", 8);
  const std::string cel = number(26 + pixels.size(), 4) + number(0x2005, 2) + std::string(6, '\0') +
                          number(255, 1) + std::string(9, '\0') + number(2, 2) + number(1, 2) + pixels;
  std::string file =
      number(0, 4) + number(0xa5e0, 2) + number(1, 2) + number(2, 2) + number(1, 2) + number(32, 2);
  file.resize(128);
  put("t.png", file + number(16 + layer.size() + cel.size(), 4) + number(0xf1fa, 2) + std::string(10, '\0') +
                   layer + cel);
  const LoadedLevel loaded = load(ldtk_project(ldtk_level(ldtk_tiles(1, 1, ldtk_tile(0, 0, 0)))));
  EXPECT_THAT(loaded.dropped, IsEmpty());
  EXPECT_EQ(color(loaded.level, 0), kRed);
  EXPECT_EQ(color(loaded.level, 1), kBlue);
}

TEST_F(ImportLdtkPictures, GroundAndBodiesOfAnExportAreTheSame) {
  Level level;
  level.map = TileMap(6, 3);
  level.map.cells().tiles() = {0, 0, 0, 0, 0, 4,  //
                               0, 2, 3, 5, 0, 0,  //
                               1, 1, 1, 1, 1, 1};
  level.tile_shapes[1] = {.kind = TileShape::Kind::solid};
  level.tile_shapes[2] = {.kind = TileShape::Kind::slope, .tiles = 2, .heights = {0, 7.5}};
  level.tile_shapes[4] = {
      .kind = TileShape::Kind::slope, .side = TileShape::Side::ceiling, .heights = {8, 1}};
  level.tile_shapes[5] = {.kind = TileShape::Kind::solid, .one_way = true};
  Spawn player;
  player.name = "Ada";
  player.kind = BodyKind::player;
  player.position = {8, 2};
  player.size = {6, 12};
  level.spawns.push_back(player);
  const ReadAsset no_asset = [](const std::string& name) { return read_file(source_path("assets/") + name); };
  const Exporter& exporter = *find_exporter("ldtk");
  ASSERT_TRUE(
      write_exported(exporter, exporter.write({level, "out.ldtk", no_asset}).value(), path("out.ldtk")));
  const auto again = load_level(path("out.ldtk"));
  ASSERT_TRUE(again) << to_string(again.error(), "out.ldtk");
  for (std::size_t i = 0; i < level.map.cells().size(); ++i) {
    EXPECT_EQ(shape_of_tile(again->level, again->level.map.cells().tiles()[i]),
              shape_of_tile(level, level.map.cells().tiles()[i]))
        << "cell " << i;
  }
  ASSERT_EQ(again->level.spawns.size(), 1u);
  EXPECT_EQ(again->level.spawns[0].name, "Ada");
  EXPECT_EQ(again->level.spawns[0].position, player.position);
  EXPECT_EQ(again->level.spawns[0].size, player.size);
}

TEST_F(ImportLdtkPictures, LevelsMayBeInFilesOfTheirOwn) {
  const std::string head =
      R"({"identifier":"Cave","pxWid":16,"pxHei":8,"layerInstances":null,"externalRelPath":"l\\Cave.ldtkl"})";
  std::filesystem::create_directory(path("l"));
  put("l/Cave.ldtkl", ldtk_level(ldtk_grid(2, 1, "0,1")));
  const LoadedLevel loaded = load(ldtk_project(head, kWall));
  EXPECT_TRUE(is_solid_at(loaded.level, 1));
  EXPECT_THAT(loaded.linked, Contains(path("l/Cave.ldtkl")));
  put("l/Cave.ldtkl", ldtk_level(ldtk_grid(2, 1, "0")));
  EXPECT_EQ(error(ldtk_project(head, kWall)),
            "p.ldtk:file l/Cave.ldtkl, key layerInstances[0].intGridCsv: error: has 1 values, but its layer "
            "has 2 cells");
  std::filesystem::remove(path("l/Cave.ldtkl"));
  EXPECT_EQ(error(ldtk_project(head, kWall)),
            "p.ldtk:file l/Cave.ldtkl: error: cannot be opened: No such file or directory");
  const std::string outside = std::regex_replace(head, std::regex(R"(l\\\\Cave.ldtkl)"), "/etc/passwd");
  EXPECT_EQ(error(ldtk_project(outside, kWall)),
            "p.ldtk:file /etc/passwd: error: must be relative to the folder of the map");
  EXPECT_EQ(error_of(ldtk_project(head, kWall)),
            "file:file l/Cave.ldtkl: error: is a level in a file beside the project, but the project has no "
            "file");
}

TEST(ImportLdtkLevels, OneOfSeveralMustBeChosen) {
  const std::string project = ldtk_project(
      ldtk_level(ldtk_grid(1, 1, "1"), "Cave") + "," + ldtk_level(ldtk_grid(2, 1, "1,0"), "Top"), kWall);
  EXPECT_EQ(error_of(project),
            "file: error: has the levels \"Cave\", \"Top\", but a level is one of them: choose one by "
            "`--level NAME`");
  EXPECT_EQ(loaded_of(project, {.level = "Top"}).level.map.width(), 2);
  EXPECT_EQ(loaded_of(project, {.level = "2"}).level.map.width(), 2);
  EXPECT_EQ(loaded_of(project, {.level_number = 1}).level.map.width(), 1);
  EXPECT_EQ(error_of(project, {.level = "3"}),
            "file: error: has no level with the name \"3\", but \"Cave\", \"Top\"");
}

TEST(ImportLdtkLevels, OfWorldsHaveTheirNames) {
  const auto world = [](const std::string& name, const std::string& levels) {
    return R"({"identifier":")" + name + R"(","levels":[)" + levels + "]}";
  };
  const std::string worlds =
      world("A", ldtk_level(ldtk_grid(1, 1, "1"))) + "," + world("B", ldtk_level(ldtk_grid(2, 1, "1,0")));
  const std::string project = ldtk_project("", kWall, ldtk_tileset(), worlds);
  EXPECT_EQ(loaded_of(project, {.level = "B/Cave"}).level.map.width(), 2);
  EXPECT_EQ(error_of(project),
            "file: error: has the levels \"A/Cave\", \"B/Cave\", but a level is one of them: choose one by "
            "`--level NAME`");
}

TEST(ImportLdtkErrors, NameThePlace) {
  const auto grid = [](const std::string& members) {
    return ldtk_project(ldtk_level(ldtk_layer("IntGrid", "G", 1, 1, R"("intGridCsv":[1],)" + members)),
                        kWall);
  };
  const std::string layer = "file:key levels[0].layerInstances[0]";
  EXPECT_EQ(error_of("{}"), "file: error: is not a project of LDtk");
  EXPECT_EQ(error_of(ldtk_level("")),
            "file: error: is a level of a project of LDtk: open the project, whose name ends in .ldtk");
  EXPECT_EQ(error_of(ldtk_project("")), "file:key levels: error: has no level");
  EXPECT_EQ(error_of(ldtk_project(ldtk_level(ldtk_layer("Grid", "G", 1, 1, R"("x":1)")))),
            layer + ".__type: error: must be IntGrid, Entities, Tiles or AutoLayer");
  EXPECT_EQ(error_of(grid(R"("autoLayerTiles":[{"px":[1],"src":[0,0]}])")),
            layer + ".autoLayerTiles[0].px: error: must have a list of two numbers as px");
  EXPECT_EQ(error_of(grid(R"("autoLayerTiles":[{"px":[1,1e9],"src":[0,0]}])")),
            layer + ".autoLayerTiles[0].px: error: must have two numbers of at most 67108864 px as px");
  EXPECT_EQ(error_of(grid(R"("gridTiles":7)")), layer + ".gridTiles: error: must have a list as gridTiles");
  EXPECT_EQ(error_of(grid(R"("gridTiles":[{"px":[0,0],"src":[0,0],"f":4}])")),
            layer + ".gridTiles[0].f: error: must have a whole number from 0 to 3 as f");
  EXPECT_EQ(error_of(ldtk_project(ldtk_level(ldtk_grid(1, 1, "-1")))),
            layer + ".intGridCsv: error: must have a whole number as value 1");
  EXPECT_EQ(error_of(ldtk_project(ldtk_level(ldtk_layer("Tiles", "T", 1, 1, R"("gridTiles":[])", 257)))),
            "file: error: has a grid of 257 px, but a level needs one of 1 to 256");
}

}  // namespace talus::import_ldtk_test
