// Parts of the window against pictures of them in golden/, in small blocks and with some tolerance, as
// graphics drivers draw edges differently. TALUS_UPDATE_GOLDEN=1 writes the pictures anew, to be looked at.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>

#include "harness.h"
#include "platform/picture.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace talus::golden_test {

namespace fs = std::filesystem;

constexpr int kFarOff = 48;           // of 255: a channel that differs by more makes another colour
constexpr int kBlock = 32;            // px, side of the blocks that are compared
constexpr double kMostFarOff = 0.12;  // share of a block's pixels: more of another colour is another picture

Picture load_picture(const std::string& path) {
  Picture picture;
  int channels = 0;
  stbi_uc* pixels = stbi_load(path.c_str(), &picture.width, &picture.height, &channels, 4);
  if (pixels == nullptr) return {};
  picture.rgba.assign(pixels, pixels + std::size_t{4} * picture.width * picture.height);
  stbi_image_free(pixels);
  return picture;
}

std::size_t at(const Picture& picture, int x, int y) {
  return (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
          static_cast<std::size_t>(x)) *
         4;
}

Picture cut(const Picture& picture, ImVec2 min, ImVec2 max) {
  const int x0 = std::clamp(static_cast<int>(min.x), 0, picture.width);
  const int y0 = std::clamp(static_cast<int>(min.y), 0, picture.height);
  Picture part{.width = std::clamp(static_cast<int>(max.x), x0, picture.width) - x0,
               .height = std::clamp(static_cast<int>(max.y), y0, picture.height) - y0,
               .rgba = {}};
  for (int y = 0; y < part.height; ++y) {
    const auto row = picture.rgba.begin() + static_cast<std::ptrdiff_t>(at(picture, x0, y0 + y));
    part.rgba.insert(part.rgba.end(), row, row + part.width * 4);
  }
  return part;
}

bool is_far_off(const Picture& a, const Picture& b, std::size_t pixel) {
  for (std::size_t i = pixel; i < pixel + 3; ++i)
    if (std::abs(int{a.rgba[i]} - int{b.rgba[i]}) > kFarOff) return true;
  return false;
}

// The first block that is another picture, as "x,y"; empty: all are alike. shown: what is far off, in red.
std::string first_difference(const Picture& a, const Picture& b, Picture& shown) {
  if (a.width != b.width || a.height != b.height) return "the size";
  shown = a;
  std::string first;
  for (int top = 0; top < a.height; top += kBlock) {
    for (int left = 0; left < a.width; left += kBlock) {
      int far_off = 0;
      for (int y = top; y < std::min(top + kBlock, a.height); ++y) {
        for (int x = left; x < std::min(left + kBlock, a.width); ++x) {
          const std::size_t pixel = at(a, x, y);
          if (!is_far_off(a, b, pixel)) continue;
          ++far_off;
          shown.rgba[pixel] = 255;
          shown.rgba[pixel + 1] = shown.rgba[pixel + 2] = 0;
        }
      }
      if (far_off > kMostFarOff * kBlock * kBlock && first.empty())
        first = std::to_string(left) + "," + std::to_string(top);
    }
  }
  return first;
}

class UiGolden : public UiTest {
 protected:
  // A ball of the article in the third hard case, which sticks where the slope ends.
  void open_case() {
    start(TALUS_SOURCE_DIR "/assets/hard_cases/03-step-with-a-slope.talus.json");
    Tuning tuning = level().tuning;
    tuning.solver = SolverKind::article;
    session().apply(action::EditLevel{set_tuning(level(), tuning)});
    session().apply(action::SelectBody{ball().id});
    for (int i = 0; i < 33; ++i) session().apply(action::StepFrame{});
  }
  void open_tab(const std::string& id) {
    if (!app().ui().view.dock_open) key(kKeyF4);
    frames(2);
    click("tabs/" + id);
  }
  // Until nothing is left to be computed, with the mouse out of the way.
  void settle() {
    move({2, 2});
    do frames(5);
    while (session().debugger().is_busy() || session().timeline().behind() || session().is_linting());
    session().apply(action::DismissMessage{});
    frames(2);
  }

