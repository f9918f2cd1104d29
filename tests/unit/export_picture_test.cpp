// The map as a PNG and as an SVG drawing, pixel by pixel and path by path.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "export/map_paint.h"
#include "folder_test.h"
#include "formats/pictures/png_picture.h"
#include "pictured_level.h"
#include "unit/exported_level.h"
#include "unit/program_output.h"

namespace talus::export_picture_test {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ExportPng, IsTheMapInItsColours) {
  Level level = level_of_shapes({"12", "..", "21"});
  Sheet& tiles = level.sheet(SheetId::tiles);
  for (int i = 0; i < 64; ++i) tiles.images[1][i] = static_cast<std::uint8_t>(i % 16);
  tiles.images[2].fill(3);
  const auto picture = read_png(exported_file("png", level));
  ASSERT_TRUE(picture) << picture.error().message;
  ASSERT_EQ(picture->width, 16);
  ASSERT_EQ(picture->height, 24);
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 16; ++x) {
      const TileNumber tile = level.map.tile_at({x / 8, y / 8});
      EXPECT_EQ(picture->at(x, y), level.palette[tiles.images[tile][y % 8 * 8 + x % 8]]) << x << "," << y;
    }
  }
}

TEST(ExportPng, ShowsAllLayersInTheirOrder) {
  Level level = pictured_level();
  const auto color_at = [&](int x, int y) {
    const auto picture = read_png(exported_file("png", level));
    EXPECT_TRUE(picture) << picture.error().message;
    return picture ? picture->at(x, y) : Rgb();
  };
  EXPECT_EQ(color_at(8, 8), kTree) << "the upper half of the tree is above its cell";
  EXPECT_EQ(color_at(15, 23), kTree);
  EXPECT_EQ(color_at(8, 7), level.palette[0]);
  EXPECT_EQ(color_at(5, 5), kSky);
  EXPECT_EQ(color_at(6, 5), level.palette[0]);
  EXPECT_EQ(color_at(16, 7), kRock) << "which is scaled";
  EXPECT_EQ(color_at(23, 0), kRock);
  level.objects[0].image->repeats_x = true;
  EXPECT_EQ(color_at(0, 4), kSky);
  level.objects[0].offset = {8, 20};
  EXPECT_EQ(color_at(12, 20), kTree) << "the sky is behind it";
  level.objects[0].place = 1;
  EXPECT_EQ(color_at(12, 20), kSky);
  level.objects[1].visible = false;
  EXPECT_EQ(color_at(16, 7), level.palette[0]);
}

// Two trees, of which the one that is drawn later covers the other.
TEST(ExportPng, LargeTilesLieOverOneAnotherInOrder) {
  Level level = pictured_level();
  level.large_tiles[2] = {plain_part(16, 8, kRock), {16, 8}};
  level.map.set({0, 2}, 2);
  const auto color_at = [&](int x, int y) { return read_png(exported_file("png", level))->at(x, y); };
  EXPECT_EQ(color_at(12, 20), kTree);
  level.layers.order = RenderOrder::left_down;
  EXPECT_EQ(color_at(12, 20), kRock);
}

TEST(ExportPng, ALargeMapIsRefused) {
  Level level;
  level.map = TileMap(32'769, 1);
  EXPECT_EQ(exported("png", level, "map.png").error().message,
            "the map is 262152x8 px, but a picture may have at most 262144 px on each side and 2147483648 px "
            "in all");
  level.map = TileMap(1024, 513);
  EXPECT_EQ(
      exported("svg", level, "map.svg").error().message,
      "the map is 8192x4104 px, but a picture may have at most 262144 px on each side and 33554432 px in "
      "all");
}

// More rows than a strip has, with pictures that reach from one strip into the next.
TEST(ExportPng, StripsOfAMapFitTogether) {
  Level level = pictured_level();
  level.map = TileMap(1, 200, {128, 250});
  level.large_tiles[1] = {plain_part(8, 240, kTree), {8, 240}};
  for (int y = 0; y < 200; ++y) level.map.set({0, y}, 1);
  const auto picture = read_rgba(exported_file("png", level), kMaxSheetPictureSide * 4);
  ASSERT_TRUE(picture) << picture.error().message;
  const auto whole = map_pixels(level, 0, 200 * 250, [](double) { return true; });
  ASSERT_EQ(picture->height, 200 * 250);
  int different = 0;
  for (std::size_t i = 0; i < whole.size(); ++i)
    different += static_cast<std::uint8_t>(picture->bytes[i]) == whole[i] ? 0 : 1;
  EXPECT_EQ(different, 0);
}

TEST(ExportTilesPng, IsInTrueColour) {
  Level level;
  level.map = TileMap(1, 1, {2, 2});
  level.set_tile_layout({2, 2});
  auto picture = std::make_shared<SheetPicture>(SheetPicture{4, 2, std::vector<std::uint8_t>(32, 77)});
  level.sheet(SheetId::tiles).picture = picture;
  const auto read = read_rgba(exported_file("tiles-png", level));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->width, 4);
  EXPECT_EQ(read->bytes, std::string(32, 77));
  level.sheet(SheetId::tiles).picture = nullptr;
  EXPECT_EQ(read_rgba(exported_file("tiles-png", level))->width, 16) << "8x8 px each";
}

