// The layouts of the window, and the one canvas in which a level plays while it is painted.
#include "harness.h"
#include "panels/canvas/opening_area.h"

namespace talus::layouts_test {

constexpr int kEscape = 27;

class UiLayouts : public UiTest {
 protected:
  void SetUp() override { begin_with_the_first_layout(); }
  double width_of(std::string_view widget) {
    const Widget* found = find(widget);
    return found != nullptr ? found->max.x - found->min.x : 0;
  }
  ImVec2 on_play(Cell cell) { return on_canvas("play", level().map.box_of(cell).center()); }
};

TEST_F(UiLayouts, TheFirstIsOneCanvasThatTakesMostOfTheWindow) {
  start();
  EXPECT_EQ(find("map/canvas"), nullptr);
  EXPECT_GE(width_of("play/canvas"), 0.6 * 1280);
  EXPECT_NE(find("sheet/tiles"), nullptr);
  EXPECT_NE(find("tabs/layers"), nullptr);
}

TEST_F(UiLayouts, OnePaintsWhileItPlays) {
  start();
  key(kKeyF5);
  click(on_sheet(1));
  click(on_play({10, 10}));
  EXPECT_EQ(tile_at({10, 10}), 1);
  EXPECT_TRUE(session().playback().running);
  EXPECT_EQ(session().choices().body, 0) << "nothing was held";
}

TEST_F(UiLayouts, TheHandHoldsBodiesUntilAToolIsChosen) {
  start();
  const Vec2 middle = ball().box.center();
  click(on_canvas("play", middle));
  EXPECT_EQ(session().choices().body, ball().id);
  EXPECT_FALSE(session().modified());
  click(on_sheet(1));
  click("map/fill");
  click("map/stamp");
  click(on_play({10, 10}));
  EXPECT_TRUE(session().modified());
  click("canvas/paint_in_play");
  session().apply(action::SelectBody{0});
  click(on_canvas("play", middle));
  EXPECT_EQ(session().choices().body, ball().id);
}

TEST_F(UiLayouts, EachShowsWhatItsWorkNeeds) {
  start();
  click("layout/play");
  frames(3);
  EXPECT_EQ(find("sheet/tiles"), nullptr);
  EXPECT_NE(find("tabs/tuning"), nullptr);
  EXPECT_EQ(find("tabs/input_roll"), nullptr);
  EXPECT_GE(width_of("play/canvas"), 0.75 * 1280);
  key(ctrl_shift('3'));
  frames(3);
  EXPECT_NE(find("tabs/input_roll"), nullptr);
  EXPECT_NE(find("tabs/why"), nullptr);
  click("layout/draw");
  frames(3);
  EXPECT_NE(find("sheet/tiles"), nullptr);
  EXPECT_EQ(find("tabs/input_roll"), nullptr);
}

TEST_F(UiLayouts, DebugKeepsTheZoomAndTheBodyInTheMiddle) {
  open_as_users_do();
  start();
  session().apply(action::SelectBody{ball().id});
  session().apply(action::Pause{});
  frames(2);
  const auto zoom = [&] { return (on_canvas("play", {108, 0}).x - on_canvas("play", {100, 0}).x) / 8; };
  const float before = zoom();
  click("layout/debug");
  frames(5);
  EXPECT_EQ(zoom(), before);
  const Widget* canvas = find("play/canvas");
  const ImVec2 at = on_canvas("play", ball().box.center());
  EXPECT_GT(at.y, canvas->min.y);
  EXPECT_LT(at.y, canvas->max.y);
}

TEST_F(UiLayouts, TheCanvasCanBeAlone) {
  start();
  key(ctrl(' '));
  frames(2);
  EXPECT_EQ(find("menu/File"), nullptr);
  EXPECT_EQ(find("transport/play"), nullptr);
  EXPECT_EQ(width_of("play/canvas"), 1280 - 8);
  key(kEscape);
  frames(2);
  EXPECT_NE(find("menu/File"), nullptr);
  EXPECT_NE(find("sheet/tiles"), nullptr);
}

TEST_F(UiLayouts, TheMouseFindsTheWayBackToThePanels) {
  start();
  key(ctrl(' '));
  move({640, 400});
  frames(2);
  EXPECT_NE(find("alone/back"), nullptr) << "at first it is shown";
  frames(5 * 60);
  EXPECT_EQ(find("alone/back"), nullptr);
  move({100, 10});
  frames(2);
  click("alone/back");
  frames(2);
  EXPECT_NE(find("menu/File"), nullptr);
}

TEST_F(UiLayouts, AColumnThatOpensKeepsTheZoom) {
  start();
  key(alt('.'));
  frames(3);
  const auto zoom = [&] { return on_canvas("play", {108, 0}).x - on_canvas("play", {100, 0}).x; };
  const double before = zoom(), width = width_of("play/canvas");
  app().ui().ask(request::ShowTab(panel_id::kLayers));
  frames(5);
  EXPECT_LT(width_of("play/canvas"), width - 100);
  EXPECT_EQ(zoom(), before);
}

TEST_F(UiLayouts, AColumnOpensForThePanelThatIsAskedFor) {
  start();
  key(alt(','));
  key(alt('.'));
  frames(2);
  EXPECT_EQ(find("sheet/tiles"), nullptr);
  EXPECT_EQ(find("tabs/layers"), nullptr);
  key(kKeyF2);
  frames(2);
  EXPECT_NE(find("sheet/tiles"), nullptr);
  click("menu/Edit");
  frames(2);
  app().ui().ask(request::ShowTab(panel_id::kWhy));
  frames(3);
  EXPECT_NE(find("tabs/why"), nullptr);
}

TEST_F(UiLayouts, ClosedColumnsAreRemembered) {
  start();
  click("layout/play");
  frames(2);
  start(path("level.talus.json"));
  EXPECT_EQ(find("sheet/tiles"), nullptr);
}

TEST_F(UiLayouts, TheCanvasComesFirstInASmallWindow) {
  start(save_test_level("level.talus.json"), 900, 600);
  EXPECT_NE(find("sheet/tiles"), nullptr);
  EXPECT_EQ(find("tabs/inspector"), nullptr);
  EXPECT_GE(width_of("play/canvas"), 450);
  start(save_test_level("level.talus.json"), 700, 450);
  EXPECT_NE(find("sheet/tiles"), nullptr);
  EXPECT_EQ(find("tabs/inspector"), nullptr) << "there is no room for it";
  EXPECT_GE(width_of("play/canvas"), 350);
  app().ui().ask(request::ShowTab(panel_id::kProblems));
  frames(3);
  EXPECT_NE(find("tabs/problems"), nullptr) << "who asks for it sees it";
  EXPECT_EQ(find("sheet/tiles"), nullptr);
  EXPECT_GE(width_of("play/canvas"), 350);
  key(kKeyF2);
  frames(2);
  EXPECT_NE(find("sheet/tiles"), nullptr);
  for (const Widget& widget : app().ui().widgets.all()) {
    if (widget.name.starts_with("transport/") || widget.name.starts_with("overlay/group")) {
      EXPECT_LE(widget.max.x, 700) << widget.name;
    }
  }
}

TEST_F(UiLayouts, TheMapKeepsHalfOfALowWindow) {
  start(save_test_level("level.talus.json"), 700, 450);
  const auto share = [&] {
    const Widget& canvas = *find("play/canvas");
    return (canvas.max.x - canvas.min.x) * (canvas.max.y - canvas.min.y) / (700 * 450);
  };
  for (const char* layout : {"layout/draw", "layout/play", "layout/debug"}) {
    click(layout);
    frames(3);
    EXPECT_GE(share(), 0.5f) << layout;
  }
  EXPECT_NE(find("tabs/why"), nullptr);
  app().ui().ask(request::ShowTab(panel_id::kInputRoll));
  frames(3);
  EXPECT_NE(find("tabs/input_roll"), nullptr) << "the dock takes the place of the column";
  EXPECT_EQ(find("tabs/why"), nullptr);
  EXPECT_GE(share(), 0.45f);
}

TEST_F(UiLayouts, TheMenuTicksTheColumnThatHasRoom) {
  start(save_test_level("level.talus.json"), 900, 600);
  const auto ticked = [&](CommandId id) { return find_command(id).is_checked(session(), app().ui()); };
  EXPECT_TRUE(ticked("view/left_column"_command));
  EXPECT_FALSE(ticked("view/right_column"_command));
  key(alt('.'));
  frames(2);
  EXPECT_NE(find("tabs/inspector"), nullptr) << "it takes the place of the other";
  EXPECT_FALSE(ticked("view/left_column"_command));
  EXPECT_TRUE(ticked("view/right_column"_command));
}

TEST_F(UiLayouts, PlayHasTheHandAndTheTuningAlone) {
  start();
  click("layout/play");
  frames(3);
  EXPECT_EQ(find("map/fill"), nullptr) << "nobody paints without the sheet";
  EXPECT_EQ(find("tabs/problems"), nullptr);
  const Widget* tuning = find("tabs/tuning");
  ASSERT_NE(tuning, nullptr);
  click("canvas/more");
  frames(2);
  click("map/fill");
  frames(2);
  EXPECT_EQ(session().choices().map_tool, MapTool::fill);
  EXPECT_NE(find("map/erase"), nullptr) << "now somebody does";
  click("status/problems");
  frames(3);
  EXPECT_NE(find("tabs/problems"), nullptr) << "who asks for it sees it";
  EXPECT_NE(find("tabs/tuning"), nullptr);
}

TEST_F(UiLayouts, ToolsThatHaveNoRoomAreInAMenu) {
  start(save_test_level("level.talus.json"), 1152, 700);
  const float row = find("canvas/play")->min.y;
  for (const Widget& widget : app().ui().widgets.all()) {
    if (widget.name.starts_with("map/") && widget.name.find("canvas") == std::string::npos) {
      EXPECT_LE(widget.min.y, row + 4) << widget.name << " is in a second row";
    }
  }
  ASSERT_NE(find("canvas/more"), nullptr);
  EXPECT_EQ(find("map/minimap"), nullptr);
  click("canvas/more");
  frames(2);
  click("map/minimap");
  EXPECT_TRUE(app().ui().view.canvas.minimap);
}

TEST_F(UiLayouts, ATabIsDraggedToAnotherRegionAndToAnEdge) {
  start();
  drag(centre("tabs/why"), centre("tabs/layers"));
  frames(3);
  EXPECT_GT(find("tabs/why")->min.y, find("tabs/inspector")->max.y) << "it is below";
  const Widget* canvas = find("play/canvas");
  drag(centre("tabs/why"), {canvas->centre().x, canvas->max.y - 20});
  frames(3);
  EXPECT_TRUE(app().ui().view.window.dock_open) << "the edge opens the region";
  EXPECT_NE(find("tabs/plots"), nullptr);
  EXPECT_LT(find("tabs/why")->min.x, find("tabs/layers")->min.x);
  key(ctrl('0'));
  frames(3);
  EXPECT_LT(find("tabs/why")->max.y, find("tabs/layers")->min.y) << "back in its first place";
}

TEST_F(UiLayouts, ATabIsClosedAndComesBackByTheMenu) {
  start();
  click("tabs/why", kRight);
  click("tabs/why/close");
  frames(3);
  EXPECT_EQ(find("tabs/why"), nullptr);
  start(path("level.talus.json"));
  EXPECT_EQ(find("tabs/why"), nullptr) << "it is remembered";
  click("menu/View");
  click("menu/panels");
  click("menu/panels/why");
  frames(3);
  EXPECT_NE(find("tabs/why"), nullptr);
}

TEST_F(UiLayouts, AReadyLayoutShowsWhatIsClosedOrOutOfSight) {
  start();
  click("menu/View");
  click("menu/panels");
  click("menu/panels/input_roll");  // its region is closed
  frames(3);
  EXPECT_NE(find("tabs/input_roll"), nullptr);
  click("layout/draw");
  move_tab(app().ui().view.window, "why", TabPlace::closed);
  move_tab(app().ui().view.window, "input_roll", TabPlace::closed);
  frames(2);
  click("layout/debug");
  frames(3);
  EXPECT_NE(find("tabs/why"), nullptr);
  EXPECT_NE(find("tabs/input_roll"), nullptr);
}

TEST_F(UiLayouts, EscapeEndsTheDragOfATab) {
  start();
  move(centre("tabs/why"));
  press();
  move(centre("tabs/layers"));
  frames(2);
  key(kEscape);
  frames(2);
  move(find("play/canvas")->centre());
  release();
  frames(2);
  EXPECT_TRUE(app().ui().view.window.moved_tabs.empty());
}

TEST_F(UiLayouts, EscapeGoesBackToTheHand) {
  start();
  click(on_sheet(1));
  EXPECT_TRUE(app().ui().view.canvas.paint_in_play);
  move(find("play/canvas")->centre());
  key(kEscape);
  EXPECT_FALSE(app().ui().view.canvas.paint_in_play);
}

TEST_F(UiLayouts, ACommandBringsAClosedTabBack) {
  start();
  move_tab(app().ui().view.window, "why", TabPlace::closed);
  frames(2);
  ASSERT_EQ(find("tabs/why"), nullptr);
  app().ui().ask(request::ShowTab("why"));
  frames(3);
  EXPECT_NE(find("tabs/why"), nullptr);
}

TEST_F(UiLayouts, ARegionWithoutTabsLeavesItsRoom) {
  start();
  for (const char* panel : {"problems", "history", "flag_search", "layers"})
    move_tab(app().ui().view.window, panel, TabPlace::left);
  frames(3);
  EXPECT_NE(find("tabs/inspector"), nullptr);
  EXPECT_EQ(find("layout/right_split"), nullptr);
  for (const char* panel : {"inspector", "why", "shape", "tile", "tuning", "brushes"})
    move_tab(app().ui().view.window, panel, TabPlace::dock);
  frames(3);
  EXPECT_EQ(find("layout/right"), nullptr);
  EXPECT_GE(width_of("play/canvas"), 0.75 * 1280);
}

TEST_F(UiLayouts, OnesOwnAreSavedByNameAndComeBack) {
  start();
  click("layout/debug");
  frames(2);
  key(ctrl_shift('4'));
  frames(3);
  type("mine");  // the window has the keys
  click("layouts/save");
  click("layout/draw");
  frames(3);
  EXPECT_EQ(find("tabs/input_roll"), nullptr);
  start(path("level.talus.json"));
  ASSERT_EQ(app().ui().view.layouts.size(), 1u);
  EXPECT_EQ(app().ui().view.layouts[0].name, "mine");
  key(ctrl_shift('4'));
  frames(3);
  click("layouts/saved0");
  frames(3);
  EXPECT_NE(find("tabs/input_roll"), nullptr);
  EXPECT_EQ(find("sheet/tiles"), nullptr);
  EXPECT_EQ(find("layouts/saved0"), nullptr) << "the window has done its work";
  key(ctrl_shift('4'));
  frames(3);
  click("layouts/saved0/drop");
  EXPECT_TRUE(app().ui().view.layouts.empty());
}

}  // namespace talus::layouts_test
