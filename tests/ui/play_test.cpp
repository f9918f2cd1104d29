// Running, stepping, painting during play, holding balls, and the overlays.
#include <array>

#include "harness.h"

namespace talus::play_test {

class UiPlay : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  ImVec2 on_ball() {
    const Rect& box = ball().box;
    return on_canvas("play", {box.x + box.w / 2, box.y + box.h / 2});
  }
};

TEST_F(UiPlay, PlayMovesTheBallAndPauseStopsIt) {
  const Rect before = ball().box;
  click("transport/play");
  EXPECT_TRUE(session().playback().running);
  frames(20);
  EXPECT_GT(ball().box.y, before.y + 5);
  key(kKeyF5);
  EXPECT_FALSE(session().playback().running);
  const State paused = session().state();
  frames(10);
  EXPECT_EQ(session().state(), paused);
}

TEST_F(UiPlay, StepMakesExactlyOneFrame) {
  State expected = session().state();
  expected = step(session().scene(), expected, Input{});
  key(kKeyF10);
  EXPECT_EQ(session().state(), expected);
  click("transport/step");
  EXPECT_EQ(session().state().frame, 2);
  key(kKeyF5);
  frames(5);
  const auto frame = session().state().frame;
  EXPECT_GT(frame, 2);
  key(kKeyF10);
  EXPECT_FALSE(session().playback().running);
  frames(10);
  EXPECT_LE(session().state().frame, frame + 2);  // the frame of the key itself may still have run
}

TEST_F(UiPlay, ResetAndRunFromTheStart) {
  const Rect home = ball().box;
  for (int i = 0; i < 5; ++i) key(kKeyF10);
  click("transport/reset");
  EXPECT_EQ(session().state().frame, 0);
  EXPECT_EQ(ball().box, home);
  for (int i = 0; i < 5; ++i) key(kKeyF10);
  key(ctrl('r'));
  EXPECT_TRUE(session().playback().running);
  EXPECT_LE(session().state().frame, 3);
}

TEST_F(UiPlay, SpeedFollowsTheKeys) {
  key(',');
  EXPECT_EQ(session().playback().speed, 0.5);
  key('.');
  key('.');
  EXPECT_EQ(session().playback().speed, 2);
  key(kKeyF5);
  const auto before = session().state().frame;
  frames(10);
  EXPECT_EQ(session().state().frame, before + 20);
}

TEST_F(UiPlay, APaintedTileTakesEffectInTheNextStep) {
  for (int i = 0; i < 5; ++i) key(kKeyF10);
  click(on_sheet(1));
  const Cell below{5, static_cast<int>(ball().box.bottom()) / 8};
  for (int x = 4; x <= 6; ++x) click(on_map({x, below.y}));
  ASSERT_LE(ball().box.bottom(), below.y * 8.0 + 8);
  for (int i = 0; i < 20; ++i) key(kKeyF10);
  EXPECT_LE(ball().box.bottom(), below.y * 8.0 + 0.01);
}

TEST_F(UiPlay, PaintingInTheRunningPlayView) {
  key('p');
  key(kKeyF5);
  click(on_sheet(1));
  click(on_canvas("play", {84, 44}));
  EXPECT_EQ(tile_at({10, 5}), 1);
  EXPECT_TRUE(session().playback().running);
}

TEST_F(UiPlay, MouseDragsTheBall) {
  const ImVec2 to = on_canvas("play", {164, 40});
  move(on_ball());
  press();
  key(kKeyF5);
  EXPECT_EQ(session().choices().body, 1);
  frames(2);
  EXPECT_EQ(session().state().grabbed, 1);
  move(to);
  frames(60);
  EXPECT_NEAR(ball().box.x + 4, 164, 1);
  EXPECT_NEAR(ball().box.y + 4, 40, 1);
  release();
  frames(2);
  EXPECT_EQ(session().state().grabbed, 0);
  EXPECT_GT(ball().velocity.y, 0);
}

TEST_F(UiPlay, PausedBallIsHeldUntilTheNextStep) {
  const ImVec2 to = on_canvas("play", {164, 40});
  const Rect before = ball().box;
  move(on_ball());
  press();
  move(to);
  EXPECT_EQ(session().state().grabbed, 1);
  EXPECT_EQ(ball().box, before);
  key(kKeyF10);
  EXPECT_GT(ball().box.x, before.x + 1);
  for (int i = 0; i < 60; ++i) key(kKeyF10);
  EXPECT_NEAR(ball().box.x + 4, 164, 1);
  release();
  key(kKeyF10);
  EXPECT_EQ(session().state().grabbed, 0);
}

TEST_F(UiPlay, APausedBallReleasedBeforeAStepStays) {
  const State before = session().state();
  move(on_ball());
  press();
  move(on_canvas("play", {164, 40}));
  release();
  EXPECT_EQ(session().state(), before);
}

TEST_F(UiPlay, AClickChoosesABodyAndBesideItClears) {
  click(on_ball());
  EXPECT_EQ(session().choices().body, 1);
  click(on_canvas("play", {180, 20}));
  EXPECT_EQ(session().choices().body, 0);
}

// It is held where it was pressed.
TEST_F(UiPlay, AClickDoesNotMoveABody) {
  key(kKeyF5);
  frames(200);  // it rests
  const Vec2 place = ball().box.position();
  const ImVec2 middle = on_ball();
  const ImVec2 corner{middle.x + 5, middle.y - 5};
  move(corner);
  press();
  frames(20);
  EXPECT_EQ(session().state().grabbed, 1);
  EXPECT_NEAR(ball().box.x, place.x, 0.01);
  EXPECT_NEAR(ball().box.y, place.y, 0.01);
  move({corner.x + 20, corner.y - 30});
  frames(30);
  EXPECT_LT(ball().box.y, place.y - 4) << "it follows the mouse";
  release();
}

