// The layers of a map in the window: all are drawn, one is painted on, and the panel lists them.
#include "edit/layer_tools.h"
#include "golden_harness.h"
#include "harness.h"
#include "overlay/overlay.h"
#include "platform/asset_path.h"
#include "unit/pictured_level.h"

namespace talus::layers_ui_test {

constexpr int kBack = 0, kLand = 1, kFront = 2;

// test_level() with its tiles in "middle", which is chosen, between "back" and "front". Tile 1 has colour 13;
// tile 7 has colour 4, and colour 0 in its upper half.
Level layered_level(Level level) {
  TileImage& half = level.sheet(SheetId::tiles).images[7];
  for (std::size_t pixel = half.size() / 2; pixel < half.size(); ++pixel) half[pixel] = 4;
  const std::vector<TileNumber> empty(level.map.cells().size());
  const auto with = [&](Cell cell, TileNumber tile) {
    std::vector<TileNumber> cells = empty;
    cells[static_cast<std::size_t>(cell.y) * level.map.width() + cell.x] = tile;
    return std::make_shared<const MapCells>(std::move(cells));
  };
  level.layers.list = {{.name = "back", .is_ground = false, .cells = with({10, 5}, 1)},
                       {.name = "middle"},
                       {.name = "front", .is_ground = false, .cells = with({10, 5}, 7)}};
  level.layers.chosen = kLand;
  return level;
}

class UiLayers : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    const std::string file = path("level.talus.json");
    ASSERT_TRUE(save_level(layered_level(test_level()), *find_format("native"), file));
    start(file);
    session().apply(action::Pause{});
    click(on_sheet(1));
    key(kKeyF3);
    key('1');
    click("tabs/layers");
    frames(2);
  }
  const TileLayers& layers() { return level().layers; }
  const TileLayer& layer(int index) { return layers().list[static_cast<std::size_t>(index)]; }
  std::string names() {
    std::string text;
    for (const TileLayer& each : layers().list) text += (text.empty() ? "" : " ") + each.name;
    return text;
  }
  TileNumber tile_in(int index, Cell cell) {
    return level().cells_of(index).tiles()[static_cast<std::size_t>(cell.y) * level().map.width() + cell.x];
  }
  ImVec2 row(int index) { return centre("layers/" + std::to_string(index)); }
  std::string mark(int index, const std::string& name) {
    return "layers/" + std::to_string(index) + "/" + name;
  }
  std::string label() { return session().history().edits().back().label; }

  // The colour of a place of the window, 0..15; -1 if it is none of the palette's.
  int color_at(ImVec2 place) {
    move({2, 2});
    frames(2);
    const std::string taken = path("window.png");
    EXPECT_TRUE(app().screenshot(taken));
    const Picture picture = load_picture(taken);
    const std::size_t at = 4 * (static_cast<std::size_t>(place.y) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(place.x));
    const Rgb color{picture.rgba[at], picture.rgba[at + 1], picture.rgba[at + 2]};
    const auto found = std::find(level().palette.begin(), level().palette.end(), color);
    return found == level().palette.end() ? -1 : static_cast<int>(found - level().palette.begin());
  }
  // Places in cell (10,5) of a canvas.
  ImVec2 upper(const std::string& canvas) { return on_canvas(canvas, {84, 42}); }
  ImVec2 lower(const std::string& canvas) { return on_canvas(canvas, {84, 46}); }
  void set_looks(int index, TileLayer looks) {
    session().apply(action::EditLevel{set_layer_looks(level(), index, std::move(looks))});
    frames(2);
  }
};

TEST_F(UiLayers, AreDrawnFromTheBackToTheFront) {
  for (const char* canvas : {"map", "play"}) {
    EXPECT_EQ(color_at(upper(canvas)), 13) << "colour 0 in front is clear, on the " << canvas;
    EXPECT_EQ(color_at(lower(canvas)), 4) << canvas;
    EXPECT_EQ(color_at(on_canvas(canvas, {84, 130})), 13) << "the floor of the middle one";
  }
  click(mark(kFront, "eye"));
  EXPECT_EQ(color_at(lower("map")), 13);
  click(mark(kBack, "eye"));
  EXPECT_EQ(color_at(lower("map")), 0);
}

