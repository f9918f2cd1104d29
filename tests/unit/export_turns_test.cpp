// Exports of levels with turned tiles: those that hold turns have them, and others have tiles of their own.
#include <gmock/gmock.h>

#include <talus/level/ground.h>
#include "export/exporter.h"
#include "export/flat_level.h"
#include "formats/files/atomic_file.h"
#include "formats/tic80/tic_cart.h"
#include "level/ground_level.h"
#include "paths.h"

namespace talus::export_turns_test {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr TileNumber kRamp = 2, kPicture = 3;

// 3x1 cells: a ramp, the same mirrored, and a picture without ground that is turned right. Colour 5 is in the
// left column of the picture alone.
Level turned_level() {
  Level level;
  level.tuning.solver = SolverKind::exact;
  level.map = TileMap(3, 1);
  level.tile_shapes[kRamp] = {.kind = TileShape::Kind::slope, .heights = {0, 8}};
  level.sheet(SheetId::tiles).images[kRamp].fill(2);
  for (std::size_t y = 0; y < 8; ++y) level.sheet(SheetId::tiles).images[kPicture][8 * y] = 5;
  level.map.set({0, 0}, kRamp);
  level.map.set({1, 0}, {kRamp, TileTurn::left_right});
  level.map.set({2, 0}, {kPicture, kTurnRight});
  return level;
}

Exported exported(const Level& level, std::string_view id) {
  const ReadAsset read = [](const std::string& name) { return read_file(source_path("assets/") + name); };
  auto made = find_exporter(id)->make({level, "game", read});
  EXPECT_TRUE(made) << id << ": " << (made ? "" : made.error().message);
  return made.value_or(Exported());
}

std::string text_of(const Exported& exported, const std::string& name) {
  for (const ExportedFile& file : exported.files)
    if (file.name == name) return file.bytes;
  ADD_FAILURE() << "no file " << name;
  return "";
}

TEST(ExportTurns, GamesCollideWithTurnedShapesAndDrawTurns) {
  for (const char* id : {"love", "lua-runtime", "bump"}) {
    const Exported game = exported(turned_level(), id);
    const std::string level = text_of(game, "level.lua");
    EXPECT_THAT(level, HasSubstr("tiles = {\n    2,256,3,\n  }")) << id;
    EXPECT_THAT(level, HasSubstr("[256] = {kind = \"slope\"")) << id;
    EXPECT_THAT(level, HasSubstr("turns = {\n        0,4,5,\n      }")) << id;
    EXPECT_TRUE(game.dropped.empty()) << id;
  }
}

TEST(ExportTurns, MapsOfTiledHaveTheBits) {
  EXPECT_THAT(exported(turned_level(), "tmx").files[0].bytes, HasSubstr("\n3,2147483651,2684354564\n"));
  EXPECT_THAT(exported(turned_level(), "sti").files[0].bytes, HasSubstr("2684354564"));
  const std::string text = exported(turned_level(), "tmj").files[0].bytes;
  const auto again = read_level(text, {"tmj"});
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->level.map, turned_level().map);
}

TEST(ExportTurns, OthersGetTilesOfTheirOwn) {
  const auto flat = flat_level(turned_level());
  ASSERT_TRUE(flat);
  EXPECT_THAT(flat->level.map.cells().tiles(), ElementsAre(kRamp, 256, 257));
  EXPECT_FALSE(flat->level.map.cells().has_turned());
  EXPECT_EQ(flat->level.tile_shapes[256], (TileShape{.kind = TileShape::Kind::slope, .heights = {8, 0}}));
  const TileImage& image = flat->level.sheet(SheetId::tiles).images[257];
  EXPECT_THAT(std::vector<int>(image.begin(), image.begin() + 8), testing::Each(5)) << "its left is above";
  EXPECT_EQ(image[8], 0);
  EXPECT_THAT(flat->dropped,
              ElementsAre("that cells turn their tiles: 2 turned tiles are tiles of their own"));
  for (const char* id : {"ldtk", "csv", "c", "svg"})
    EXPECT_FALSE(exported(turned_level(), id).dropped.empty()) << id;
  for (const char* id : {"lua", "json"})
    EXPECT_THAT(exported(turned_level(), id).dropped, testing::IsEmpty()) << id << " has the turns, too";
}

TEST(ExportTurns, CartsHaveThemInPlacesOfBlankTiles) {
  const Exported cart = exported(turned_level(), "tic");
  EXPECT_THAT(cart.dropped, testing::Contains(HasSubstr("2 turned tiles are tiles of their own")));
  const auto loaded = read_level(cart.files[0].bytes, {"tic"});
  ASSERT_TRUE(loaded);
  EXPECT_THAT(
      std::vector(loaded->level.map.cells().tiles().begin(), loaded->level.map.cells().tiles().begin() + 3),
      ElementsAre(kRamp, 1, 4));
  EXPECT_EQ(loaded->level.sheet(SheetId::tiles).images[4][7], 5);
  EXPECT_FALSE(exported(turned_level(), "tic-playable").files.empty());
}

TEST(ExportTurns, GroundThatNoFormatHasIsLeftOut) {
  Level level = turned_level();
  level.roles.one_way = 4;
  level.sheet(SheetId::tiles).flags[kPicture] = 1 | 1 << 4;  // a one-way plank, turned to the side
  const auto flat = flat_level(level);
  ASSERT_TRUE(flat);
  EXPECT_EQ(shape_of_tile(flat->level, 257).kind, TileShape::Kind::none);
}

}  // namespace talus::export_turns_test
