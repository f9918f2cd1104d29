// The ready layouts as a whole, and the panels for drawing, compared with pictures.
#include "golden_harness.h"
#include "panels/commands/commands.h"
#include "paths.h"

namespace talus::golden_window_test {

const ImVec2 kWhole{1280, 720};

class UiGoldenWindow : public UiGolden {
 protected:
  void SetUp() override {
    UiGolden::SetUp();
    start(source_path("tests/ui/broken.talus.json"));
    session().apply(action::SelectTiles{{SheetId::tiles, {3, 0, 2, 1}}});
    settle();
  }
  void press(CommandId command) {
    key(find_command(command).key);
    frames(3);
  }
  // Compares the area from the top left of the first widget to the bottom right of the second, with a margin
  // of some px.
  void expect_between(const std::string& name, const std::string& first, const std::string& last) {
    settle();
    const Widget *from = find(first), *to = find(last);
    ASSERT_NE(from, nullptr) << first;
    ASSERT_NE(to, nullptr) << last;
    expect_as_before(name, {from->min.x - 8, from->min.y - 8}, {to->max.x + 8, to->max.y + 8});
  }
};

TEST_F(UiGoldenWindow, LayoutToDraw) {
  press("view/layout_draw"_command);
  expect_as_before("layout-draw", {0, 0}, kWhole);
}

TEST_F(UiGoldenWindow, LayoutToPlay) {
  press("view/layout_play"_command);
  for (int i = 0; i < 30; ++i) session().apply(action::StepFrame{});
  expect_as_before("layout-play", {0, 0}, kWhole);
}

TEST_F(UiGoldenWindow, LayoutToDebug) {
  press("view/layout_debug"_command);
  for (int i = 0; i < 30; ++i) session().apply(action::StepFrame{});
  session().apply(action::SelectBody{1});
  expect_as_before("layout-debug", {0, 0}, kWhole);
}

TEST_F(UiGoldenWindow, SpritesEnlargedAmongTheirNeighbours) {
  key(kKeyF2);
  press("pixels/enlarge"_command);
  press("pixels/neighbours"_command);
  expect_as_before("sprites", {0, 0}, {kWhole.x * 0.7f, 640});
}

TEST_F(UiGoldenWindow, FlagsPanel) {
  session().apply(action::SetFlagOverlay{pattern_of_flag(2)});
  const Widget *byte = find("flags/byte"), *last = find("flags/lamp7");
  ASSERT_NE(byte, nullptr);
  ASSERT_NE(last, nullptr);
  expect_as_before("flags", {0, byte->min.y - 8}, {last->max.x + 24, last->max.y + 8});
}

TEST_F(UiGoldenWindow, WorldViewAndMinimap) {
  press("canvas/two_maps"_command);
  key(kKeyF3);
  press("map/minimap"_command);
  press("map/fit"_command);
  expect_between("maps", "map/canvas", "second_map/canvas");
}

TEST_F(UiGoldenWindow, ProblemsPanel) {
  app().ui().view.requests.ask(request::ShowTab("problems"));
  settle();
  const Widget* row = find("problems/row0");
  ASSERT_NE(row, nullptr);
  expect_as_before("problems", {row->min.x - 8, row->min.y - 60}, {1280, row->min.y + 130});
}

TEST_F(UiGoldenWindow, Settings) {
  press("edit/settings"_command);
  expect_between("settings", "settings/dark", "settings/reset_layout");
}

TEST_F(UiGoldenWindow, AButtonThatMovedIsAnotherPicture) {
  press("view/layout_draw"_command);
  const Picture window = picture_of_window();
  Picture shown;
  ASSERT_EQ(first_difference(window, window, shown), "");
  const Widget* button = find("canvas/play");
  ASSERT_NE(button, nullptr);
  const auto pixel = [&](float x, float y) {
    return 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(window.width) +
                static_cast<std::size_t>(x));
  };
  // The button moves right by a third of its width, over the gap beside it.
  Picture moved = window;
  const float by = std::floor((button->max.x - button->min.x) / 3);
  for (float y = button->min.y; y < button->max.y; ++y)
    for (float x = button->min.x; x < button->max.x; ++x)
      std::copy_n(window.rgba.begin() + static_cast<std::ptrdiff_t>(pixel(x, y)), 4,
                  moved.rgba.begin() + static_cast<std::ptrdiff_t>(pixel(x + by, y)));
  EXPECT_NE(first_difference(moved, window, shown), "");
  // Another shade of every pixel, as from another driver, is the same picture.
  Picture shaded = window;
  for (std::uint8_t& channel : shaded.rgba)
    channel = static_cast<std::uint8_t>(channel < 128 ? channel + 30 : channel - 30);
  EXPECT_EQ(first_difference(shaded, window, shown), "");
  // So the comparison also sees which tool is chosen.
  press("map/fill"_command);
  EXPECT_NE(first_difference(picture_of_window(), window, shown), "");
}

}  // namespace talus::golden_window_test
