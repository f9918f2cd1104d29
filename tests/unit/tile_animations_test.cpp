// Animations of tiles: what they show, and the files that have them.
#include <gmock/gmock.h>

#include <talus/level/tile_animation.h>

#include "edit/tile_animation_tools.h"
#include "level/tile_renumber.h"
#include "native_text.h"
#include "tiled_files.h"

namespace talus::tile_animations_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

Level animated_level() {
  Level level;
  level.map = TileMap(2, 2);
  level.map.cells().tiles() = {0, 20, 1, 1};
  level.animations[20] = {{20, 100}, {21, 50}, {20, 200}};
  return level;
}

// Of tiles 1 to 16 in four columns; tile 6 shows 6 and 7. cells: of two.
std::string tmx(
    const std::string& cells,
    const std::string& frames = R"(<frame tileid="5" duration="120"/><frame tileid="6" duration="80"/>)") {
  return R"(<map version="1.10" orientation="orthogonal" width="2" height="1" tilewidth="8" tileheight="8">
<tileset firstgid="1" name="t" tilewidth="8" tileheight="8" tilecount="16" columns="4">
<tile id="5"><animation>)" +
         frames + R"(</animation></tile></tileset>
<layer id="1" name="ground" width="2" height="1"><data encoding="csv">)" +
         cells + "</data></layer></map>";
}

LoadedLevel read_map(const std::string& text, FormatContext context) {
  auto loaded = read_level(text, context);
  EXPECT_TRUE(loaded) << to_string(loaded.error(), "map");
  return loaded ? *loaded : LoadedLevel{Level(), nullptr};
}

TEST(TileAnimations, ShowOneFrameAfterAnother) {
  const TileAnimation animation = {{20, 100}, {21, 50}};
  for (const auto& [time, tile] : {std::pair{-5.0, 20},
                                   {0.0, 20},
                                   {99.9, 20},
                                   {100.0, 21},
                                   {149.0, 21},
                                   {150.0, 20},
                                   {1e9 * 150 + 120, 21}})
    EXPECT_EQ(tile_shown_at(animation, time), tile) << time;
}

TEST(TileAnimations, AreStoredInANativeLevel) {
  const Level level = animated_level();
  const std::string text = native_of_level(level);
  EXPECT_THAT(text, HasSubstr("\"20\": [\n      [20, 100],\n      [21, 50],\n      [20, 200]\n    ]"));
  EXPECT_THAT(text, HasSubstr(R"("talus": 1,)")) << "older versions keep it as what they do not know";
  EXPECT_EQ(read_map(text, {"json"}).level, level);
}

TEST(TileAnimations, AreEditedFrameByFrame) {
  Level level;
  const auto change = [&](const Edit& edit) { apply_edit(level, edit); };
  const Edit first = add_frames(level, 7, {7});
  change(first);
  EXPECT_EQ(level.animations.at(7), (TileAnimation{{7, 100}}));
  change(change_frame(level, 7, 0, {7, 0}));
  EXPECT_EQ(level.animations.at(7), (TileAnimation{{7, 1}})) << "within its range";
  change(change_frame(level, 7, 0, {7, 250}));
  change(add_frames(level, 7, {8, 9, 300}));
  EXPECT_EQ(level.animations.at(7), (TileAnimation{{7, 250}, {8, 250}, {9, 250}})) << "there is no tile 300";
  const Edit move = move_frame(level, 7, 2, 0);
  change(move);
  EXPECT_EQ(level.animations.at(7), (TileAnimation{{9, 250}, {7, 250}, {8, 250}}));
  revert_edit(level, move);
  change(remove_frame(level, 7, 1));
  EXPECT_EQ(level.animations.at(7), (TileAnimation{{7, 250}, {9, 250}}));
  EXPECT_TRUE(change_frame(level, 7, 2, {7, 1}).empty());
  EXPECT_TRUE(change_frame(level, 7, 0, {300, 1}).empty());
  EXPECT_TRUE(move_frame(level, 7, 0, 2).empty());
  EXPECT_TRUE(add_frames(level, 300, {1}).empty());
  change(remove_animation(level, 7));
  EXPECT_TRUE(level.animations.empty());
  const std::vector<TileNumber> too_many(kMaxAnimationFrames + 1, 1);
  EXPECT_TRUE(problem_after(level, add_frames(level, 7, too_many)));
}