TEST_F(UiLayers, HaveTheirOffsetOpacityAndTint) {
  TileLayer looks = layer(kFront);
  looks.offset = {16, 0};
  set_looks(kFront, looks);
  EXPECT_EQ(color_at(lower("map")), 13);
  EXPECT_EQ(color_at(on_canvas("map", {84 + 16, 46})), 4);
  looks.tint = {0, 0, 0};
  set_looks(kFront, looks);
  EXPECT_EQ(color_at(on_canvas("map", {84 + 16, 46})), -1) << "black";
  looks.opacity = 0;
  set_looks(kFront, looks);
  EXPECT_EQ(color_at(on_canvas("map", {84 + 16, 46})), 0);
}

TEST_F(UiLayers, MoveWithTheViewInPlayOnly) {
  TileLayer looks = layer(kFront);
  looks.parallax = {0, 1};  // the map's left side is in the middle of the view
  set_looks(kFront, looks);
  EXPECT_EQ(color_at(lower("map")), 4);
  EXPECT_EQ(color_at(lower("play")), 13);
}

TEST_F(UiLayers, EndWithTheMap) {
  const Vec2 size{level().map.px_width(), level().map.px_height()};
  const Vec2 beside{size.x + 4, 46};
  TileLayer looks = layer(kFront);
  looks.offset = {size.x - 80, 0};  // its tile lies beside the map now
  set_looks(kFront, looks);
  session().apply(action::ChooseLayer{0});
  frames(2);
  EXPECT_NE(color_at(on_canvas("map", beside)), 4);
  EXPECT_NE(color_at(on_canvas("play", beside)), 4);
  session().apply(action::ChooseLayer{kFront});
  frames(2);
  EXPECT_EQ(color_at(on_canvas("map", beside)), 4) << "the layer that is painted on is whole";
  EXPECT_NE(color_at(on_canvas("play", beside)), 4);
}

TEST_F(UiLayers, AreDrawnFarAway) {
  const std::string file = path("large.talus.json");
  Level large = test_level();
  large.map = TileMap(2000, 1500);
  std::vector<TileNumber> front(large.map.cells().size());
  std::fill(front.begin(), front.begin() + static_cast<std::ptrdiff_t>(front.size() / 2), TileNumber{1});
  large.layers.list = {{}, {.cells = std::make_shared<const MapCells>(std::move(front))}};
  ASSERT_TRUE(save_level(large, *find_format("native"), file));
  start(file);
  ASSERT_TRUE(frames_until([&] { return level().map.width() == 2000; }));
  session().apply(action::Pause{});
  key(kKeyF3);
  key(kKeyTab);  // the world view
  frames(30);
  EXPECT_EQ(color_at(on_canvas("map", {8000, 3000})), 13);
  EXPECT_EQ(color_at(on_canvas("map", {8000, 9000})), 0);
}

TEST_F(UiLayers, PagesChooseTheOneToPaintOn) {
  EXPECT_EQ(layers().chosen, kLand);
  key(kKeyPageUp);
  EXPECT_EQ(layers().chosen, kFront);
  key(kKeyPageUp);
  EXPECT_EQ(layers().chosen, kFront) << "there is no other";
  click(on_map({3, 3}));
  EXPECT_EQ(tile_in(kFront, {3, 3}), 1);
  EXPECT_EQ(tile_in(kLand, {3, 3}), 0);
  key(kKeyPageDown);
  key(kKeyPageDown);
  EXPECT_EQ(layers().chosen, kBack);
  EXPECT_EQ(session().history().edits().size(), 1u) << "choosing is no edit";
  key(ctrl('z'));
  EXPECT_EQ(tile_in(kFront, {3, 3}), 0);
  EXPECT_EQ(layers().chosen, kFront) << "undo shows where it happened";
}

TEST_F(UiLayers, ARowIsChosenByAClick) {
  EXPECT_LT(row(kFront).y, row(kBack).y) << "the front one is on top, as in Tiled";
  click(row(kBack));
  EXPECT_EQ(layers().chosen, kBack);
  click(row(kFront));
  EXPECT_EQ(layers().chosen, kFront);
}

