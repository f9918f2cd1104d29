// Drawing sprites: tools, selection, clipboard, sizes, neighbours, and which part of the window gets the
// keys.
#include <SDL_clipboard.h>

#include "harness.h"
#include "platform/picture.h"

namespace talus::sprite_test {

class UiSprite : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
    click(on_sheet(9));
    click("palette/color5");
    click("palette/color0", kRight);
  }
  // Eight rows of a tile: a hex digit for each pixel, and '.' for colour 0.
  std::string picture(int tile = 9) {
    std::string text;
    for (int i = 0; i < 64; ++i) {
      text += ".123456789abcdef"
          [level().sheet(SheetId::tiles).images[static_cast<std::size_t>(tile)][static_cast<std::size_t>(i)]];
      if (i % 8 == 7) text += '\n';
    }
    return text;
  }
  void hold_modifier(SDL_Keymod mod) {
    SDL_Event event{};
    event.type = mod == KMOD_NONE ? SDL_KEYUP : SDL_KEYDOWN;
    event.key.keysym.sym = SDLK_LSHIFT;
    event.key.keysym.scancode = SDL_SCANCODE_LSHIFT;
    event.key.keysym.mod = static_cast<Uint16>(mod);
    ASSERT_EQ(SDL_PushEvent(&event), 1);
    frames();
  }
  static std::string clipboard() {
    char* text = SDL_GetClipboardText();
    const std::string copy = text;
    SDL_free(text);
    return copy;
  }
  static void set_clipboard(const std::string& text) { ASSERT_EQ(SDL_SetClipboardText(text.c_str()), 0); }
  std::size_t undos() { return session().history().position(); }
  const std::optional<CellRect>& selected() { return session().choices().pixels.rect(); }
};

TEST_F(UiSprite, BrushGrowsByItsKeysAndButtons) {
  click(on_pixels(0, 0));
  key('=');
  EXPECT_EQ(session().choices().brush, 2);
  click(on_pixels(2, 2));
  click("pixels/brush4");
  click(on_pixels(5, 5));
  key('-');
  EXPECT_EQ(session().choices().brush, 3);
  EXPECT_EQ(picture(), "5.......\n........\n..55....\n..55....\n....5555\n....5555\n....5555\n....5555\n");
  EXPECT_EQ(undos(), 3u);
}

TEST_F(UiSprite, FastStrokeHasNoGaps) {
  move(on_pixels(0, 0));
  press();
  move(on_pixels(7, 7));
  release();
  EXPECT_EQ(picture(), "5.......\n.5......\n..5.....\n...5....\n....5...\n.....5..\n......5.\n.......5\n");
  EXPECT_EQ(undos(), 1u);
}

TEST_F(UiSprite, LineRectangleAndEllipseAreDrawnAtTheRelease) {
  key('l');
  move(on_pixels(0, 0));
  press();
  move(on_pixels(7, 0));
  EXPECT_EQ(undos(), 0u) << "a preview";
  release();
  EXPECT_EQ(picture().substr(0, 9), "55555555\n");
  key(ctrl('z'));
  key('r');
  drag(on_pixels(1, 1), on_pixels(6, 4));
  EXPECT_EQ(picture(), "........\n.555555.\n.5....5.\n.5....5.\n.555555.\n........\n........\n........\n");
  key(ctrl('z'));
  key('e');
  drag(on_pixels(0, 0), on_pixels(7, 7), kLeft);
  EXPECT_EQ(picture(), "..5555..\n.5....5.\n5......5\n5......5\n5......5\n5......5\n.5....5.\n..5555..\n");
  EXPECT_EQ(undos(), 1u);
}

TEST_F(UiSprite, ShiftMakesShapesEvenAndCtrlFillsThem) {
  click("pixels/line");
  hold_modifier(KMOD_LSHIFT);
  drag(on_pixels(0, 7), on_pixels(7, 6));
  click("pixels/rectangle");
  drag(on_pixels(1, 1), on_pixels(3, 2));
  hold_modifier(KMOD_LCTRL);
  click("pixels/ellipse");
  drag(on_pixels(4, 1), on_pixels(7, 4));
  hold_modifier(KMOD_NONE);
  EXPECT_EQ(picture(), "........\n.555.55.\n.5.55555\n.5555555\n.....55.\n........\n........\n55555555\n");
}