TEST_F(UiPlay, OverlaysAreSwitched) {
  int number = 0;
  for (const Overlay* overlay : all_overlays()) {
    const bool before = session().choices().overlays.has(*overlay);
    click("overlay/" + std::string(overlay->key));
    key(KeyChord{kKeyEscape});  // closes the list of its group
    EXPECT_NE(session().choices().overlays.has(*overlay), before) << overlay->key;
    key(number < 9 ? alt('1' + number) : alt_shift(number < 18 ? '1' + number - 9 : '0'));
    EXPECT_EQ(session().choices().overlays.has(*overlay), before) << overlay->key;
    ++number;
  }
}

TEST_F(UiPlay, AnOverlayIsShownWhileTheMouseIsOnItsName) {
  move(centre("overlay/velocity"));
  frames(2);
  EXPECT_EQ(app().ui().view.canvas.hovered_overlay, &overlay::velocity);
  EXPECT_FALSE(session().choices().overlays.has(overlay::velocity)) << "it is not switched on";
  key(KeyChord{kKeyEscape});
  frames(2);
  EXPECT_EQ(app().ui().view.canvas.hovered_overlay, nullptr);
}

TEST_F(UiPlay, SetsOfOverlaysAnswerOneQuestion) {
  EXPECT_TRUE(session().choices().overlays.has(overlay::floor_height));
  EXPECT_FALSE(session().choices().overlays.has(overlay::velocity)) << "one overlay at first";
  const auto choose = [&](const std::string& name) {
    click("overlay/presets");
    frames(2);
    click(name);
    frames(2);
    return session().choices().overlays;
  };
  OverlaySet article;
  for (const Overlay* each :
       {&overlay::boxes, &overlay::normals, &overlay::slope_delta, &overlay::floor_height})
    article.set(*each, true);
  EXPECT_EQ(choose("overlays/article"), article);
  EXPECT_TRUE(choose("overlays/none").empty());
  for (const Overlay* each : all_overlays()) article.set(*each, true);
  EXPECT_EQ(choose("overlays/all"), article);
  const OverlaySet stuck = choose("overlays/stuck");
  EXPECT_TRUE(stuck.has(overlay::outline) && stuck.has(overlay::normals) && !stuck.has(overlay::reach));
}

TEST_F(UiPlay, TheLabelsOfEveryBodyAreAChoice) {
  EXPECT_FALSE(app().ui().view.canvas.labels_all);
  click("overlay/presets");
  frames(2);
  click("canvas/labels");
  EXPECT_TRUE(app().ui().view.canvas.labels_all);
}

TEST_F(UiPlay, WheelZoomsAtTheMouse) {
  const ImVec2 at = on_map({20, 5});
  move(at);
  const Vec2 before = *app().ui().view.canvas.hover.pixel;
  wheel(2);
  frames();
  const Vec2 after = *app().ui().view.canvas.hover.pixel;
  EXPECT_NEAR(after.x, before.x, 0.5);
  EXPECT_NEAR(after.y, before.y, 0.5);
  move({at.x + 32, at.y});
  EXPECT_NEAR(app().ui().view.canvas.hover.pixel->x - after.x, 8, 1e-4);  // 2x became 4x
}

TEST_F(UiPlay, DragsOfTheOtherButtonsMoveTheView) {
  const std::pair<const char*, int> drags[] = {
      {"map", kRight}, {"map", kMiddle}, {"play", kRight}, {"play", kMiddle}};
  for (const auto& [canvas, button] : drags) {
    const ImVec2 from = on_canvas(canvas, {68, 68}), to{from.x + 40, from.y + 24};
    drag(from, to, button);
    move(to);
    EXPECT_EQ(app().ui().view.canvas.hover.cell, (Cell{8, 8})) << canvas;
  }
  EXPECT_FALSE(session().modified());
}

TEST_F(UiPlay, SpaceAndTheLeftButtonMoveTheView) {
  key(kKeyF3);
  const ImVec2 from = on_map({8, 8}), to{from.x + 40, from.y + 24};
  move(from);
  hold(' ');
  drag(from, to);
  let_go(' ');
  move(to);
  EXPECT_EQ(app().ui().view.canvas.hover.cell, (Cell{8, 8}));
  EXPECT_FALSE(session().modified()) << "nothing was painted";
}

TEST_F(UiPlay, ArrowsScrollAndTabShowsTheWholeMap) {
  key(kKeyF3);
  const ImVec2 before = on_map({8, 8});
  key(kKeyRight);
  EXPECT_EQ(on_map({8, 8}).x, before.x - 64);
  key(kKeyLeft);
  key('=');
  key(kKeyTab);
  key(kKeyTab);
  key('-');
  EXPECT_EQ(on_map({8, 8}).x, before.x);
}

TEST_F(UiPlay, TheFirstScreenIsFittedAgain) {
  key(kKeyF3);
  const auto places = [&] {
    const ImVec2 a = on_map({8, 8}), b = on_map({9, 9});
    return std::array{a.x, a.y, b.x, b.y};
  };
  const auto before = places();
  for (const int steps : {2, -6}) {
    move(on_map({8, 8}));
    wheel(steps);
    key(kKeyRight);
    EXPECT_NE(places(), before);
    key(alt(kKeyHome));
    EXPECT_EQ(places(), before);
  }
  key(kKeyTab);
  key(alt(kKeyHome));
  EXPECT_EQ(places(), before) << "from the world view, too";
}

}  // namespace talus::play_test
