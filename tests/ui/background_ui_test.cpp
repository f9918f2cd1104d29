// The background of the map: its dialog, and what the canvases show where nothing is drawn.
#include "edit/level_settings.h"
#include "golden_harness.h"
#include "harness.h"
#include "panels/commands/commands.h"

namespace talus::background_ui_test {

constexpr Rgb kRed{200, 10, 20}, kOfTheTheme{0x1a, 0x1c, 0x2c};

class UiBackground : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start_on_the_map();
    session().apply(action::Pause{});
    session().apply(action::EditLevel{set_color(level(), 0, kRed)});
  }
  // What the window shows at an empty place of a canvas.
  Rgb empty_place(const std::string& canvas = "map") {
    move({2, 2});
    frames(2);
    const ImVec2 at = on_canvas(canvas, {100, 36});
    const std::string taken = path("window.png");
    EXPECT_TRUE(app().screenshot(taken));
    const Picture picture = load_picture(taken);
    const std::size_t pixel = 4 * (static_cast<std::size_t>(at.y) * static_cast<std::size_t>(picture.width) +
                                   static_cast<std::size_t>(at.x));
    return {picture.rgba[pixel], picture.rgba[pixel + 1], picture.rgba[pixel + 2]};
  }
  void set(std::optional<Rgba> background) {
    session().apply(action::EditLevel{set_background(level(), background)});
  }
};

TEST_F(UiBackground, IsChosenInItsDialog) {
  Actions actions;
  find_command("map/background"_command).run(session(), actions, app().ui());
  frames(3);
  click("background/clear");
  EXPECT_EQ(level().background, Rgba());
  click("background/own");
  EXPECT_EQ(level().background, (Rgba{kRed.r, kRed.g, kRed.b, 255}));
  click("background/colour_0");
  EXPECT_EQ(level().background, std::nullopt);
  click("background/clear");
  click("background/close");
  frames(3);
  EXPECT_EQ(find("background/close"), nullptr);
  EXPECT_EQ(session().history().edits().back().label, "Change the background");
  key(ctrl('z'));
  EXPECT_EQ(level().background, std::nullopt);
  key(ctrl('y'));
  EXPECT_EQ(level().background, Rgba());
}

TEST_F(UiBackground, IsSeenWhereNothingIsDrawn) {
  for (const std::string canvas : {"map", "play"}) {
    set(std::nullopt);
    EXPECT_EQ(empty_place(canvas), kRed) << "colour 0";
    set(Rgba{1, 200, 3, 255});
    EXPECT_EQ(empty_place(canvas), (Rgb{1, 200, 3}));
    set(Rgba());
    EXPECT_EQ(empty_place(canvas), kOfTheTheme) << "clear";
  }
}

}  // namespace talus::background_ui_test
