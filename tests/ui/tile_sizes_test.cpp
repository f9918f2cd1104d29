// Levels whose tiles are not 8x8 px, in the window: what is pointed at, painted, drawn, placed and searched.
#include "harness.h"
#include "level/single_change.h"
#include "level/tile_color.h"
#include "overlay/overlay.h"
#include "panels/window/status_panel.h"

namespace talus::tile_sizes_ui_test {

constexpr TileSize kTile{18, 12};

// test_level() with other tiles: solid tile 1, and a floor in row 16.
class UiTileSizes : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    Level level = test_level();
    TileMap map(level.map.width(), level.map.height(), kTile);
    map.cells() = level.map.cells();
    map.set({5, 10}, 0);  // the ball
    level.map = std::move(map);
    level.tuning = new_tuning(kTile);
    level.tuning.solver = SolverKind::exact;
    ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
    start(path("level.talus.json"));
    ASSERT_EQ(this->level().map.tile_size(), kTile);
    click(on_sheet(1));
    key(kKeyF3);
  }
  const Hover& hover() { return app().ui().view.canvas.hover; }
};

TEST_F(UiTileSizes, TheWholeFirstScreenIsShown) {
  const Widget* canvas = find("map/canvas");
  for (const Cell corner : {Cell{0, 0}, Cell{29, 16}}) {
    const ImVec2 at = on_map(corner);
    EXPECT_GT(at.x, canvas->min.x);
    EXPECT_GT(at.y, canvas->min.y);
    EXPECT_LT(at.x, canvas->max.x);
    EXPECT_LT(at.y, canvas->max.y);
  }
}

TEST_F(UiTileSizes, CellsArePaintedWhereTheMouseIs) {
  key('1');
  click(on_map({7, 3}));
  EXPECT_EQ(tile_at({7, 3}), 1);
  EXPECT_EQ(session().history().position(), 1u);
  key('6');
  move(on_map({10, 4}));
  press();
  move(on_map({12, 5}));
  EXPECT_EQ(hover().dragged, (Cell{3, 2}));
  EXPECT_NE(hover_text(session(), hover()).find("3x2 cells, 54x24 px"), std::string::npos)
      << hover_text(session(), hover());
  release();
  for (int x = 10; x <= 12; ++x)
    for (int y = 4; y <= 5; ++y) EXPECT_EQ(tile_at({x, y}), 1) << x << ", " << y;
  EXPECT_EQ(tile_at({13, 5}), 0);
  EXPECT_EQ(tile_at({12, 6}), 0);
}

TEST_F(UiTileSizes, TheKeyboardsCursorGoesFromCellToCell) {
  key(kKeyEnter);
  frames(2);
  ASSERT_TRUE(hover().cell);
  const Cell at = *hover().cell;
  key(kKeyRight);
  key(kKeyUp);
  frames(2);
  EXPECT_EQ(hover().cell, (Cell{at.x + 1, at.y - 1}));
  EXPECT_EQ(hover().pixel, level().map.box_of({at.x + 1, at.y - 1}).center());
}

TEST_F(UiTileSizes, APlacedPlayerIsATileLargeAndStandsOnTheFloor) {
  key('0');
  click(on_map({5, 12}));
  frames(2);
  click("map/first_body_player");
  frames(2);
  ASSERT_EQ(level().spawns.size(), 1u);
  EXPECT_EQ(level().spawns[0].position, (Vec2{5.0 * 18, 12.0 * 12}));
  EXPECT_EQ(level().spawns[0].size, new_body_size(BodyKind::player, kTile));
  for (int i = 0; i < 200; ++i) session().apply(action::StepFrame{});
  frames(2);
  const Rect box = session().state().bodies.back().box;
  EXPECT_NEAR(box.bottom(), 16.0 * 12, 0.01);
}