TEST(TileAnimations, BadOnesAreRefusedWithTheirPlace) {
  const auto error_of = [](const std::string& animations) {
    const auto loaded = read_level(R"({"talus": 1, "animations": )" + animations + "}", {"json"});
    return loaded ? "" : to_string(loaded.error(), "a");
  };
  EXPECT_EQ(error_of("[]"), "a:key animations: error: must be an object");
  EXPECT_EQ(error_of(R"({"01": [[1, 9]]})"),
            "a:key animations: error: has the key \"01\", which is no number of a tile");
  EXPECT_EQ(error_of(R"({"1": []})"), "a:key animations.1: error: must have frames");
  EXPECT_EQ(error_of(R"({"1": [[1, 0]]})"),
            "a:key animations.1[0]: error: must be a frame [tile, ms] of 1 to 60000 ms");
  EXPECT_EQ(
      error_of(R"({"1": [[256, 1]]})"),
      "a:key animations: error: has one that cannot be: of tile 1 has a frame with tile 256, but the last "
      "tile is 255");
  EXPECT_EQ(
      error_of(R"({"256": [[1, 1]]})"),
      "a:key animations: error: has one that cannot be: of tile 256 is none of the level's, whose last tile "
      "is 255");
}

TEST(TileAnimations, ComeFromMapsOfTiled) {
  const LoadedLevel loaded = read_map(tmx("6,1"), {"tmx"});
  ASSERT_THAT(loaded.level.map.cells().tiles(), ElementsAre(17, 0));
  EXPECT_THAT(loaded.level.animations, ElementsAre(Pair(17, (TileAnimation{{17, 120}, {18, 80}}))));
  EXPECT_THAT(loaded.dropped, testing::Not(testing::Contains(HasSubstr("animation"))));
}

TEST(TileAnimations, BringTheirTilesEvenIfOnlyUsedOnesAreTaken) {
  FormatContext used{"tmx"};
  used.choices.used_tiles = true;
  const LoadedLevel loaded = read_map(tmx("6,0"), used);
  ASSERT_THAT(loaded.level.map.cells().tiles(), ElementsAre(1, 0));
  EXPECT_THAT(loaded.level.animations, ElementsAre(Pair(1, (TileAnimation{{1, 120}, {2, 80}}))));
}

TEST(TileAnimations, OfWhichATileIsMissingAreReported) {
  const LoadedLevel loaded = read_map(tmx("6,1", R"(<frame tileid="16" duration="5"/>)"), {"tmx"});
  EXPECT_TRUE(loaded.level.animations.empty());
  EXPECT_THAT(loaded.dropped, testing::Contains("the animation of a tile with a frame that the level lacks"));
  EXPECT_EQ(read_map(tmx("6,1", R"(<frame tileid="6" duration="0"/>)"), {"tmx"}).level.animations.at(17),
            (TileAnimation{{18, 1}}));
}

TEST(TileAnimations, AreExportedToTiled) {
  const Level level = animated_level();
  EXPECT_THAT(tiled_export_of(level, "tmx", "a.tmx").files[0].bytes,
              HasSubstr(R"(<frame tileid="21" duration="50" />)"));
  for (const std::string format : {"tmx", "tmj"}) {
    const std::string text = tiled_export_of(level, format, "a." + format).files[0].bytes;
    EXPECT_EQ(read_map(text, {format}).level.animations, level.animations) << format;
  }
  EXPECT_THAT(tiled_export_of(level, "sti", "a.lua").files[0].bytes,
              HasSubstr("{tileid = 21, duration = 50}"));
}

TEST(TileAnimations, FollowTheNumbersOfTheirTiles) {
  Level level = animated_level();
  std::vector<int> numbers(256);
  for (int tile = 0; tile < 256; ++tile) numbers[static_cast<std::size_t>(tile)] = 255 - tile;
  renumber_tiles(level, level.sheet(SheetId::tiles).layout(), numbers);
  EXPECT_THAT(level.animations, ElementsAre(Pair(235, (TileAnimation{{235, 100}, {234, 50}, {235, 200}}))));
  level = animated_level();
  level.map.cells().tiles() = {0, 0, 0, 0};
  level.set_tile_layout({16, 21});
  EXPECT_TRUE(level.animations.empty()) << "tile 21 went";
}

}  // namespace talus::tile_animations_test
