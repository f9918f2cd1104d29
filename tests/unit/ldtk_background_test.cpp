// What LDtk draws behind a level, and the parallax of its layers.
#include <gmock/gmock.h>

#include <talus/formats/format.h>
#include "export/map_paint.h"
#include "folder_test.h"
#include "ldtk_text.h"
#include "level/tile_color.h"
#include "png_bytes.h"

namespace talus::ldtk_background_test {

using testing::ElementsAre;
using testing::IsEmpty;

const Rgb kLeft = {200, 0, 0}, kRight = {0, 0, 200}, kBehind = {0x10, 0x20, 0x30};

// With a picture bg.png of 4x2 px, whose left half has another colour than its right one.
class LdtkBackground : public FolderTest {
 protected:
  LdtkBackground() { put_picture(kLeft); }
  void put_picture(Rgb left) const {
    put("bg.png", rgb_png(4, {left, left, kRight, kRight, left, left, kRight, kRight}));
  }
  static std::string project(const std::string& place, const std::string& mode = "Unscaled") {
    std::string members = R"("iid":"c",)";
    if (!place.empty())
      members += R"("bgRelPath":"bg.png","bgPos":")" + mode + R"(","__bgPos":)" + place + ",";
    std::string text = ldtk_project(ldtk_level(ldtk_grid(4, 2, "0,0,0,0,0,0,0,0"), "Cave", members),
                                    R"({"value":1,"identifier":"wall"})");
    return text.insert(1, R"("iid":"p",)");
  }
  static std::string at(const std::string& corner, const std::string& scale, const std::string& part) {
    return R"({"topLeftPx":)" + corner + R"(,"scale":)" + scale + R"(,"cropRect":)" + part + "}";
  }
  LoadedLevel load(const std::string& text) const {
    auto loaded = load_level(put("p.ldtk", text));
    EXPECT_TRUE(loaded) << to_string(loaded.error(), "p.ldtk");
    return loaded ? *std::move(loaded) : LoadedLevel{Level(), nullptr};
  }
  // That of the level where no layer shows anything.
  static Rgb color(const Level& level, int x, int y) {
    auto pixels = map_pixels(level, 0, static_cast<int>(level.map.px_height()), [](double) { return true; });
    const auto i = static_cast<std::size_t>(4 * (y * 32 + x));
    if (pixels[i + 3] == 0) lay_over(&pixels[i], background_of(level));
    return {pixels[i], pixels[i + 1], pixels[i + 2]};
  }
};

TEST_F(LdtkBackground, IsALayerOfAPictureWhereLdtkPutsIt) {
  const LoadedLevel loaded = load(project(at("[14,7]", "[1,1]", "[0,0,4,2]")));
  ASSERT_EQ(loaded.level.objects.size(), 1u);
  const ObjectLayer& layer = loaded.level.objects[0];
  EXPECT_EQ(layer.name, "background");
  EXPECT_EQ(layer.place, 0);
  ASSERT_TRUE(layer.image);
  EXPECT_EQ(layer.image->path, "bg.png");
  EXPECT_EQ(layer.offset, (Vec2{14, 7}));
  EXPECT_EQ(color(loaded.level, 14, 7), kLeft);
  EXPECT_EQ(color(loaded.level, 17, 8), kRight);
  EXPECT_EQ(color(loaded.level, 13, 7), kBehind) << "the level's own colour";
  EXPECT_THAT(loaded.dropped, IsEmpty());
  EXPECT_THAT(loaded.linked, ElementsAre(path("bg.png")));
}

TEST_F(LdtkBackground, IsScaledAndCropped) {
  const Level level = load(project(at("[0,0]", "[8,8]", "[1,0,3,2]"), "Cover")).level;
  EXPECT_EQ(color(level, 0, 0), kLeft);
  EXPECT_EQ(color(level, 7, 15), kLeft);
  EXPECT_EQ(color(level, 8, 0), kRight);
  EXPECT_EQ(color(level, 23, 15), kRight);
  EXPECT_EQ(color(level, 24, 0), kBehind);
}

TEST_F(LdtkBackground, MayBeRepeated) {
  const Level level = load(project(at("[14,7]", "[1,1]", "[0,0,4,2]"), "Repeat")).level;
  EXPECT_EQ(color(level, 2, 1), kLeft);
  EXPECT_EQ(color(level, 5, 1), kRight);
  EXPECT_EQ(color(level, 30, 15), kLeft);
}

TEST_F(LdtkBackground, WithoutAPlaceIsAtTheCorner) {
  EXPECT_EQ(color(load(project("null")).level, 0, 0), kLeft);
}

TEST_F(LdtkBackground, ThatIsMissingOrHasNoPlaceIsSaid) {
  std::filesystem::remove(path("bg.png"));
  const LoadedLevel loaded = load(project(at("[0,0]", "[1,1]", "[0,0,4,2]")));
  EXPECT_THAT(loaded.level.objects, IsEmpty());
  ASSERT_EQ(loaded.dropped.size(), 1u);
  EXPECT_THAT(loaded.dropped[0], testing::StartsWith("the picture behind the level"));
  for (const char* place : {R"({"topLeftPx":[0,0],"scale":[0,1],"cropRect":[0,0,4,2]})",
                            R"({"topLeftPx":[0],"scale":[1,1],"cropRect":[0,0,4,2]})",
                            R"({"topLeftPx":[0,0],"scale":[1,1],"cropRect":[0,0,1e30,2]})"})
    EXPECT_FALSE(load_level(put("p.ldtk", project(place)))) << place;
}

// What was changed of its layer is kept, and its picture is that which LDtk has now.
TEST_F(LdtkBackground, ChangesOfItAreInTheCompanion) {
  const std::string text = project(at("[0,0]", "[8,8]", "[0,0,4,2]"), "Cover");
  LoadedLevel loaded = load(text);
  loaded.level.objects[0].opacity = 0.5;
  loaded.level.objects.push_back({.name = "own"});
  ASSERT_TRUE(save_level(loaded.level, *find_format("ldtk"), path("p.ldtk"), loaded.companion));
  EXPECT_TRUE(load(text).level == loaded.level);
  put_picture({9, 9, 9});
  const Level again = load(text).level;
  ASSERT_EQ(again.objects.size(), 2u);
  EXPECT_EQ(again.objects[0].opacity, 0.5);
  EXPECT_EQ(again.objects[0].objects.at(0).picture.picture->at(0, 0)[0], 9);
  const Level bare = load(project("")).level;
  ASSERT_EQ(bare.objects.size(), 1u) << "LDtk has no picture there now";
  EXPECT_EQ(bare.objects[0].name, "own");
}

TEST_F(LdtkBackground, ThatWasRemovedStaysAway) {
  const std::string text = project(at("[0,0]", "[1,1]", "[0,0,4,2]"));
  LoadedLevel loaded = load(text);
  loaded.level.objects.clear();
  ASSERT_TRUE(save_level(loaded.level, *find_format("ldtk"), path("p.ldtk"), loaded.companion));
  EXPECT_THAT(load(text).level.objects, IsEmpty());
}

TEST_F(LdtkBackground, ParallaxIsThatOfTheLayer) {
  std::string text = project("");
  text.insert(text.find("\"intGridValues\""),
              R"("parallaxFactorX":0.25,"parallaxFactorY":-0.5,"parallaxScaling":false,)");
  const LoadedLevel loaded = load(text);
  EXPECT_EQ(loaded.level.layers.list[0].parallax, (Vec2{0.75, 1.5}));
  EXPECT_THAT(loaded.dropped, IsEmpty());
  text.replace(text.find("false"), 5, "true");
  EXPECT_THAT(load(text).dropped, ElementsAre("that its parallax scales the layer \"Grid\""));
}

}  // namespace talus::ldtk_background_test
