// Bodies placed by hand: placed, moved, given a velocity by an arrow, named, copied and removed.
#include "edit/level_settings.h"
#include "edit/spawn_tools.h"
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
  // Places the first body of the level.
  // A level whose second row of tiles and sprites is drawn.
  void start_drawn() {
    Level drawn = test_level();
    for (Sheet& sheet : drawn.sheets)
      for (std::size_t image = 16; image < 32; ++image) sheet.images[image].fill(5);
    ASSERT_TRUE(save_level(drawn, *find_format("native"), path("drawn.talus.json")));
    start(path("drawn.talus.json"));
    key(kKeyF3);
    click("map/body");
  }
  void place_first(const char* kind = "player") {
    click(on_canvas("map", {100, 60}));
    frames(2);
    click(std::string("map/first_body_") + kind);
    frames(2);
  }
  const Spawn& spawn(std::size_t i = 0) { return level().spawns.at(i); }
};

TEST_F(UiSpawn, TheFirstBodyIsAskedForAlsoBesideOthers) {
  Spawn player;
  player.kind = BodyKind::player;
  player.position = {40, 40};
  session().apply(action::EditLevel{add_spawn(level(), player)});
  place_first("ball");
  ASSERT_EQ(level().spawns.size(), 2u);
  EXPECT_EQ(spawn(1).kind, BodyKind::ball);
  session().apply(action::SelectSpawn{-1});
  click(on_canvas("map", {160, 60}));
  ASSERT_EQ(level().spawns.size(), 3u) << "it is not asked again";
  EXPECT_EQ(spawn(2).kind, BodyKind::ball);
  session().apply(action::SelectSpawn{0});
  click(on_canvas("map", {200, 60}));
  ASSERT_EQ(level().spawns.size(), 4u);
  EXPECT_EQ(spawn(3).kind, BodyKind::player) << "the chosen one is copied";
}

TEST_F(UiSpawn, TheFirstBodyIsAskedForAndTheNextAreLikeIt) {
  click(on_canvas("map", {100, 60}));
  frames(2);
  EXPECT_TRUE(level().spawns.empty());
  ASSERT_NE(find("map/first_body_player"), nullptr);
  key(kKeyEscape);
  frames(2);
  EXPECT_TRUE(level().spawns.empty()) << "nothing was chosen";
  place_first("ball");
  ASSERT_EQ(level().spawns.size(), 1u);
  EXPECT_EQ(spawn().kind, BodyKind::ball);
  EXPECT_EQ(spawn().position, (Vec2{96, 56}));
  session().apply(action::SelectSpawn{-1});
  click(on_canvas("map", {140, 60}));
  ASSERT_EQ(level().spawns.size(), 2u);
  EXPECT_EQ(spawn(1).kind, BodyKind::ball);
  EXPECT_EQ(spawn(1).size, spawn(0).size);
}

TEST_F(UiSpawn, ArrowOfABodyAtRestIsPulledToAVelocity) {
  place_first();
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
  place_first();
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
  place_first();
  cancel_drag(on_canvas("map", {100, 60}), {131, 53});
  EXPECT_EQ(spawn().position, (Vec2{96, 56}));
  cancel_drag(centre("map/velocity_handle"), {120, 40});
  EXPECT_EQ(spawn().velocity, Vec2{});
  cancel_drag(on_canvas("map", {40, 60}), {60, 60});
  EXPECT_EQ(level().spawns.size(), 1u) << "the body that the press put there is gone";
  EXPECT_EQ(session().history().position(), 1u);
}

