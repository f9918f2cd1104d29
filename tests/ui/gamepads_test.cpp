// Gamepads that are plugged in and out: one that SDL makes up.
#include "platform/gamepads.h"

#include <gtest/gtest.h>

namespace talus::gamepads_test {

class PluggedGamepads : public ::testing::Test {
 protected:
  void SetUp() override { gamepads_.watch(); }
  void TearDown() override { plug_out(); }
  void plug_in() {
    index_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_GAMECONTROLLER, SDL_CONTROLLER_AXIS_MAX,
                                       SDL_CONTROLLER_BUTTON_MAX, 0);
    ASSERT_GE(index_, 0) << SDL_GetError();
    follow_all();
  }
  void plug_out() {
    if (index_ >= 0) SDL_JoystickDetachVirtual(index_);
    index_ = -1;
    follow_all();
  }
  void follow_all() {
    SDL_Event event;
    while (SDL_PollEvent(&event)) gamepads_.follow(event);
  }
  void press(SDL_GameControllerButton button, bool down) {
    SDL_Joystick* joystick = SDL_JoystickOpen(index_);
    ASSERT_EQ(SDL_JoystickSetVirtualButton(joystick, button, down ? SDL_PRESSED : SDL_RELEASED), 0);
    SDL_JoystickUpdate();
    follow_all();
    SDL_JoystickClose(joystick);
  }

  Gamepads gamepads_;
  int index_ = -1;
};

TEST_F(PluggedGamepads, AreFoundAndLost) {
  EXPECT_TRUE(gamepads_.names().empty());
  plug_in();
  EXPECT_EQ(gamepads_.names().size(), 1u);
  plug_out();
  EXPECT_TRUE(gamepads_.names().empty());
}

TEST_F(PluggedGamepads, HoldWhatIsPressedUntilTheyArePulledOut) {
  plug_in();
  press(SDL_CONTROLLER_BUTTON_DPAD_LEFT, true);
  EXPECT_TRUE(gamepads_.held({}).left);
  press(SDL_CONTROLLER_BUTTON_DPAD_LEFT, false);
  EXPECT_FALSE(gamepads_.held({}).left);
  press(SDL_CONTROLLER_BUTTON_A, true);
  EXPECT_TRUE(gamepads_.held({}).jump);
  plug_out();
  EXPECT_FALSE(gamepads_.held({}).jump) << "nothing is held by what is gone";
}

}  // namespace talus::gamepads_test