TEST_F(UiSprite, EscapeLeavesAShapeUndrawn) {
  key('r');
  move(on_pixels(1, 1));
  press();
  move(on_pixels(6, 4));
  key(kKeyEscape);
  release();
  EXPECT_EQ(undos(), 0u);
}

TEST_F(UiSprite, CtrlFillReplacesTheColourEverywhere) {
  click(on_pixels(0, 0));
  click(on_pixels(7, 7));
  click("palette/color2");
  key('4');
  hold_modifier(KMOD_LCTRL);
  click(on_pixels(0, 0));
  hold_modifier(KMOD_NONE);
  EXPECT_EQ(picture().front(), '2');
  EXPECT_EQ(picture()[picture().size() - 2], '2');
}

TEST_F(UiSprite, SelectionIsMovedByMouseAndArrows) {
  drag(on_pixels(0, 0), on_pixels(1, 0));
  key('3');
  drag(on_pixels(0, 0), on_pixels(1, 1));
  EXPECT_EQ(selected(), (CellRect{0, 0, 2, 2}));
  drag(on_pixels(1, 1), on_pixels(5, 3));
  EXPECT_EQ(selected(), (CellRect{4, 2, 2, 2}));
  key(kKeyDown);
  key(kKeyLeft);
  EXPECT_EQ(picture(), "........\n........\n........\n...55...\n........\n........\n........\n........\n");
  EXPECT_EQ(undos(), 2u) << "the stroke, and all moves";
  key(kKeyEscape);
  EXPECT_FALSE(selected());
  key(kKeyRight);
  EXPECT_EQ(session().choices().area.tiles, (CellRect{10, 0, 1, 1})) << "the sheet again";
  key(ctrl('z'));
  EXPECT_EQ(picture().substr(0, 9), "55......\n");
}

TEST_F(UiSprite, AClickSelectsOnePixelOrClearsTheSelection) {
  key('3');
  click(on_pixels(3, 4));
  EXPECT_EQ(selected(), (CellRect{3, 4, 1, 1}));
  click(on_pixels(6, 6));
  EXPECT_FALSE(selected());
}

TEST_F(UiSprite, TheWholeCanvasCanBeSelected) {
  click("pixels/size16");
  key(ctrl('a'));
  EXPECT_EQ(session().choices().sprite_tool, SpriteTool::select);
  EXPECT_EQ(selected(), (CellRect{0, 0, 16, 16}));
  key('1');
  EXPECT_FALSE(selected()) << "another tool removes the selection";
}

TEST_F(UiSprite, FlipsClearAndShiftActOnTheSelection) {
  drag(on_pixels(0, 0), on_pixels(0, 7));
  key('3');
  drag(on_pixels(0, 0), on_pixels(3, 1));
  click("pixels/flip_h");
  EXPECT_EQ(picture().substr(0, 27), "...5....\n...5....\n5.......\n");
  key(shift(kKeyLeft));
  EXPECT_EQ(picture().substr(0, 27), "..5.....\n..5.....\n5.......\n");
  key(kKeyDelete);
  EXPECT_EQ(picture().substr(0, 27), "........\n........\n5.......\n");
  key(kKeyEscape);
  key(shift(kKeyUp));
  EXPECT_EQ(picture(), "........\n5.......\n5.......\n5.......\n5.......\n5.......\n5.......\n........\n");
}

TEST_F(UiSprite, PixelsAreCopiedToAnotherTile) {
  drag(on_pixels(2, 2), on_pixels(3, 2));
  key('3');
  drag(on_pixels(2, 2), on_pixels(4, 2));
  key(ctrl('x'));
  EXPECT_EQ(clipboard(), "pixels 3x1\n550");
  EXPECT_EQ(picture().find('5'), std::string::npos);
  click(on_sheet(12));
  key(ctrl('v'));
  EXPECT_EQ(picture(12).substr(0, 9), "55......\n");
  key(kKeyDown);
  EXPECT_EQ(picture(12).substr(0, 18), "........\n55......\n");
  key(ctrl('z'));
  EXPECT_EQ(picture(12), picture(13));
}