  void expect_as_before(const std::string& name, ImVec2 min, ImVec2 max) {
    settle();
    const std::string taken = path("window.png");
    const auto shot = app().screenshot(taken);
    ASSERT_TRUE(shot) << shot.error();
    const Picture now = cut(load_picture(taken), min, max);
    const std::string golden = TALUS_SOURCE_DIR "/tests/ui/golden/" + name + ".png";
    if (std::getenv("TALUS_UPDATE_GOLDEN") != nullptr) {
      ASSERT_TRUE(write_png(now, golden));
      return;
    }
    const Picture before = load_picture(golden);
    ASSERT_GT(before.width, 0) << "no picture " << golden;
    Picture shown;
    const std::string where = first_difference(now, before, shown);
    if (where.empty()) return;
    const fs::path folder = TALUS_FAILURE_DIR;
    fs::create_directories(folder);
    EXPECT_TRUE(write_png(now, (folder / (name + "-now.png")).string()));
    if (!shown.rgba.empty()) {
      EXPECT_TRUE(write_png(shown, (folder / (name + "-far-off.png")).string()));
    }
    ADD_FAILURE() << name << " differs from " << golden << " at " << where << ": see " << folder;
  }
  void expect_widget(const std::string& name, const std::string& widget) {
    const Widget* found = find(widget);
    ASSERT_NE(found, nullptr) << widget;
    expect_as_before(name, found->min, found->max);
  }
  // The debugger's panels, from their tabs down to the timeline.
  void expect_dock(const std::string& name) {
    const Widget *tabs = find("tabs/input_roll"), *track = find("timeline/track");
    ASSERT_NE(tabs, nullptr);
    ASSERT_NE(track, nullptr);
    expect_as_before(name, {tabs->min.x - 8, tabs->min.y}, {1280, track->min.y});
  }
};

TEST_F(UiGolden, OverlaysInThePlayView) {
  open_case();
  for (const OverlayId id :
       {OverlayId::boxes, OverlayId::normals, OverlayId::touch_points, OverlayId::velocity,
        OverlayId::slope_delta, OverlayId::outline, OverlayId::trails})
    session().apply(action::SetOverlay{id, true});
  frames(2);
  expect_widget("overlays", "play/canvas");
}

TEST_F(UiGolden, TimelineAndTransport) {
  open_case();
  session().apply({action::SetMark{20, "here"}, action::SeekFrame{25}});
  frames(2);
  const Widget* track = find("timeline/track");
  ASSERT_NE(track, nullptr);
  expect_as_before("transport", {0, track->min.y}, {640, 720});
}

TEST_F(UiGolden, InputRoll) {
  open_case();
  open_tab("input_roll");
  session().apply(action::SetInput{28, 31, InputKey::jump, true});
  expect_dock("input-roll");
}

TEST_F(UiGolden, Plots) {
  open_case();
  open_tab("watch");
  session().apply({action::SetWatch{0, {"vy", 0}}, action::SetWatch{1, {"penetration", 0}}});
  expect_dock("plots");
}

TEST_F(UiGolden, Breakpoints) {
  open_case();
  open_tab("stops");
  session().apply(action::SetBreakpoint{{.condition = "frame > 1 && !changed(x)", .body = 1}});
  session().apply(action::SetBreakpoint{{.condition = "penetration > 1", .count = 2, .enabled = false}});
  expect_dock("breakpoints");
}

TEST_F(UiGolden, Comparison) {
  open_case();
  open_tab("compare");
  session().apply(action::CompareVariant{Variant{SolverKind::exact, false}});
  expect_dock("comparison");
}

TEST_F(UiGolden, StagesOfAStep) {
  open_case();
  click("tabs/why");
  key(kKeyF11);
  frames(2);
  const Widget *first = find("why/before"), *last = find("why/stage2");
  ASSERT_NE(first, nullptr);
  ASSERT_NE(last, nullptr);
  expect_as_before("stages", first->min, last->max);
}

}  // namespace talus::golden_test
