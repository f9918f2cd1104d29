// Selected pixels: which of them move, which stay, and which come back.
#include <gtest/gtest.h>

#include "edit/sprite_clear.h"
#include "edit/sprite_fill.h"
#include "session/session.h"
#include "sprite_picture.h"

namespace talus::sprite_selection_test {

namespace act = action;

const SpriteArea kSelectionCanvas{SheetId::tiles, {0, 0, 1, 1}};
const std::string kSelectionStart =
    "12......\n34......\n........\n....aaaa\n....aaaa\n........\n........\n........\n";

// The right button's colour is 7.
class SpriteSelection : public ::testing::Test {
 protected:
  void SetUp() override {
    session.apply(act::SetColor{7, true});
    session.apply(act::SetSpriteTool{SpriteTool::select});
  }
  std::string picture() { return picture_of(session.level(), session.choices().area); }
  std::optional<CellRect> rect() { return session.choices().pixels.rect(); }
  std::size_t undos() { return session.history().position(); }
  void select(CellRect r) { session.apply(act::SelectPixels{r}); }
  void move(int x, int y) { session.apply(act::MovePixels{{x, y}}); }

  Session session{with_picture(Level(), kSelectionCanvas, kSelectionStart)};
};

TEST_F(SpriteSelection, IsClampedToTheCanvas) {
  select({-3, 6, 5, 9});
  EXPECT_EQ(rect(), (CellRect{0, 6, 2, 2}));
  select({20, -20, 2, 2});
  EXPECT_EQ(rect(), (CellRect{7, 0, 1, 1}));
  session.apply(act::SelectPixels{});
  EXPECT_FALSE(rect());
  move(1, 1);
  EXPECT_EQ(undos(), 0u);
}

TEST_F(SpriteSelection, MovesOverPixelsAndRestoresThem) {
  select({0, 0, 2, 2});
  move(5, 2);
  EXPECT_EQ(picture(), "77......\n77......\n.....12.\n....a34a\n....aaaa\n........\n........\n........\n");
  move(0, 4);
  EXPECT_EQ(picture(), "77......\n77......\n........\n....aaaa\n....aaaa\n........\n.....12.\n.....34.\n");
  EXPECT_EQ(rect(), (CellRect{5, 6, 2, 2}));
  EXPECT_EQ(undos(), 1u) << "all moves are one";
  EXPECT_EQ(session.history().edits()[0].label, "Move pixels");
  session.apply(act::Undo{});
  EXPECT_EQ(picture(), kSelectionStart);
  EXPECT_FALSE(rect()) << "what floated is gone";
  session.apply(act::Redo{});
  EXPECT_EQ(picture(), "77......\n77......\n........\n....aaaa\n....aaaa\n........\n.....12.\n.....34.\n");
}

TEST_F(SpriteSelection, MovingBackLeavesNoChange) {
  select({0, 0, 2, 2});
  move(3, 0);
  move(-3, 0);
  EXPECT_EQ(picture(), kSelectionStart);
  EXPECT_EQ(undos(), 0u);
  move(0, 1);
  EXPECT_EQ(picture(), "77......\n12......\n34......\n....aaaa\n....aaaa\n........\n........\n........\n");
  EXPECT_EQ(undos(), 1u);
}

TEST_F(SpriteSelection, PixelsOverTheEdgeAreKept) {
  select({0, 0, 2, 2});
  move(-1, 0);
  EXPECT_EQ(picture().substr(0, 18), "27......\n47......\n");
  move(-5, 0);
  EXPECT_EQ(rect(), (CellRect{-1, 0, 2, 2})) << "a column stays inside";
  EXPECT_EQ(session.choices().pixels.pixels(session.level(), kSelectionCanvas),
            (PixelBlock{2, 2, {1, 2, 3, 4}}));
  move(3, 0);
  EXPECT_EQ(picture().substr(0, 18), "7712....\n7734....\n");
}

TEST_F(SpriteSelection, DroppedOverTheEdgeItIsCut) {
  select({0, 0, 2, 2});
  move(-1, 0);
  session.apply(act::EditLevel{clear_pixels(session.level(), kSelectionCanvas, *rect(), 9)});
  EXPECT_EQ(rect(), (CellRect{-1, 0, 2, 2}));
  EXPECT_EQ(session.choices().pixels.pixels(session.level(), kSelectionCanvas), (PixelBlock{1, 2, {9, 9}}));
  move(2, 1);
  EXPECT_EQ(rect(), (CellRect{2, 1, 1, 2}));
  EXPECT_EQ(picture().substr(0, 27), "77......\n779.....\n..9.....\n");
}

TEST_F(SpriteSelection, AnotherEditDropsTheSelection) {
  select({0, 0, 2, 2});
  move(5, 2);
  session.apply(act::EditLevel{fill_pixels(session.level(), kSelectionCanvas, {4, 4}, 5)});
  ASSERT_EQ(picture(), "77......\n77......\n.....12.\n....5345\n....5555\n........\n........\n........\n");
  move(-1, 0);
  EXPECT_EQ(picture(), "77......\n77......\n....127.\n....3475\n....5555\n........\n........\n........\n");
  EXPECT_EQ(undos(), 3u);
}

TEST_F(SpriteSelection, TurnsInPlaceAndStaysSelected) {
  select({0, 0, 2, 2});
  session.apply(act::TurnPixels{PixelTurn::flip_horizontal});
  EXPECT_EQ(picture().substr(0, 18), "21......\n43......\n");
  session.apply(act::TurnPixels{PixelTurn::flip_vertical});
  EXPECT_EQ(picture().substr(0, 18), "43......\n21......\n");
  session.apply(act::TurnPixels{PixelTurn::shift_left});
  EXPECT_EQ(picture().substr(0, 18), "34......\n12......\n");
  EXPECT_EQ(undos(), 3u);
  move(5, 2);
  session.apply(act::TurnPixels{PixelTurn::rotate});
  EXPECT_EQ(picture(), "77......\n77......\n.....13.\n....a24a\n....aaaa\n........\n........\n........\n");
  move(0, -2);
  EXPECT_EQ(picture(), "77...13.\n77...24.\n........\n....aaaa\n....aaaa\n........\n........\n........\n")
      << "below it comes back";
}

TEST_F(SpriteSelection, RotatesAWideRectangleUpright) {
  select({4, 3, 4, 2});
  session.apply(act::TurnPixels{PixelTurn::rotate});
  EXPECT_EQ(rect(), (CellRect{5, 2, 2, 4}));
  EXPECT_EQ(picture(), "12......\n34......\n.....aa.\n....7aa7\n....7aa7\n.....aa.\n........\n........\n");
}

TEST_F(SpriteSelection, WithoutASelectionTheWholeCanvasTurns) {
  session.apply(act::TurnPixels{PixelTurn::shift_right});
  EXPECT_EQ(picture().substr(0, 9), ".12.....\n");
  session.apply(act::TurnPixels{PixelTurn::rotate});
  EXPECT_EQ(picture(), "...aa...\n......31\n......42\n........\n........\n...aa...\n...aa...\n...aa...\n");
  EXPECT_EQ(undos(), 2u);
  session.apply(act::SelectTiles{{SheetId::tiles, {0, 0, 2, 1}}});
  session.apply(act::TurnPixels{PixelTurn::rotate});
  EXPECT_EQ(undos(), 2u) << "no square";
}

TEST_F(SpriteSelection, PastedPixelsFloat) {
  session.apply(act::SetSpriteTool{SpriteTool::pencil});
  session.apply(act::PastePixels{{2, 1, {9, 8}}, {4, 3}});
  EXPECT_EQ(session.choices().sprite_tool, SpriteTool::select);
  EXPECT_EQ(rect(), (CellRect{4, 3, 2, 1}));
  EXPECT_EQ(picture(), "12......\n34......\n........\n....98aa\n....aaaa\n........\n........\n........\n");
  move(-4, -3);
  EXPECT_EQ(picture(), "98......\n34......\n........\n....aaaa\n....aaaa\n........\n........\n........\n");
  EXPECT_EQ(undos(), 1u) << "pasting and moving are one";
  session.apply(act::Undo{});
  EXPECT_EQ(picture(), kSelectionStart);
}

TEST_F(SpriteSelection, EndsWithAnotherToolCanvasOrLevel) {
  select({0, 0, 2, 2});
  session.apply(act::SetSpriteTool{SpriteTool::fill});
  EXPECT_FALSE(rect());
  select({0, 0, 2, 2});
  session.apply(act::SelectTiles{kSelectionCanvas});
  EXPECT_TRUE(rect()) << "the same canvas";
  session.apply(act::SelectTiles{{SheetId::sprites, {0, 0, 1, 1}}});
  EXPECT_FALSE(rect());
  select({0, 0, 2, 2});
  session.apply(act::NewLevel{});
  EXPECT_FALSE(rect());
}

TEST_F(SpriteSelection, BrushIsClamped) {
  session.apply(act::SetBrush{3});
  EXPECT_EQ(session.choices().brush, 3);
  session.apply(act::SetBrush{9});
  EXPECT_EQ(session.choices().brush, 4);
  session.apply(act::SetBrush{-1});
  EXPECT_EQ(session.choices().brush, 1);
}

}  // namespace talus::sprite_selection_test