TEST_F(UiSprite, TilesAreCopiedAsTic80Does) {
  click(on_pixels(0, 0));
  click("flags/lamp5");
  click("flags/lamp0");
  click(on_sheet(9));
  key(ctrl('c'));
  const std::string text = "5" + std::string(63, '0') + "12";
  EXPECT_EQ(clipboard(), text);
  click(on_sheet(20));
  key(ctrl('v'));
  EXPECT_EQ(picture(20), picture(9));
  EXPECT_EQ(level().sheet(SheetId::tiles).flags[20], 0x21);
  key(ctrl('z'));
  EXPECT_EQ(picture(20), picture(21));
  EXPECT_EQ(level().sheet(SheetId::tiles).flags[20], 0);
  click(on_sheet(9));
  key(ctrl('x'));
  EXPECT_EQ(picture(9), picture(21));
  EXPECT_EQ(level().sheet(SheetId::tiles).flags[9], 0);
}

TEST_F(UiSprite, PastingSaysWhatIsWrong) {
  set_clipboard("hello");
  key(ctrl('v'));
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
  EXPECT_EQ(session().message()->text, "The clipboard holds no sprites: copy some here or in TIC-80 first.");
  set_clipboard(std::string(4 * 66, '7'));
  key(ctrl('v'));
  EXPECT_EQ(session().message()->text,
            "The clipboard holds 2x2 tiles, and 1x1 are selected: select 2x2 to paste them.");
  EXPECT_FALSE(session().modified());
}

TEST_F(UiSprite, WheelAndButtonsChooseTheSizeOfTheCanvas) {
  move(on_pixels(4, 4));
  wheel(-1);
  frames();
  EXPECT_EQ(session().choices().area.tiles, (CellRect{9, 0, 2, 2}));
  wheel(-2);
  frames();
  EXPECT_EQ(session().choices().area.tiles, (CellRect{8, 0, 8, 8}));
  click("pixels/size16");
  EXPECT_EQ(session().choices().area.tiles, (CellRect{8, 0, 2, 2}));
  move(on_pixels(12, 3));
  wheel(1);
  frames();
  EXPECT_EQ(session().choices().area.tiles, (CellRect{9, 0, 1, 1})) << "the tile under the mouse";
  for (const char* side : {"32", "64", "8"}) {
    click(std::string("pixels/size") + side);
    EXPECT_EQ(session().choices().area.width(), std::stoi(side));
  }
}

TEST_F(UiSprite, PaletteGoesThroughTheClipboard) {
  click("palette/color3");
  click("palette/color3");  // a double click
  frames(2);
  ASSERT_NE(find("palette/hex"), nullptr) << "the colour's editor comes up";
  click("palette/copy");
  EXPECT_EQ(clipboard().size(), 96u);
  EXPECT_EQ(clipboard().substr(0, 12), "1a1c2c5d275d");
  set_clipboard("102030");
  click("palette/paste");
  EXPECT_EQ(level().palette[3], (Rgb{0x10, 0x20, 0x30}));
  key(ctrl('z'));
  EXPECT_EQ(level().palette, default_palette());
  set_clipboard("1020");
  key(ctrl_shift('v'));
  ASSERT_TRUE(session().message());
  EXPECT_TRUE(session().message()->is_error);
}

TEST_F(UiSprite, TheChosenToolIsMarkedUnderTheMouse) {
  const auto color_under_mouse = [&](const char* tool) {  // in the button, beside its icon
    move(centre(tool));
    frames(2);
    const auto taken = draw_picture();
    EXPECT_TRUE(taken);
    const Widget* button = find(tool);
    const auto at = static_cast<std::size_t>(button->min.y + 3) * static_cast<std::size_t>(taken->width) +
                    static_cast<std::size_t>(button->min.x + 12);
    return Rgb{taken->rgba[4 * at], taken->rgba[4 * at + 1], taken->rgba[4 * at + 2]};
  };
  click("pixels/line");
  const Rgb chosen = color_under_mouse("pixels/line"), other = color_under_mouse("pixels/fill");
  EXPECT_GT(chosen.b, other.b + 50) << "it is as blue as away from the mouse";
}

