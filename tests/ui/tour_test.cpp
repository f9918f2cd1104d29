// The tour inside the program: each step waits for its deed, and points at something that is there.
#include "debug/explain.h"
#include "harness.h"
#include "panels/tour/tour_steps.h"

namespace talus::tour_test {

class UiTour : public UiTest {
 protected:
  // Begins the tour as a new user does.
  void begin() {
    open_as_users_do();
    start("");
    click("welcome/tour");
    frames(3);
    ASSERT_TRUE(frames_until([&] { return !session().reading(); }));
    ASSERT_EQ(step(), "run");
  }
  // The key of the step that waits; "end" after the last; empty: the tour is closed.
  std::string step() {
    frames(2);
    const TourView& tour = app().ui().view.tour;
    if (!tour.open) return "";
    const auto steps = tour_steps();
    return tour.step < static_cast<int>(steps.size()) ? std::string(steps[tour.step].key) : "end";
  }
  void skip_to(std::string_view key) {
    for (std::size_t i = 0; i < tour_steps().size() && step() != key; ++i) click("tour/skip");
    ASSERT_EQ(step(), key);
  }
};

TEST_F(UiTour, GoesFromRunningToWhyAndBack) {
  begin();
  hold(kKeyRight);
  frames(150);  // the seam stops the player
  let_go(kKeyRight);
  EXPECT_EQ(step(), "pause");
  key(kKeyF5);
  EXPECT_EQ(step(), "step");
  key(kKeyF10);
  EXPECT_EQ(step(), "paint");
  click(on_sheet(2));
  const Widget* canvas = find("map/canvas");
  click(ImVec2{canvas->min.x + 100, canvas->min.y + 100});
  EXPECT_EQ(step(), "overlays");
  click("overlay/presets");
  click("overlays/article");
  EXPECT_EQ(step(), "choose");
  ASSERT_NE(find("play/followed"), nullptr);
  click(find("play/followed")->centre());
  EXPECT_EQ(step(), "why");
  ASSERT_NE(find("why/last_stop"), nullptr) << "the panel is shown";
  click("why/last_stop");
  ASSERT_TRUE(frames_until([&] { return session().debugger().stop().has_value(); }));
  EXPECT_EQ(step(), "why") << "it asks for a sentence, too";
  click("why/stage0");
  EXPECT_EQ(step(), "back");
  const std::string why = explain_step(session().frame_view(), session().choices().body);
  EXPECT_NE(why.find("stopped by the left side of the tile at (10, 21)"), std::string::npos) << why;
  key(shift(kKeyF10));
  EXPECT_EQ(step(), "end");
  click("tour/close");
  EXPECT_EQ(step(), "");
  EXPECT_EQ(app().ui().view.tour.step, 0) << "it can begin again";
}

TEST_F(UiTour, WaitsForTheDeed) {
  begin();
  frames(120);
  EXPECT_EQ(step(), "run") << "nobody has pressed a key";
  skip_to("overlays");
  frames(60);
  EXPECT_EQ(step(), "overlays");
}

TEST_F(UiTour, ShowsTheSheetThatItAsksFor) {
  begin();
  click("layout/debug");
  frames(2);
  ASSERT_EQ(find("sheet/canvas"), nullptr);
  skip_to("paint");
  frames(2);
  EXPECT_NE(find("sheet/canvas"), nullptr);
}

TEST_F(UiTour, ChoosingABodyIsAskedForAlsoIfOneIsChosen) {
  begin();
  session().apply(action::SelectBody{1});
  skip_to("choose");
  EXPECT_EQ(session().choices().body, 0);
  frames(10);
  EXPECT_EQ(step(), "choose");
}

TEST_F(UiTour, EveryStepPointsAtWhatIsThere) {
  begin();
  for (std::size_t i = 0; i < tour_steps().size(); ++i) {
    frames(3);
    const TourStep& now = tour_steps()[app().ui().view.tour.step];
    EXPECT_NE(find(now.target(app().ui())), nullptr) << now.key;
    const Widget* note = find("tour/note");
    ASSERT_NE(note, nullptr);
    const ImVec2 window{1280, 720};
    EXPECT_TRUE(note->min.x >= 0 && note->min.y >= 0 && note->max.x <= window.x && note->max.y <= window.y)
        << now.key;
    click("tour/skip");
  }
  EXPECT_EQ(step(), "end");
}

TEST_F(UiTour, IsLeftAndGoesOnAfterAnotherStart) {
  begin();
  skip_to("paint");
  click("tour/leave");
  EXPECT_EQ(step(), "");
  start(save_test_level("own.talus.json"));
  EXPECT_EQ(step(), "");
  click("menu/Help");
  click("menu/help/tour");
  EXPECT_EQ(step(), "paint");
  EXPECT_EQ(session().path(), path("own.talus.json")) << "it goes on in the open level";
}

TEST_F(UiTour, AsksBeforeALevelIsLost) {
  start(save_test_level("own.talus.json"));
  click(on_sheet(2));
  click(on_map({2, 2}));
  ASSERT_TRUE(session().modified());
  click("menu/Help");
  click("menu/help/tour");
  frames(2);
  ASSERT_TRUE(session().question());
  EXPECT_EQ(step(), "") << "the level is not open";
  session().apply(action::AnswerQuestion{action::Answer::cancel});
  frames(3);
  EXPECT_EQ(step(), "") << "nor will it be";
  EXPECT_EQ(app().ui().view.tour.opens_after, -1);
}

TEST_F(UiTour, GoesBackFromThePlayedFrame) {
  begin();
  skip_to("back");
  frames(40);  // it plays meanwhile
  click("transport/back");
  click("transport/back");
  EXPECT_EQ(step(), "end");
}

}  // namespace talus::tour_test
