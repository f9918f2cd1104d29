// Tiles in true colour in the pixel canvas: colours are chosen, painted with, undone and saved.
#include <fstream>

#include "formats/pictures/png_picture.h"
#include "harness.h"

namespace talus::rgba_ui_test {

class UiRgba : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    put_map(16, 4);
    start(path("map.tmx"), 1152, 700);
  }
  // A map of Tiled whose tileset has `count` tiles of that side in a row, each pixel with one of 30 colours.
  void put_map(int side, int count) {
    side_ = side;
    width_ = side * count;
    rgba_.clear();
    for (int i = 0; i < width_ * side; ++i) {
      const auto part = static_cast<std::uint8_t>(i / 7 % 30 * 8);
      rgba_.insert(rgba_.end(), {part, static_cast<std::uint8_t>(240 - part), 90, 255});
    }
    put("t.png", encode_png(width_, side, 4, rgba_.data()));
    const std::string px = std::to_string(side), tiles = std::to_string(count);
    put("map.tmx", "<map version=\"1.8\" orientation=\"orthogonal\" width=\"3\" height=\"2\" tilewidth=\"" +
                       px + "\" tileheight=\"" + px + "\"><tileset firstgid=\"1\" name=\"t\" tilewidth=\"" +
                       px + "\" tileheight=\"" + px + "\" tilecount=\"" + tiles + "\" columns=\"" + tiles +
                       "\"><image source=\"t.png\" width=\"" + std::to_string(width_) + "\" height=\"" + px +
                       "\"/></tileset><layer id=\"1\" name=\"l\" width=\"3\" height=\"2\"><data "
                       "encoding=\"csv\">1,2,1,0,0,2</data></layer></map>");
  }
  void put(const std::string& name, const std::string& bytes) {
    std::ofstream(path(name), std::ios::binary) << bytes;
  }
  // Selects the second tile of the set, which is in cell (1,0).
  void select_tile() {
    if (!find("pixels/canvas")) click("pixels/show");
    const CellRect tile = app().ui().place_on_sheet(level().map.tile_at({1, 0}));
    session().apply(action::SelectTiles{{SheetId::tiles, tile}});
    frames(2);
  }
  Rgba pixel(int x, int y) { return rgba_of(pixel_at(level(), session().choices().area, x, y)); }
  void paint_first() {  // and answer the question
    click(on_pixels(2, 3));
    frames(2);
    ASSERT_TRUE(session().question());
    click("question/paint");
    frames(2);
  }

  int side_ = 0, width_ = 0;
  std::vector<std::uint8_t> rgba_;  // of the picture
};

TEST_F(UiRgba, AColourIsChosenPaintedUndoneAndSaved) {
  select_tile();
  click("palette/picture7");
  frames(1);
  const Rgba color = session().choices().rgba;
  const Rgba before = pixel(2, 3);
  ASSERT_NE(color, before);
  paint_first();
  EXPECT_EQ(pixel(2, 3), color);
  drag(on_pixels(5, 5), on_pixels(9, 5));
  EXPECT_EQ(pixel(7, 5), color);
  key(ctrl('z'));
  EXPECT_NE(pixel(7, 5), color);
  EXPECT_EQ(pixel(2, 3), color);
  key(ctrl('s'));
  frames(2);
  EXPECT_FALSE(session().modified());
  const auto saved = read_rgba(bytes_of(path("t.png")));
  ASSERT_TRUE(saved);
  for (int i = 0; i < width_ * side_; ++i) {
    const auto* now = reinterpret_cast<const std::uint8_t*>(saved->bytes.data()) + 4 * i;
    const bool is_painted = i == 3 * width_ + side_ + 2;
    EXPECT_EQ(std::equal(now, now + 4, &rgba_[static_cast<std::size_t>(4 * i)]), !is_painted) << i;
  }
  start(path("map.tmx"), 1152, 700);
  select_tile();
  EXPECT_EQ(pixel(2, 3), color);
  EXPECT_NE(pixel(7, 5), color);
}

