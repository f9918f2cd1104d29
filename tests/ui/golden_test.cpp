// The debugger's panels, compared with pictures.
#include "edit/level_settings.h"
#include "golden_harness.h"
#include "paths.h"

namespace talus::golden_test {

class UiGoldenDebugger : public UiGolden {
 protected:
  // Opens the third hard case with a ball of the article, which sticks where the slope ends.
  void open_case() {
    start(source_path("assets/hard_cases/03-step-with-a-slope.talus.json"));
    Tuning tuning = level().tuning;
    tuning.solver = SolverKind::article;
    session().apply(action::EditLevel{set_tuning(level(), tuning)});
    session().apply(action::SelectBody{ball().id});
    for (int i = 0; i < 33; ++i) session().apply(action::StepFrame{});
  }
  void open_tab(const std::string& id) {
    if (!app().ui().view.window.dock_open) key(kKeyF4);
    frames(2);
    click("tabs/" + id);
  }
  // The debugger's panels, from their tabs down to the timeline.
  void expect_dock(const std::string& name) {
    const Widget *tabs = find("tabs/input_roll"), *track = find("timeline/track");
    ASSERT_NE(tabs, nullptr);
    ASSERT_NE(track, nullptr);
    expect_as_before(name, {tabs->min.x - 8, tabs->min.y}, {1280, track->min.y});
  }
};

TEST_F(UiGoldenDebugger, OverlaysInThePlayView) {
  open_case();
  for (const Overlay* overlay :
       {&overlay::boxes, &overlay::normals, &overlay::touch_points, &overlay::velocity, &overlay::slope_delta,
        &overlay::outline, &overlay::trails})
    session().apply(action::SetOverlay{overlay, true});
  frames(2);
  expect_widget("overlays", "play/canvas");
}

TEST_F(UiGoldenDebugger, TimelineAndTransport) {
  open_case();
  session().apply(action::SetMark{20, "here"});
  session().apply(action::SeekFrame{25});
  frames(2);
  const Widget* track = find("timeline/track");
  ASSERT_NE(track, nullptr);
  expect_as_before("transport", {0, track->min.y}, {640, 720});
}

TEST_F(UiGoldenDebugger, InputRoll) {
  open_case();
  open_tab("input_roll");
  session().apply(action::SetInput{28, 31, InputKey::jump, true});
  expect_dock("input-roll");
}

TEST_F(UiGoldenDebugger, Plots) {
  open_case();
  open_tab("plots");
  session().apply(action::SetPlot{0, {"vy", 0}});
  session().apply(action::SetPlot{1, {"penetration", 0}});
  expect_dock("plots");
}

TEST_F(UiGoldenDebugger, Breakpoints) {
  open_case();
  open_tab("breakpoints");
  session().apply(action::SetBreakpoint{{.condition = "frame > 1 && !changed(x)", .body = 1}});
  session().apply(action::SetBreakpoint{{.condition = "penetration > 1", .count = 2, .enabled = false}});
  expect_dock("breakpoints");
}

TEST_F(UiGoldenDebugger, Comparison) {
  open_case();
  open_tab("compare");
  session().apply(action::CompareVariant{Variant{SolverKind::exact, false}});
  expect_dock("comparison");
}

TEST_F(UiGoldenDebugger, StagesOfAStep) {
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