TEST_F(UiTileSizes, TheReachIsDrawnInCellsOfTheLevel) {
  key('0');
  click(on_map({5, 12}));
  frames(2);
  click("map/first_body_player");
  frames(2);
  key(kKeyF12);
  for (int i = 0; i < 2000 && session().reach().running(); ++i) frames();
  ASSERT_NE(session().reach().found(), nullptr);
  EXPECT_TRUE(session().reach().found()->reached({5, 15}));
  OverlaySet reach;
  reach.set(overlay::reach, true);
  const OverlayDrawing drawing =
      make_overlays({.scene = session().scene(),
                     .state = session().state(),
                     .record = session().record(),
                     .level = &level(),
                     .reach = session().reach().found()},
                    reach, {0, 0, level().map.px_width(), level().map.px_height()});
  ASSERT_FALSE(drawing.boxes.empty());
  double area = 0;
  for (const OverlayBox& box : drawing.boxes) area += box.box.w * box.box.h;
  EXPECT_EQ(area, 18.0 * 12 * static_cast<double>(session().reach().found()->cells()));
}

TEST_F(UiTileSizes, AShapeIsAsHighAsTheTile) {
  session().apply(action::EditLevel{
      single_change("Change the shape of tile 9",
                    TileShapeChange{9, {}, {.kind = TileShape::Kind::slope, .heights = {0, 12}}})});
  click(on_sheet(9));
  click("tabs/shape");
  frames(2);
  const Widget* left = find("shape/handle0");
  const Widget* right = find("shape/handle1");
  ASSERT_NE(left, nullptr);
  ASSERT_NE(right, nullptr);
  const double zoom = (right->centre().x - left->centre().x) / 18;
  EXPECT_NEAR(left->centre().y - right->centre().y, 12 * zoom, 0.5);
}

TEST_F(UiTileSizes, ANewLevelHasTheTypedSizes) {
  const auto set = [&](const char* field, const char* text) {
    click(field);
    key(ctrl('a'));
    type(text);
    key(kKeyTab);
    frames(2);
  };
  app().ui().view.level.new_level_open = true;
  frames(3);
  click("new_level/tile32");
  set("new_level/tile_height", "300");
  EXPECT_FALSE(find("new_level/apply")->enabled);
  set("new_level/tile_height", "24");
  set("new_level/width", "50");
  set("new_level/height", "20");
  click("new_level/plays");  // not
  click("new_level/apply");
  frames(3);
  EXPECT_EQ(level().map.tile_size(), (TileSize{32, 24}));
  EXPECT_EQ(level().map.width(), 50);
  EXPECT_EQ(level().map.height(), 20);
  EXPECT_EQ(level().tuning, new_tuning({32, 24}));
  EXPECT_FALSE(app().ui().view.level.new_level_open);
}

TEST_F(UiTileSizes, ANewLevelHasGroundAndAPlayer) {
  app().ui().view.level.new_level_open = true;
  frames(3);
  click("new_level/tile16");
  EXPECT_FALSE(find("new_level/true_colour")->enabled) << "a palette is for tiles of 8x8 px";
  click("new_level/apply");
  frames(3);
  EXPECT_EQ(level().map.tile_size(), (TileSize{16, 16}));
  const auto plays = [](const Spawn& spawn) { return spawn.kind == BodyKind::player; };
  EXPECT_TRUE(std::any_of(level().spawns.begin(), level().spawns.end(), plays));
  EXPECT_EQ(find("pixels/canvas"), nullptr) << "its tiles are drawn already";
  EXPECT_FALSE(is_blank(level(), session().choices().stamp.tiles[0].tile)) << "one paints at once";
}

TEST_F(UiTileSizes, ANewLevelIsDrawnAtTheSizeOfItsTiles) {
  app().ui().view.level.new_level_open = true;
  frames(3);
  click("new_level/tile16");
  click("new_level/plays");  // not
  click("new_level/apply");
  frames(3);
  ASSERT_NE(find("pixels/canvas"), nullptr) << "its tiles wait to be drawn";
  click(on_sheet(1));
  frames(2);
  const SpriteArea& area = session().choices().area;
  EXPECT_EQ(area.tile, (TileSize{16, 16}));
  click("pixels/size32");
  EXPECT_EQ(area.tiles, (CellRect{1, 0, 2, 2})) << "the buttons mean tiles";
  click("pixels/size16");
  click(on_sheet(1));
  frames(2);
  click(on_pixels(15, 15));
  frames(2);
  EXPECT_EQ(rgba_of(pixel_at(level(), area, 15, 15)), session().choices().rgba);
  EXPECT_FALSE(session().question()) << "the pixels are the level's own";
}

}  // namespace talus::tile_sizes_ui_test