TEST_F(UiSpawn, StartIsTypedAsNumbers) {
  place_first();
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

TEST_F(UiSpawn, SizeIsDraggedByACorner) {
  place_first();
  const ImVec2 corner = centre("map/body_corner3");
  const Vec2 end = spawn().position + spawn().size;
  const ImVec2 box = on_canvas("map", {static_cast<float>(end.x), static_cast<float>(end.y)});
  EXPECT_GT(corner.x, box.x) << "outside of a small box, which is held by its middle";
  EXPECT_GT(corner.y, box.y);
  move(on_canvas("map", {100, 60}));
  wheel(2);
  frames(2);
  const Vec2 start = spawn().position, size = spawn().size;
  const ImVec2 zero = on_canvas("map", {0, 0}), at = on_canvas("map", {4, 6});
  const auto drag_corner = [&](const char* item, float x, float y) {
    const ImVec2 from = centre(item);
    drag(from, {from.x + x * (at.x - zero.x), from.y + y * (at.y - zero.y)});
    frames(2);
  };
  drag_corner("map/body_corner3", 1, 1);
  EXPECT_EQ(spawn().size, size + (Vec2{4, 6}));
  EXPECT_EQ(spawn().position, start) << "the opposite corner stays";
  key(ctrl('z'));
  EXPECT_EQ(spawn().size, size) << "a drag is one undo";
  drag_corner("map/body_corner0", -1, 0);
  EXPECT_EQ(spawn().size, size + (Vec2{4, 0}));
  EXPECT_EQ(spawn().position, start - (Vec2{4, 0}));
  drag_corner("map/body_corner0", 30, 30);
  EXPECT_EQ(spawn().size, (Vec2{1, 1})) << "it does not turn over";
}

TEST_F(UiSpawn, SizeIsTypedOverWhereTheBodyStands) {
  place_first();
  const double bottom = spawn().position.y + spawn().size.y;
  click("inspector/size_h");
  click("inspector/size_h");  // the second click of a double click
  key(ctrl('a'));
  type("20");
  key(KeyChord{'\r'});
  EXPECT_EQ(spawn().size.y, 20);
  EXPECT_EQ(spawn().position.y + spawn().size.y, bottom);
}

// Of tiles that are chosen on the sheet.
TEST_F(UiSpawn, AnActGetsThePictureOfTheChosenTiles) {
  start_drawn();
  place_first();
  session().apply(action::SelectTiles{{SheetId::tiles, {2, 1, 3, 1}}});
  frames(2);
  click("inspector/picture_run");
  frames(2);
  EXPECT_EQ(spawn().picture[BodyAct::run], (BodyFrames{18, 3}));
  EXPECT_EQ(spawn().picture.columns, 1);
  session().apply(action::SelectTiles{{SheetId::tiles, {0, 1, 1, 2}}});
  frames(2);
  click("inspector/picture_stand");
  frames(2);
  EXPECT_EQ(spawn().picture[BodyAct::stand].count, 0);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text,
            "A frame of this body has 1x1 tiles: choose one or more such frames, side by side.");
  click("inspector/no_picture_run");
  EXPECT_TRUE(spawn().picture.empty());
  key(ctrl('z'));
  EXPECT_EQ(spawn().picture[BodyAct::run].count, 3);
}

TEST_F(UiSpawn, APlayerOffersTheSolverThatItNeeds) {
  place_first();
  Tuning tuning = level().tuning;
  tuning.solver = SolverKind::bump;
  session().apply(action::EditLevel{set_tuning(level(), tuning)});
  frames(2);
  click("inspector/exact");
  frames(2);
  EXPECT_EQ(level().tuning.solver, SolverKind::exact);
  EXPECT_EQ(find("inspector/exact"), nullptr);
}

TEST_F(UiSpawn, NoActGetsAPictureOfBlankTiles) {
  place_first();
  for (const SheetId sheet : {SheetId::tiles, SheetId::sprites}) {
    session().apply(action::SelectTiles{{sheet, {2, 1, 3, 1}}});
    frames(2);
    click("inspector/picture_run");
    frames(2);
    EXPECT_TRUE(spawn().picture.empty()) << "the body could not be seen";
    ASSERT_TRUE(session().message());
    EXPECT_NE(session().message()->text.find("are blank: choose those of the body"), std::string::npos);
  }
}

TEST_F(UiSpawn, AnActGetsThePictureOfTheChosenSprites) {
  start_drawn();
  place_first();
  session().apply(action::SelectTiles{{SheetId::sprites, {2, 1, 3, 1}}});
  frames(2);
  click("inspector/picture_run");
  frames(2);
  EXPECT_EQ(spawn().picture.sheet, SheetId::sprites);
  EXPECT_EQ(spawn().picture[BodyAct::run], (BodyFrames{18, 3}));
  session().apply(action::SelectTiles{{SheetId::tiles, {2, 1, 1, 1}}});
  frames(2);
  click("inspector/picture_stand");
  frames(2);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "The frames of a body are on one sheet, and this one has sprites.");
}

}  // namespace talus::spawn_test