TEST_F(UiRgba, TheRightButtonErasesAndTheMiddleOnePicks) {
  select_tile();
  paint_first();
  click(on_pixels(4, 4), kRight);
  EXPECT_EQ(pixel(4, 4), Rgba{});
  const Rgba wanted = pixel(8, 8);
  click(on_pixels(8, 8), kMiddle);
  EXPECT_EQ(session().choices().rgba, wanted);
  click("palette/eraser");
  click(on_pixels(8, 8));
  EXPECT_EQ(pixel(8, 8).a, 0);
}

TEST_F(UiRgba, AllColoursOpenOnAClick) {
  select_tile();
  click("palette/left");
  frames(2);
  const Widget* const picker = find("picker/picker");
  ASSERT_NE(picker, nullptr);
  EXPECT_GE(picker->min.y, 0);
  EXPECT_LE(picker->max.y, 700);
  const Rgba before = session().choices().rgba;
  click(ImVec2{picker->min.x + 40, picker->min.y + 60});
  frames(1);
  EXPECT_NE(session().choices().rgba, before);
  click("picker/hex");
  key(ctrl('a'));
  type("#12345680");
  key(kKeyEnter);
  frames(2);
  EXPECT_EQ(session().choices().rgba, (Rgba{0x12, 0x34, 0x56, 0x80}));
  click("picker/right");
  click("picker/hex");
  key(ctrl('a'));
  type("fa0");
  key(kKeyEnter);
  frames(2);
  EXPECT_EQ(session().choices().secondary_rgba, (Rgba{0xff, 0xaa, 0x00, 0xff}));
}

TEST_F(UiRgba, PaintedColoursAreRemembered) {
  select_tile();
  session().apply(action::SetRgba{{1, 2, 3, 255}, false});
  paint_first();
  session().apply(action::SetRgba{{9, 8, 7, 255}, false});
  frames(1);
  click("tabs/color");
  frames(2);
  click("color/recent0");
  EXPECT_EQ(session().choices().rgba, (Rgba{1, 2, 3, 255}));
}

TEST_F(UiRgba, LargeTilesHaveRoomAndAreZoomed) {
  put_map(256, 2);
  start(path("map.tmx"), 1152, 700);
  select_tile();
  const Widget fits = *find("pixels/canvas");
  EXPECT_GE(fits.min.x, 0);
  EXPECT_LE(fits.max.y, find("palette/left")->min.y) << "above the colours";
  move({(fits.min.x + fits.max.x) / 2, (fits.min.y + fits.max.y) / 2});
  hold_modifiers(ctrl('a'));
  for (int i = 0; i < 4; ++i) wheel(1);
  hold_modifiers();
  frames(2);
  const Widget zoomed = *find("pixels/canvas");
  EXPECT_GT(zoomed.max.x - zoomed.min.x, 2 * (fits.max.x - fits.min.x));
  const ImVec2 at{(fits.min.x + fits.max.x) / 2, (fits.min.y + fits.max.y) / 2};
  const int x = static_cast<int>((at.x - zoomed.min.x) / (zoomed.max.x - zoomed.min.x) * 256);
  const int y = static_cast<int>((at.y - zoomed.min.y) / (zoomed.max.y - zoomed.min.y) * 256);
  EXPECT_NEAR(x, 128, 24) << "it stays under the mouse";
  click(at);
  frames(2);
  click("question/paint");
  frames(2);
  EXPECT_EQ(pixel(x, y), session().choices().rgba);
  const Widget before = *find("pixels/canvas");
  drag({at.x, at.y}, {at.x + 30, at.y + 20}, kMiddle);
  frames(2);
  EXPECT_GT(find("pixels/canvas")->min.x, before.min.x + 15) << "the middle button drags them";
  EXPECT_GT(find("pixels/canvas")->min.y, before.min.y + 5);
}

}  // namespace talus::rgba_ui_test
