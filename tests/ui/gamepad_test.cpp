// Gamepads steer players, in the level and in what is recorded; their buttons are the user's.
#include "harness.h"
#include "panels/canvas/opening_area.h"

namespace talus::gamepad_ui_test {

class UiGamepad : public UiTest {
 protected:
  void SetUp() override {
    Level level = test_level();
    level.tuning.solver = SolverKind::exact;
    Spawn& player = level.spawns.emplace_back();
    player.kind = BodyKind::player;
    player.position = {100, 120};
    ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
    start(path("level.talus.json"));
    key(kKeyF5);
    frames(5);
  }
  void button(SDL_GameControllerButton button, bool down) {
    SDL_Event event{};
    event.type = down ? SDL_CONTROLLERBUTTONDOWN : SDL_CONTROLLERBUTTONUP;
    event.cbutton.which = 7;
    event.cbutton.button = static_cast<Uint8>(button);
    ASSERT_EQ(SDL_PushEvent(&event), 1);
    frames(1);
  }
  void stick(int value) {
    SDL_Event event{};
    event.type = SDL_CONTROLLERAXISMOTION;
    event.caxis.which = 7;
    event.caxis.axis = SDL_CONTROLLER_AXIS_LEFTX;
    event.caxis.value = static_cast<Sint16>(value);
    ASSERT_EQ(SDL_PushEvent(&event), 1);
    frames(1);
  }
  double x() { return followed_body(session().state(), 0)->box.x; }
  const Input& held() { return session().playback().input; }
};

TEST_F(UiGamepad, RunsAndJumpsAndIsRecorded) {
  const double before = x();
  button(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, true);
  frames(30);
  EXPECT_GT(x(), before + 20);
  button(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, false);
  EXPECT_FALSE(held().right);
  button(SDL_CONTROLLER_BUTTON_A, true);
  EXPECT_TRUE(held().jump);
  button(SDL_CONTROLLER_BUTTON_A, false);
  const Recording recorded = session().timeline().recording(session().timeline().current(), level());
  bool has_right = false, has_jump = false;
  for (const RecordedInput& input : recorded.input) {
    has_right = has_right || input.right;
    has_jump = has_jump || input.jump;
  }
  EXPECT_TRUE(has_right);
  EXPECT_TRUE(has_jump);
}

TEST_F(UiGamepad, TheStickRunsBeyondItsDeadZone) {
  stick(8000);
  EXPECT_FALSE(held().right) << "a quarter of its way";
  stick(20000);
  EXPECT_TRUE(held().right);
  stick(-32768);
  EXPECT_TRUE(held().left);
  EXPECT_FALSE(held().right);
  app().ui().view.preferences.pad.stick = false;
  stick(-32000);
  EXPECT_FALSE(held().left);
}

TEST_F(UiGamepad, StartPausesAndPlays) {
  button(SDL_CONTROLLER_BUTTON_START, true);
  EXPECT_FALSE(session().playback().running);
  button(SDL_CONTROLLER_BUTTON_START, false);
  button(SDL_CONTROLLER_BUTTON_START, true);
  EXPECT_TRUE(session().playback().running);
}

TEST_F(UiGamepad, AKeyAndAButtonHoldTogether) {
  hold(kKeyRight);
  frames(1);
  button(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, true);
  let_go(kKeyRight);
  frames(1);
  EXPECT_TRUE(held().right) << "the button still holds it";
  button(SDL_CONTROLLER_BUTTON_DPAD_RIGHT, false);
  EXPECT_FALSE(held().right);
}

TEST_F(UiGamepad, TheSettingsTakeAnotherButton) {
  key(ctrl(','));
  frames(3);
  click("settings/pad_jump1");
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
  EXPECT_FALSE(held().jump) << "the press only chose it";
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, false);
  EXPECT_EQ(app().ui().view.preferences.pad.jump[1], "leftshoulder");
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, true);
  EXPECT_TRUE(held().jump);
  button(SDL_CONTROLLER_BUTTON_LEFTSHOULDER, false);
  click("settings/pad_jump1");
  frames(2);
  click("settings/pad_jump1");
  EXPECT_EQ(app().ui().view.preferences.pad.jump[1], "") << "a second press leaves it empty";
  start(path("level.talus.json"));
  EXPECT_EQ(app().ui().view.preferences.pad.jump[1], "") << "it is remembered";
}

TEST_F(UiGamepad, WhenTheWindowIsLeftNothingIsHeld) {
  button(SDL_CONTROLLER_BUTTON_DPAD_LEFT, true);
  EXPECT_TRUE(held().left);
  SDL_Event event{};
  event.type = SDL_WINDOWEVENT;
  event.window.event = SDL_WINDOWEVENT_FOCUS_LOST;
  ASSERT_EQ(SDL_PushEvent(&event), 1);
  frames(1);
  EXPECT_FALSE(held().left);
}

}  // namespace talus::gamepad_ui_test
