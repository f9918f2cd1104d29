// Bodies placed by hand: placed, moved, given a velocity by an arrow, named, copied and removed.
#include "harness.h"

namespace talus::spawn_test {

class UiSpawn : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
    key(kKeyF3);
    click("map/body");
  }
  const Spawn& spawn(std::size_t i = 0) { return level().spawns.at(i); }
};

TEST_F(UiSpawn, ArrowOfABodyAtRestIsPulledToAVelocity) {
  click(on_canvas("map", {100, 60}));
  ASSERT_EQ(level().spawns.size(), 1u);
  EXPECT_EQ(spawn().velocity, Vec2{});
  const Widget* handle = find("map/velocity_handle");
  ASSERT_NE(handle, nullptr);
  const ImVec2 from = handle->centre(), zero = on_canvas("map", {0, 0}), at = on_canvas("map", {12, -8});
  drag(from, {from.x + at.x - zero.x, from.y + at.y - zero.y});
  EXPECT_EQ(spawn().velocity, (Vec2{3, -2}));
  EXPECT_EQ(spawn().position, (Vec2{96, 56})) << "the body stays";
  EXPECT_EQ(session().history().edits().size(), 2u) << "a pull is one undo";
  const ImVec2 tip = centre("map/velocity_handle"), wanted = on_canvas("map", {112, 52});
  EXPECT_NEAR(tip.x, wanted.x, 2) << "the arrow is 4 px long for each px/frame";
  EXPECT_NEAR(tip.y, wanted.y, 2);
  key(ctrl('z'));
  EXPECT_EQ(spawn().velocity, Vec2{});
}

TEST_F(UiSpawn, BodyIsMovedNamedAndCopied) {
  click(on_canvas("map", {100, 60}));
  drag(on_canvas("map", {100, 60}), on_canvas("map", {131, 53}));
  EXPECT_EQ(spawn().position, (Vec2{127, 49}));
  click("inspector/spawn_name");
  type("hero");
  key(KeyChord{'\r'});
  EXPECT_EQ(spawn().name, "hero");
  key(kKeyF3);
  key(ctrl('d'));
  ASSERT_EQ(level().spawns.size(), 2u);
  EXPECT_EQ(spawn(1).position, (Vec2{135, 49}));
  EXPECT_EQ(spawn(1).name, "hero");
  key(kKeyDelete);
  ASSERT_EQ(level().spawns.size(), 1u) << "the copy was chosen";
  EXPECT_EQ(spawn().position, (Vec2{127, 49}));
}

TEST_F(UiSpawn, EscapePutsABodyBack) {
  const auto cancel_drag = [&](ImVec2 from, Vec2 to) {
    move(from);
    press();
    move(on_canvas("map", to));
    key(kKeyEscape);
    release();
  };
  click(on_canvas("map", {100, 60}));
  cancel_drag(on_canvas("map", {100, 60}), {131, 53});
  EXPECT_EQ(spawn().position, (Vec2{96, 56}));
  cancel_drag(centre("map/velocity_handle"), {120, 40});
  EXPECT_EQ(spawn().velocity, Vec2{});
  cancel_drag(on_canvas("map", {40, 60}), {60, 60});
  EXPECT_EQ(level().spawns.size(), 1u) << "the body that the press put there is gone";
  EXPECT_EQ(session().history().position(), 1u);
}

TEST_F(UiSpawn, StartIsTypedAsNumbers) {
  click(on_canvas("map", {100, 60}));
  const auto set = [&](const char* field, const char* text) {
    click(field);
    click(field);  // the second click of a double click
    key(ctrl('a'));
    type(text);
    key(KeyChord{'\r'});
  };
  set("inspector/start_x", "33.5");
  set("inspector/start_vy", "-1.25");
  EXPECT_EQ(spawn().position, (Vec2{33.5, 56}));
  EXPECT_EQ(spawn().velocity, (Vec2{0, -1.25}));

  for (const auto& [part, number] : {std::pair{"x", "1e99"}, {"y", "-16777217"}, {"vx", "1e999"}}) {
    session().apply(action::DismissMessage{});
    set((std::string("inspector/start_") + part).c_str(), number);
    ASSERT_TRUE(session().message()) << number;
    EXPECT_EQ(session().message()->text,
              "Not changed: " + std::string(part) + " must be a number from -16777216 to 16777216.");
  }
  EXPECT_EQ(spawn().position, (Vec2{33.5, 56}));
  EXPECT_EQ(spawn().velocity, (Vec2{0, -1.25}));
  EXPECT_EQ(session().history().edits().size(), 3u);
}

}  // namespace talus::spawn_test