TEST_F(UiLayers, ALockedOrHiddenOneIsNotPainted) {
  click(mark(kLand, "lock"));
  EXPECT_EQ(label(), "Lock layer");
  click(on_map({3, 3}));
  EXPECT_EQ(tile_in(kLand, {3, 3}), 0);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text,
            "The layer \"middle\" is locked: unlock it under Layers to paint on it.");
  click(mark(kLand, "lock"));
  click(mark(kLand, "eye"));
  click(on_map({3, 3}));
  EXPECT_EQ(tile_in(kLand, {3, 3}), 0);
  EXPECT_EQ(session().message()->text,
            "The layer \"middle\" is hidden: show it under Layers to paint on it.");
  click(mark(kLand, "eye"));
  click(on_map({3, 3}));
  EXPECT_EQ(tile_in(kLand, {3, 3}), 1);
}

TEST_F(UiLayers, TheGroundMarkMakesGround) {
  EXPECT_EQ(session().state().bodies.size(), 1u);
  click(mark(kLand, "ground"));
  EXPECT_FALSE(layer(kLand).is_ground);
  EXPECT_EQ(session().state().bodies.size(), 0u) << "its ball is only drawn now";
  click(mark(kLand, "ground"));
  EXPECT_EQ(session().state().bodies.size(), 1u);
}

TEST_F(UiLayers, ObjectsHaveRowsWithMarks) {
  Level with = level();
  ObjectLayer walls{.name = "walls"};
  walls.objects = {{.name = "rock", .position = {26, 26}, .size = {37, 13}}};
  with.objects = {walls};
  with.tuning.solver = SolverKind::exact;
  const std::string file = path("objects.talus.json");
  ASSERT_TRUE(save_level(with, *find_format("native"), file));
  session().apply(action::OpenFile{file});
  frames(3);
  EXPECT_EQ(session().scene().ground_lines, 0u);
  click("layers/objects/0/ground");
  EXPECT_TRUE(level().objects[0].is_ground);
  EXPECT_EQ(label(), "Make objects ground");
  EXPECT_GT(session().scene().ground_lines, 0u);
  click("layers/objects/0/eye");
  EXPECT_FALSE(level().objects[0].visible);
  click("layers/objects/0/lock");
  EXPECT_TRUE(level().objects[0].locked);
  key(ctrl('z'));
  key(ctrl('z'));
  key(ctrl('z'));
  EXPECT_FALSE(level().objects[0].is_ground);
}

TEST_F(UiLayers, FlagsAreFoundInAllOfThemOrInTheChosenOne) {
  session().apply(action::SetFlagOverlay{pattern_of_flag(0)});
  move({2, 2});
  frames(2);
  key(ctrl('g'));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{10, 5})) << "in the layer at the back";
  key(ctrl('g'));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{0, 16}));
  click("tabs/flag_search");
  frames(2);
  click("flag_search/chosen_layer");
  frames(2);
  key(ctrl_shift('g'));
  EXPECT_EQ(app().ui().view.canvas.marked_cell, (Cell{29, 16})) << "around the end";
}

// The fields are about the layer that was chosen last, of either kind.
TEST_F(UiLayers, LooksOfObjectsAndPicturesAreTypedAndUndone) {
  Level with = level();
  ObjectLayer sky{.name = "sky"};
  sky.image = LayerImage{.path = "sky.png", .part = plain_part(16, 16, with.palette[9])};
  with.objects = {{.name = "walls"}, sky};
  const std::string file = path("looks.talus.json");
  ASSERT_TRUE(save_level(with, *find_format("native"), file));
  session().apply(action::OpenFile{file});
  frames(3);
  const auto put = [&](const std::string& field, const std::string& text) {
    const ImVec2 at = centre("layers/" + field);
    click(at);
    click(at);
    key(ctrl('a'));
    type(text);
    key(KeyChord{'\r'});
    frames(2);
  };
  click("layers/objects/1");
  frames(2);
  put("offset_x", "80");
  put("offset_y", "40");
  move(centre("layers/offset_x"));
  wheel(-9);  // the panel is low
  frames(2);
  put("parallax_x", "0.5");
  EXPECT_EQ(level().objects[1].offset, (Vec2{80, 40}));
  EXPECT_EQ(level().objects[1].parallax, (Vec2{0.5, 1}));
  EXPECT_EQ(label(), "Change a layer's parallax");
  EXPECT_EQ(color_at(upper("map")), 9) << "the picture is drawn there now";
  move(centre("layers/offset_x"));
  wheel(9);
  frames(2);
  click("layers/objects/0");
  frames(2);
  put("offset_x", "3");
  EXPECT_EQ(level().objects[0].offset, (Vec2{3, 0}));
  EXPECT_EQ(level().objects[1].offset, (Vec2{80, 40}));
  click("layers/" + std::to_string(kFront));
  frames(2);
  put("offset_x", "5");
  EXPECT_EQ(layer(kFront).offset, (Vec2{5, 0}));
  EXPECT_EQ(level().objects[0].offset, (Vec2{3, 0}));
  for (int i = 0; i < 5; ++i) key(ctrl('z'));
  EXPECT_EQ(level().objects, with.objects);
  EXPECT_EQ(layer(kFront).offset, Vec2());
}