// The drawing, read as XML.
class ExportSvg : public FolderTest {
 protected:
  pugi::xml_node draw(const Level& level) {
    const std::string text = exported_file("svg", level);
    const auto parsed = document_.load_string(text.c_str());
    EXPECT_TRUE(parsed) << parsed.description();
    return document_.child("svg");
  }
  std::string drawn(const char* id) {
    return document_.child("svg").find_child_by_attribute("path", "id", id).attribute("d").value();
  }

 private:
  pugi::xml_document document_;
};

TEST_F(ExportSvg, HoldsThePictureOfTheMap) {
  const Level level = level_of_shapes({"1.", "11"});
  const pugi::xml_node root = draw(level);
  EXPECT_STREQ(root.attribute("xmlns").value(), "http://www.w3.org/2000/svg");
  EXPECT_STREQ(root.attribute("viewBox").value(), "0 0 16 16");
  const std::string data = root.child("image").attribute("xlink:href").value();
  ASSERT_THAT(data, StartsWith("data:image/png;base64,"));
  const std::string file = put("base64", data.substr(data.find(',') + 1));
  EXPECT_EQ(output_of("base64 -d '" + file + "'"), exported_file("png", level));
}

TEST_F(ExportSvg, DrawsOutlineAndNormals) {
  draw(level_of_shapes({"2", "1"}));
  EXPECT_EQ(drawn("ground"), "M0 8L8 0L8 16L0 16Z");
  EXPECT_THAT(drawn("normals"), StartsWith("M4 4l-1.414213562373095"));
  EXPECT_THAT(drawn("normals"), HasSubstr("M8 8l2 0M4 16l0 2M0 12l-2 0"));
  EXPECT_EQ(drawn("one-way"), "");
  EXPECT_EQ(drawn("curves"), "");
}

TEST_F(ExportSvg, DashesOneWayLines) {
  const pugi::xml_node root = draw(level_of_shapes({"77"}));
  EXPECT_EQ(drawn("one-way"), "M0 0L16 0");
  EXPECT_EQ(drawn("normals"), "M8 0l0 -2");
  EXPECT_STREQ(root.find_child_by_attribute("path", "id", "one-way").attribute("stroke-dasharray").value(),
               "2 1");
}

TEST_F(ExportSvg, DrawsCurvesExactly) {
  const auto curve = [this](const auto& form, Curve::Faces faces = Curve::Faces::up) {
    Level level;
    level.map = TileMap(5, 5);
    level.curves.push_back({"", {form, faces}, ""});
    draw(level);
    return drawn("curves");
  };
  EXPECT_EQ(curve(Segment{{0, 8}, {8, 4}}), "M0 8L8 4");
  EXPECT_EQ(curve(Segment{{8, 0}, {8, 4}}), "M8 4L8 0");
  EXPECT_EQ(curve(Polyline{0, 8, {4, 6, 4}}, Curve::Faces::both), "M0 4L4 6L8 4");
  const std::string normals = drawn("normals");  // on both sides of both lines
  EXPECT_THAT(normals, StartsWith("M2 5l"));
  EXPECT_EQ(std::count(normals.begin(), normals.end(), 'M'), 4);
  EXPECT_EQ(curve(Arc{{20, 20}, 10, 10, 30, true}), "M10 20A10 10 0 0 1 30 20");
  EXPECT_EQ(curve(Arc{{20, 20}, 10, 14, 26, false}), "M14 28A10 10 0 0 0 26 28");
  EXPECT_EQ(curve(Parabola{{0, 8}, {16, 12}, -4}), "M0 8Q8 -4 16 12");
  EXPECT_EQ(curve(Cubic{{0, 8}, {12, 8}, -1, 1}), "M0 8C4 4 8 4 12 8");
  EXPECT_THAT(drawn("normals"), StartsWith("M3 5.75l-0.894427190"));  // it turns at 6,5

  const std::string sine = curve(Sine{0, 16, 20, 4, 16, 0});
  EXPECT_THAT(sine, StartsWith("M0 20C"));
  EXPECT_EQ(std::count(sine.begin(), sine.end(), 'C'), 16);
  EXPECT_THAT(sine, HasSubstr(" 4 24C"));
}

TEST_F(ExportSvg, DrawsBodies) {
  Level level;
  level.map = TileMap(2, 2);
  Spawn& spawn = level.spawns.emplace_back();
  spawn.name = "a <b> & \"c\"\x01";
  spawn.kind = BodyKind::player;
  spawn.position = {1.5, 2};
  spawn.size = {6, 12};
  const pugi::xml_node root = draw(level);
  const pugi::xml_node box = root.find_child_by_attribute("g", "id", "spawns").child("rect");
  EXPECT_STREQ(box.attribute("class").value(), "player");
  EXPECT_STREQ(box.attribute("x").value(), "1.5");
  EXPECT_STREQ(box.attribute("height").value(), "12");
  EXPECT_STREQ(box.child("title").text().get(), "a <b> & \"c\" ");
  EXPECT_EQ(drawn("ground"), "");
}

}  // namespace talus::export_picture_test