TEST_F(UiSprite, NeighboursOfTheLastPointedCellAreShown) {
  const auto color = [&](float x, float y) {  // px of the art
    const Widget* canvas = find("pixels/canvas");
    const float zoom = (canvas->max.x - canvas->min.x) / 8;
    const auto taken = draw_picture();
    EXPECT_TRUE(taken);
    const auto at =
        static_cast<std::size_t>(canvas->min.y + y * zoom) * static_cast<std::size_t>(taken->width) +
        static_cast<std::size_t>(canvas->min.x + x * zoom);
    return Rgb{taken->rgba[4 * at], taken->rgba[4 * at + 1], taken->rgba[4 * at + 2]};
  };
  click(on_sheet(1));
  click(on_map({10, 8}));
  click(on_sheet(6));
  click(on_map({9, 8}));
  click(on_map({11, 8}));
  click(on_sheet(1));
  const Widget before = *find("pixels/canvas");
  key('n');
  frames(2);
  EXPECT_LT(find("pixels/canvas")->max.x - find("pixels/canvas")->min.x, before.max.x - before.min.x);
  move(on_map({15, 16}));
  frames(2);
  const Rgb on_the_floor = color(8.5f, 4);
  move(on_map({10, 8}));
  frames(2);
  const Rgb placed = color(8.5f, 4);
  EXPECT_NE(placed, on_the_floor) << "6 instead of 1, dimmed";
  EXPECT_EQ(color(3.5f, 3.5f), level().palette[13]) << "the tile itself is not";
  click("sheet/show_sprites");
  frames(2);
  EXPECT_EQ(find("pixels/canvas")->max.x - find("pixels/canvas")->min.x, before.max.x - before.min.x);
}

TEST_F(UiSprite, CanvasIsEnlargedAboveTheMapAndBack) {
  const Widget before = *find("pixels/canvas");
  click("pixels/enlarge");
  frames(2);
  EXPECT_GE(find("pixels/canvas")->max.x - find("pixels/canvas")->min.x,
            1.5f * (before.max.x - before.min.x));
  click(on_pixels(7, 7));
  EXPECT_EQ(picture()[picture().size() - 2], '5');
  EXPECT_EQ(app().ui().view.window.focus, Focus::sprites);
  click(on_map({10, 4}));
  EXPECT_EQ(tile_at({10, 4}), 9) << "the map below it is at work";
  move(on_pixels(3, 3));
  key('z');
  frames(2);
  EXPECT_EQ(find("pixels/canvas")->min.x, before.min.x);
}

using UiFocus = UiSprite;

TEST_F(UiFocus, KeysFollowTheMouse) {
  drag(on_pixels(0, 0), on_pixels(7, 7));
  const std::string drawn = picture();
  EXPECT_EQ(app().ui().view.window.focus, Focus::sprites);
  move(on_map({10, 8}));
  key('8');
  EXPECT_EQ(session().choices().map_tool, MapTool::slope);
  EXPECT_EQ(picture(), drawn) << "the map's key must not clear the sprite";
  move(on_pixels(3, 3));
  key('8');
  EXPECT_EQ(picture(), picture(10)) << "cleared";
}

TEST_F(UiFocus, AKeyAfterAMoveWaitsForTheNewPlace) {
  drag(on_pixels(0, 0), on_pixels(7, 7));
  const std::string drawn = picture();
  const ImVec2 map = on_map({10, 8});
  move(on_pixels(3, 3));
  SDL_Event event{};
  event.type = SDL_MOUSEMOTION;
  event.motion.x = static_cast<int>(map.x);
  event.motion.y = static_cast<int>(map.y);
  ASSERT_EQ(SDL_PushEvent(&event), 1);
  push_stroke(KeyChord{'8'});
  frames(2);
  EXPECT_EQ(picture(), drawn);
  EXPECT_EQ(session().choices().map_tool, MapTool::slope);
}

TEST_F(UiFocus, FunctionKeysOverrideARestingMouse) {
  const ImVec2 at = on_pixels(3, 3);
  move(at);
  key(kKeyF3);
  EXPECT_EQ(app().ui().view.window.focus, Focus::map);
  move({at.x + 3, at.y});
  EXPECT_EQ(app().ui().view.window.focus, Focus::map) << "it was there before";
  click(at);
  EXPECT_EQ(app().ui().view.window.focus, Focus::sprites);
}

TEST_F(UiFocus, OtherPartsOfTheWindowTakeNoKeys) {
  move(on_map({10, 8}));
  move(centre("tabs/tuning"));
  EXPECT_EQ(app().ui().view.window.focus, Focus::map);
  move(centre("transport/play"));
  EXPECT_EQ(app().ui().view.window.focus, Focus::map);
}

}  // namespace talus::sprite_test