TEST_F(UiLayers, PicturesAreDrawnInTheirOrder) {
  Level with = level();
  ObjectLayer sky{.name = "sky", .offset = {80, 40}};
  sky.image = LayerImage{.path = "sky.png", .part = plain_part(16, 16, with.palette[9])};
  with.objects = {sky};
  const std::string file = path("pictures.talus.json");
  ASSERT_TRUE(save_level(with, *find_format("native"), file));
  session().apply(action::OpenFile{file});
  frames(3);
  EXPECT_EQ(color_at(upper("map")), 9);
  EXPECT_EQ(color_at(upper("play")), 9);
  session().apply(action::EditLevel{move_in_order(level(), 3, 0)});
  frames(2);
  EXPECT_EQ(level().objects[0].place, 0);
  EXPECT_EQ(label(), "Move layer");
  EXPECT_EQ(color_at(upper("map")), 13) << "it is behind the tiles";
  EXPECT_EQ(color_at(on_canvas("map", {90, 50})), 9);
}

// A texture has at most 16,384 px a side on most machines.
TEST_F(UiLayers, APictureMayBeLongerThanATexture) {
  Level with = level();
  ObjectLayer sky{.name = "sky", .offset = {80, 40}};
  sky.image = LayerImage{.path = "sky.png", .part = plain_part(40'000, 16, with.palette[9])};
  with.objects = {sky};
  const std::string file = path("long.talus.json");
  ASSERT_TRUE(save_level(with, *find_format("native"), file));
  session().apply(action::OpenFile{file});
  frames(3);
  ASSERT_EQ(level().objects.size(), 1u);
  EXPECT_EQ(level().objects[0].image->part.width, 40'000);
  EXPECT_EQ(color_at(upper("map")), 9);
}

TEST_F(UiLayers, AnimatedTilesPlay) {
  Level with = level();
  with.animations[7] = {{7, 100}, {1, 100}};
  const std::string file = path("animated.talus.json");
  ASSERT_TRUE(save_level(with, *find_format("native"), file));
  session().apply(action::OpenFile{file});
  session().apply(action::Pause{});
  frames(3);
  EXPECT_EQ(color_at(lower("play")), 4);
  for (int frame = 0; frame < 6; ++frame) session().apply(action::StepFrame{});
  EXPECT_EQ(color_at(lower("play")), 13) << "after 100 ms it shows tile 1";
  EXPECT_EQ(color_at(lower("map")), 4) << "the map shows the tile that was painted";
  for (int frame = 0; frame < 6; ++frame) session().apply(action::StepBack{});
  EXPECT_EQ(color_at(lower("play")), 4);
}

TEST_F(UiLayers, AreOrderedByADrag) {
  drag(row(kFront), {row(kBack).x, find("layers/0")->max.y - 2});
  EXPECT_EQ(names(), "front back middle");
  EXPECT_EQ(label(), "Move layer");
  EXPECT_EQ(layer(layers().chosen).name, "middle");
  key(ctrl('z'));
  EXPECT_EQ(names(), "back middle front");
  drag(row(kBack), {row(kLand).x, find("layers/1")->min.y + 2});
  EXPECT_EQ(names(), "middle back front");
}

TEST_F(UiLayers, EscapeCancelsADrag) {
  move(row(kFront));
  press();
  move(row(kLand));
  move(row(kBack));
  key(kKeyEscape);
  release();
  EXPECT_EQ(names(), "back middle front");
}

TEST_F(UiLayers, ADoubleClickRenames) {
  click(row(kBack));
  click(row(kBack));
  frames(3);
  ASSERT_NE(find("layers/name"), nullptr);
  type("sky");
  EXPECT_EQ(layer(kBack).name, "back") << "the name does not change while it is typed";
  key('\r');
  frames(2);
  EXPECT_EQ(layer(kBack).name, "sky");
  EXPECT_EQ(find("layers/name"), nullptr);
}

TEST_F(UiLayers, AKeyRenamesAndEscapeCancels) {
  key(ctrl_shift('n'));
  frames(3);
  ASSERT_NE(find("layers/name"), nullptr);
  type("sky");
  key(kKeyEscape);
  frames(2);
  EXPECT_EQ(names(), "back middle front");
  EXPECT_EQ(find("layers/name"), nullptr);
}

TEST_F(UiLayers, ButtonsAddCopyMergeAndDelete) {
  click("layers/add_button");
  EXPECT_EQ(names(), "back middle Layer 4 front");
  EXPECT_EQ(layer(layers().chosen).name, "Layer 4");
  click(on_map({3, 15}));
  click("layers/duplicate_button");
  EXPECT_EQ(names(), "back middle Layer 4 Layer 4 copy front");
  EXPECT_EQ(tile_in(3, {3, 15}), 1);
  click("layers/delete_button");
  EXPECT_EQ(names(), "back middle Layer 4 front");
  click("layers/merge_down_button");
  EXPECT_EQ(names(), "back middle front");
  EXPECT_EQ(tile_in(kLand, {3, 15}), 1);
  click("layers/backwards_button");
  EXPECT_EQ(names(), "middle back front");
  click("layers/forwards_button");
  EXPECT_EQ(names(), "back middle front");
  for (int i = 0; i < 7; ++i) key(ctrl('z'));
  EXPECT_EQ(level(), layered_level(test_level()));
}

TEST_F(UiLayers, ALockedOneIsNotMerged) {
  click(mark(kBack, "lock"));
  click("layers/merge_down_button");
  EXPECT_EQ(names(), "back middle front");
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text,
            "The layer \"back\" is locked: unlock it under Layers to merge the two.");
}

TEST_F(UiLayers, ADragOfTheOpacityIsOneUndo) {
  const Widget* slider = find("layers/opacity");
  ASSERT_NE(slider, nullptr);
  const float y = (slider->min.y + slider->max.y) / 2;
  drag({slider->max.x - 4, y}, {(slider->min.x + slider->max.x) / 2, y});
  EXPECT_NEAR(layer(kLand).opacity, 0.5, 0.05);
  EXPECT_EQ(session().history().edits().size(), 1u);
  EXPECT_EQ(label(), "Change a layer's opacity");
}

TEST_F(UiLayers, NumbersOfTheOffsetAreTyped) {
  click("layers/offset_x");
  click("layers/offset_x");
  key(ctrl('a'));
  type("12");
  key('\r');
  EXPECT_EQ(layer(kLand).offset.x, 12);
  EXPECT_EQ(label(), "Change a layer's offset");
}

TEST_F(UiLayers, TheStatusBarNamesTheChosenOneOfSeveral) {
  EXPECT_NE(find("status/layer"), nullptr);
  start();
  EXPECT_EQ(find("status/layer"), nullptr);
}

TEST_F(UiLayers, TheStatusBarOfANarrowWindowShowsWhatMattersWhole) {
  start(asset_path("platformer/meadow.tmx"), 900, 600);
  frames(3);
  const Widget *layer = find("status/layer"), *problems = find("status/problems");
  ASSERT_TRUE(layer != nullptr && problems != nullptr);
  EXPECT_LT(layer->max.x, problems->min.x);
  EXPECT_LE(problems->max.x, 900);
}

TEST_F(UiLayers, ShapesOfAllGroundAreDrawn) {
  key(kKeyPageUp);
  session().apply(action::SetOverlay{&overlay::shapes, true});
  EXPECT_NE(color_at(on_canvas("play", {84, 130})), 13) << "the floor is tinted, though another is chosen";
}

}  // namespace talus::layers_ui_test
