// Polygons and groups in the shape editor: drawn, edited and cancelled with the mouse and by keys.
#include "harness.h"

#include <talus/collision/shape_forms.h>
#include "edit/polygon_tools.h"
#include "level/single_change.h"
#include "panels/tiles/edited_shape.h"

namespace talus::polygon_ui_test {

using Kind = TileShape::Kind;
using Points = std::vector<Vec2>;

TileShape polygon(Points points) { return {.kind = Kind::polygon, .points = std::move(points)}; }
const TileShape kTriangle = polygon({{0, 8}, {8, 0}, {8, 8}});

class UiPolygon : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
    open_tile(9);
  }
  void open_tile(int tile) {
    click(on_sheet(tile));
    click("tabs/shape");
    frames(2);
  }
  const TileShape& shape(int tile = 9) { return level().tile_shapes[static_cast<std::size_t>(tile)]; }
  std::size_t edits() { return session().history().edits().size(); }
  EditedShape edited() { return edited_shape(session(), app().ui().view); }
  // A place on the shape's canvas; px of the tile.
  ImVec2 at(Vec2 place) {
    const Widget* tile = find("shape/tile");
    if (!tile) {
      ADD_FAILURE() << "there is no canvas";
      return {0, 0};
    }
    const TileSize size = level().map.tile_size();
    const float x = (tile->max.x - tile->min.x) / static_cast<float>(size.width);
    return {tile->min.x + static_cast<float>(place.x) * x, tile->min.y + static_cast<float>(place.y) * x};
  }
  void click_at(Vec2 place, int button = kLeft) {
    click(at(place), button);
    frames(2);
  }
  void drag_at(Vec2 from, Vec2 to) {
    const ImVec2 start = at(from), end = at(to);
    drag(start, end);
    frames(2);
  }
  // Gives the tile a shape, as a file would.
  void put(const TileShape& shape, int tile = 9) {
    session().apply(action::EditLevel{
        single_change("Change the shape",
                      TileShapeChange{tile, level().tile_shapes[static_cast<std::size_t>(tile)], shape})});
    frames(2);
  }
  void choose_kind(const std::string& kind) {
    click("shape/kind");
    click("shape/kind_" + kind);
    frames(2);
  }
  void type_number(const std::string& field, const std::string& number) {
    click(field);
    click(field);  // a double click lets one type
    key(ctrl('a'));
    type(number);
    key(kKeyTab);
    frames(2);
  }
};

TEST_F(UiPolygon, BeginsAsTheOutlineOfTheOldShape) {
  choose_kind("slope");
  choose_kind("polygon");
  EXPECT_EQ(shape(), kTriangle);
  EXPECT_EQ(edits(), 2u);
  open_tile(3);
  choose_kind("polygon");
  EXPECT_EQ(shape(3), polygon({{0, 8}, {16, 0}, {16, 8}})) << "that of its flags";
  choose_kind("slope");
  EXPECT_EQ(shape(3), (TileShape{.kind = Kind::slope, .tiles = 2, .heights = {0, 8}}));
}

TEST_F(UiPolygon, IsDrawnByClicksOnATileWithoutAShape) {
  choose_kind("polygon");
  EXPECT_EQ(edits(), 0u) << "nothing is drawn yet";
  for (const Vec2 place : Points{{1, 7}, {3, 2}, {7, 3}}) click_at(place);
  EXPECT_EQ(edits(), 0u);
  click_at({1, 7});
  EXPECT_EQ(shape(), polygon({{1, 7}, {3, 2}, {7, 3}}));
  EXPECT_EQ(edits(), 1u);
  EXPECT_FALSE(edited().is_drawing);
  key(ctrl('z'));
  EXPECT_EQ(shape(), TileShape());
}

TEST_F(UiPolygon, EnterClosesIt) {
  choose_kind("polygon");
  click_at({1, 7});
  click_at({3, 2});
  key(kKeyEnter);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "A polygon needs at least 3 points.");
  key(kKeyEscape);  // closes the message
  click_at({7, 3});
  key(kKeyEnter);
  EXPECT_EQ(shape(), polygon({{1, 7}, {3, 2}, {7, 3}}));
  EXPECT_FALSE(app().ui().view.canvas.cursor.on());
}

TEST_F(UiPolygon, UnfinishedPointsAreTakenBack) {
  choose_kind("polygon");
  for (const Vec2 place : Points{{1, 7}, {3, 2}, {7, 3}, {7, 7}}) click_at(place);
  click_at({5, 5}, kRight);
  EXPECT_EQ(app().ui().view.shape.drawing, (Points{{1, 7}, {3, 2}, {7, 3}}));
  key(ctrl('z'));
  EXPECT_EQ(app().ui().view.shape.drawing->size(), 2u);
  key(kKeyDelete);
  EXPECT_EQ(app().ui().view.shape.drawing->size(), 1u);
  key(kKeyEscape);
  EXPECT_FALSE(edited().is_drawing);
  EXPECT_EQ(edits(), 0u);
  EXPECT_EQ(shape(), TileShape());
}

TEST_F(UiPolygon, ANewPointFollowsThePressedMouse) {
  choose_kind("polygon");
  click_at({1, 7});
  drag_at({3, 3}, {5, 1});
  EXPECT_EQ(app().ui().view.shape.drawing, (Points{{1, 7}, {5, 1}}));
}

TEST_F(UiPolygon, PointsAreDraggedToWholePixels) {
  put(kTriangle);
  drag_at({8, 0}, {4.2, 1.9});
  EXPECT_EQ(shape().points[1], (Vec2{4, 2}));
  EXPECT_EQ(edits(), 2u) << "a drag is one undo";
  EXPECT_EQ(edited().point, 1u);
  hold_modifiers(alt(kNoKey));
  drag_at({4, 2}, {5.5, 2.5});
  hold_modifiers();
  EXPECT_NE(shape().points[1], (Vec2{5, 2})) << "with Alt, anywhere";
  EXPECT_NEAR(shape().points[1].x, 5.5, 0.2);
  click_at({8, 8});
  EXPECT_EQ(edits(), 3u) << "a click changes nothing";
  EXPECT_EQ(edited().point, 2u);
  key(ctrl('z'));
  key(ctrl('z'));
  EXPECT_EQ(shape(), kTriangle);
}

TEST_F(UiPolygon, SnapIsChosenByButtonsAndKeys) {
  put(kTriangle);
  click("shape/snap_halves");
  drag_at({8, 0}, {5, 1});
  EXPECT_EQ(shape().points[1], (Vec2{4, 0}));
  key('1');
  drag_at({4, 0}, {6, 1});
  EXPECT_EQ(shape().points[1], (Vec2{8, 0}));
  key('4');
  drag_at({8, 0}, {6.3, 1.3});
  EXPECT_NEAR(shape().points[1].x, 6.3, 0.1);
  EXPECT_NE(shape().points[1], (Vec2{6, 1}));
  EXPECT_EQ(weld(shape().points[1]), shape().points[1]);
}

TEST_F(UiPolygon, AClickOnASideInsertsAPoint) {
  put(kTriangle);
  click_at({8, 4});
  EXPECT_EQ(shape().points, (Points{{0, 8}, {8, 0}, {8, 4}, {8, 8}}));
  EXPECT_EQ(edited().point, 2u) << "it is chosen";
  drag_at({4, 4}, {2, 3});
  EXPECT_EQ(shape().points, (Points{{0, 8}, {2, 3}, {8, 0}, {8, 4}, {8, 8}})) << "a drag takes it along";
  EXPECT_EQ(edits(), 3u);
}

TEST_F(UiPolygon, ARightClickRemovesAPoint) {
  put(polygon({{0, 8}, {2, 2}, {8, 0}, {8, 8}}));
  click_at({2, 2}, kRight);
  EXPECT_EQ(shape(), kTriangle);
  click_at({8, 0}, kRight);
  EXPECT_EQ(shape(), kTriangle);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "A polygon needs at least 3 points.");
}

TEST_F(UiPolygon, DeleteRemovesTheChosenPoint) {
  put(polygon({{0, 8}, {2, 2}, {8, 0}, {8, 8}}));
  move(at({5, 6}));
  key(kKeyDelete);
  EXPECT_EQ(shape().points.size(), 4u) << "no point is chosen";
  click_at({2, 2});
  key(kKeyDelete);
  EXPECT_EQ(shape(), kTriangle);
}

TEST_F(UiPolygon, ADragInsideMovesAllOfIt) {
  put(polygon({{2, 6}, {6, 2}, {6, 6}}));
  drag_at({5, 5}, {7.2, 2.1});
  EXPECT_EQ(shape(), polygon({{4, 3}, {8, -1}, {8, 3}}));
  EXPECT_EQ(edits(), 2u);
}

TEST_F(UiPolygon, EscapeCancelsADrag) {
  put(kTriangle);
  const ImVec2 from = at({8, 0}), to = at({4, 2});
  move(from);
  press();
  move(to);
  frames(2);
  ASSERT_EQ(shape().points[1], (Vec2{4, 2}));
  key(kKeyEscape);
  EXPECT_EQ(shape(), kTriangle);
  move(at({2, 2}));
  release();
  frames(2);
  EXPECT_EQ(shape(), kTriangle) << "the drag has ended";
  EXPECT_EQ(session().history().position(), 1u);
}

TEST_F(UiPolygon, CrossingSidesStayOutOfTheLevel) {
  const TileShape square = polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}});
  put(square);
  drag_at({0, 0}, {12, 4});
  EXPECT_EQ(shape(), square);
  EXPECT_EQ(edits(), 1u);
  ASSERT_TRUE(edited().is_draft);
  EXPECT_EQ(draft_text(edited()), "Not in the level: the shape has sides that cross or touch one another.");
  EXPECT_EQ(edited().whole.points[0], (Vec2{12, 4})) << "it is shown";
  drag_at({12, 4}, {2, 4});
  EXPECT_FALSE(edited().is_draft);
  EXPECT_EQ(shape().points[0], (Vec2{2, 4})) << "mended";
  EXPECT_EQ(session().history().position(), 2u);
  drag_at({2, 4}, {12, 4});
  ASSERT_TRUE(edited().is_draft);
  key(kKeyEscape);
  EXPECT_FALSE(edited().is_draft);
  EXPECT_EQ(shape().points[0], (Vec2{2, 4}));
  drag_at({2, 4}, {12, 4});
  key(ctrl('z'));
  EXPECT_FALSE(edited().is_draft);
  EXPECT_EQ(shape().points[0], (Vec2{2, 4})) << "only the draft is taken back";
}

TEST_F(UiPolygon, ADragThroughCrossingSidesIsOneUndo) {
  put(polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}}));
  const ImVec2 from = at({0, 0}), across = at({12, 4}), to = at({1, 1});
  move(from);
  press();
  for (const ImVec2 place : {across, at({3, 2}), across, to}) {
    move(place);
    frames(2);
  }
  release();
  frames(2);
  EXPECT_EQ(shape().points[0], (Vec2{1, 1}));
  EXPECT_EQ(session().history().position(), 2u);
}

TEST_F(UiPolygon, ADraftIsDroppedWithAnotherShape) {
  put(polygon({{0, 0}, {8, 0}, {8, 8}, {0, 8}}));
  drag_at({0, 0}, {12, 4});
  ASSERT_TRUE(edited().is_draft);
  put(kTriangle);
  EXPECT_FALSE(edited().is_draft);
  EXPECT_EQ(edited().whole, kTriangle);
}

TEST_F(UiPolygon, NumbersOfThePointAreTyped) {
  put(kTriangle);
  EXPECT_EQ(find("shape/point_x"), nullptr) << "no point is chosen";
  click_at({8, 0});
  type_number("shape/point_x", "3.25");
  EXPECT_EQ(shape().points[1], (Vec2{3.25, 0}));
  type_number("shape/point_y", "-2");
  EXPECT_EQ(shape().points[1], (Vec2{3.25, -2}));
  type_number("shape/point_x", "73");
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Not changed: a point must be at most 8 tiles away from its tile.");
  EXPECT_EQ(shape().points[1], (Vec2{3.25, -2}));
}

TEST_F(UiPolygon, OneWayPolygonsMayBeCeilings) {
  put(kTriangle);
  EXPECT_EQ(find("shape/kind_ceiling"), nullptr);
  click("shape/kind_one_way");
  frames(2);
  EXPECT_TRUE(shape().one_way);
  click("shape/kind_ceiling");
  EXPECT_EQ(shape().side, TileShape::Side::ceiling);
}

TEST_F(UiPolygon, IsMirroredInItsTile) {
  put(kTriangle);
  click("shape/mirror_h");
  EXPECT_EQ(shape().points, (Points{{8, 8}, {0, 0}, {0, 8}}));
  frames(2);
  click("shape/mirror_v");
  EXPECT_EQ(shape().points, (Points{{8, 0}, {0, 8}, {0, 0}}));
}

TEST_F(UiPolygon, PointsMayLieBeyondTheTile) {
  put(kTriangle);
  drag_at({8, 0}, {9, -1});
  EXPECT_EQ(shape().points[1], (Vec2{9, -1})) << "there is a margin around the tile";
  const Widget* canvas = find("shape/canvas");
  drag(at({9, -1}), {canvas->max.x + 40, at({0, 4}).y});
  frames(2);
  ASSERT_GT(shape().points[1].x, 10);
  EXPECT_LT(at(shape().points[1]).x, find("shape/canvas")->max.x) << "the canvas shows what reaches further";
}

TEST_F(UiPolygon, KeysChooseMoveInsertAndRemovePoints) {
  put(kTriangle);
  key(shift(kKeyF2));
  frames(2);
  ASSERT_EQ(app().ui().view.window.focus, Focus::shape);
  key(kKeyUp);
  EXPECT_EQ(shape(), polygon({{0, 7}, {8, -1}, {8, 7}})) << "all of it";
  key(']');
  key(']');
  key(kKeyLeft);
  EXPECT_EQ(shape().points[1], (Vec2{7, -1}));
  key('2');
  key(kKeyDown);
  EXPECT_EQ(shape().points[1], (Vec2{7, 3})) << "half a tile";
  key('i');
  EXPECT_EQ(shape().points.size(), 4u);
  EXPECT_EQ(edited().point, 2u);
  key(kKeyDelete);
  EXPECT_EQ(shape().points.size(), 3u);
  key('h');
  EXPECT_EQ(shape().points[0], (Vec2{8, 7}));
  key('v');
  EXPECT_EQ(shape().points[0], (Vec2{8, 1}));
}

TEST_F(UiPolygon, IsDrawnByTheKeyboardAlone) {
  key(shift(kKeyF2));
  frames(2);
  key('d');
  frames(2);
  key(kKeyEnter);  // the cursor
  frames(2);
  ASSERT_TRUE(app().ui().view.canvas.cursor.is_on("shape"));
  const auto go = [&](int arrow, int times) {
    for (int i = 0; i < times; ++i) {
      key(arrow);
      frames(2);
    }
    hold(' ');
    frames(3);
    let_go(' ');
    frames(3);
  };
  go(kKeyUp, 1);
  go(kKeyRight, 4);
  go(kKeyDown, 5);
  ASSERT_TRUE(edited().is_drawing);
  key(kKeyEnter);
  ASSERT_EQ(shape().points.size(), 3u);
  EXPECT_EQ(shape().points[1] - shape().points[0], (Vec2{4, 0}));
  EXPECT_EQ(shape().points[2] - shape().points[1], (Vec2{0, 5}));
}

TEST_F(UiPolygon, AHiddenEditorGivesTheKeysBack) {
  put(kTriangle);
  move(at({4, 6}));
  frames(2);
  ASSERT_EQ(app().ui().view.window.focus, Focus::shape);
  click("tabs/tuning");
  frames(10);
  EXPECT_EQ(app().ui().view.window.focus, Focus::map);
}

TEST_F(UiPolygon, OtherTilesWithTheSameShapeChangeToo) {
  put(kTriangle, 40);
  put(kTriangle, 41);
  drag(on_sheet(40), on_sheet(41));
  frames(2);
  drag_at({8, 0}, {4, 0});
  for (const int tile : {40, 41}) EXPECT_EQ(shape(tile).points[1], (Vec2{4, 0})) << tile;
  EXPECT_EQ(session().history().position(), 3u);
}

// ---- Groups ----

const TileShape kFlat = polygon({{0, 6}, {4, 6}, {4, 8}, {0, 8}});
const TileShape kHigh = polygon({{5, 1}, {8, 1}, {8, 3}, {5, 3}});

TEST_F(UiPolygon, ADrawnPolygonIsAFurtherPart) {
  put(kFlat);
  key(shift(kKeyF2));
  click("shape/draw");
  frames(2);
  for (const Vec2 place : Points{{5, 1}, {8, 1}, {8, 3}, {5, 1}}) click_at(place);
  EXPECT_EQ(shape(), with_new_part(kFlat, polygon({{5, 1}, {8, 1}, {8, 3}})));
  EXPECT_EQ(edited().part, 1u);
  EXPECT_EQ(session().history().position(), 2u);
}

TEST_F(UiPolygon, PartsOfOtherKindsAreAdded) {
  put(kHigh);
  click("shape/add");
  click("shape/add_slope");
  frames(2);
  const TileShape slope{.kind = Kind::slope, .heights = {0, 8}};
  ASSERT_EQ(shape(), with_new_part(kHigh, slope));
  ASSERT_NE(find("shape/handle1"), nullptr) << "the new part is edited";
  drag(find("shape/handle1")->centre(), at({8, 4}));
  frames(2);
  EXPECT_EQ(part_at(shape(), 1).heights, (std::vector<double>{0, 4}));
  choose_kind("profile");
  EXPECT_EQ(part_at(shape(), 1).kind, Kind::profile);
  EXPECT_EQ(part_at(shape(), 0), kHigh);
}

TEST_F(UiPolygon, APartIsChosenByAClickAndInTheList) {
  put(with_new_part(kFlat, kHigh));
  EXPECT_EQ(edited().part, 0u);
  click_at({6.5, 2});
  EXPECT_EQ(edited().part, 1u);
  drag_at({6.5, 2}, {5.5, 4});
  EXPECT_EQ(shape(), with_new_part(kFlat, moved_by(kHigh, {-1, 2}, {8, 8})));
  click("shape/part");
  click("shape/part0");
  frames(2);
  EXPECT_EQ(edited().part, 0u);
  move(at({1, 1}));
  key('n');
  EXPECT_EQ(edited().part, 1u);
  EXPECT_EQ(session().history().position(), 2u);
}

TEST_F(UiPolygon, APartIsRemoved) {
  put(with_new_part(kFlat, kHigh));
  click("shape/remove_part");
  EXPECT_EQ(shape(), kHigh) << "a single part is no group";
  frames(2);
  EXPECT_EQ(find("shape/remove_part"), nullptr);
  EXPECT_EQ(find("shape/part"), nullptr);
  choose_kind("none");
  EXPECT_EQ(shape(), TileShape());
}

TEST_F(UiPolygon, AnInvalidPartKeepsTheGroupOutOfTheLevel) {
  const TileShape group = with_new_part(kFlat, kHigh);
  put(group);
  drag_at({0, 6}, {6, 7});
  EXPECT_EQ(shape(), group);
  EXPECT_EQ(draft_text(edited()),
            "Not in the level: the shape has a part that has sides that cross or touch one another.");
}

TEST_F(UiPolygon, AFlagMayStandForOne) {
  session().apply(action::EditLevel{
      single_change("Change the shape of flag 6",
                    FlagShapeChange{6, level().flag_shapes[6], {.kind = Kind::slope, .heights = {0, 8}}})});
  click("flags/lamp6", kRight);
  frames(3);
  click("flags/shape");
  click("flags/shape_polygon");
  frames(2);
  EXPECT_EQ(level().flag_shapes[6], kTriangle);
}

TEST_F(UiPolygon, AFlagTakesTheShapeOfTheTile) {
  const TileShape group = with_new_part(kFlat, kHigh);
  put(group);
  click("flags/lamp6", kRight);
  frames(3);
  click("flags/shape_of_tile");
  EXPECT_EQ(level().flag_shapes[6], group);
}

// ---- Sizes of tiles and of the window ----

struct SizeCase {
  TileSize tile;
  int width, height;  // px, of the window
};

class UiPolygonSizes : public UiTest, public ::testing::WithParamInterface<SizeCase> {};

TEST_P(UiPolygonSizes, PolygonsAreEditedAtAnySize) {
  const auto [tile, width, height] = GetParam();
  Level level = test_level();
  TileMap map(level.map.width(), level.map.height(), tile);
  level.map = std::move(map);
  level.tuning = new_tuning(tile);
  level.tuning.solver = SolverKind::exact;
  const double w = tile.width, h = tile.height;
  level.tile_shapes[9] = polygon({{0, 0}, {w, 0}, {w, h}, {0, h}});
  ASSERT_TRUE(save_level(level, *find_format("native"), path("level.talus.json")));
  start(path("level.talus.json"), width, height);
  click(on_sheet(9));
  click("tabs/shape");
  frames(2);
  const Widget *canvas = find("shape/canvas"), *shown = find("shape/tile");
  ASSERT_NE(shown, nullptr);
  EXPECT_GE(shown->min.x, canvas->min.x);
  EXPECT_LE(shown->max.x, canvas->max.x);
  EXPECT_LE(canvas->max.y, static_cast<float>(height));
  EXPECT_GT(shown->max.x - shown->min.x, 60) << "large enough for the hand";
  const float zoom = (shown->max.x - shown->min.x) / static_cast<float>(tile.width);
  const ImVec2 corner = shown->min;
  const ImVec2 side{corner.x + static_cast<float>(w / 2) * zoom, corner.y};
  click("shape/snap_halves");
  drag(side, {side.x, corner.y + static_cast<float>(h / 2) * zoom});
  frames(2);
  EXPECT_EQ(this->level().tile_shapes[9], polygon({{0, 0}, {w / 2, h / 2}, {w, 0}, {w, h}, {0, h}}));
}

INSTANTIATE_TEST_SUITE_P(Sizes, UiPolygonSizes,
                         ::testing::Values(SizeCase{{8, 8}, 1152, 700}, SizeCase{{16, 16}, 1152, 700},
                                           SizeCase{{18, 12}, 1152, 700}, SizeCase{{64, 64}, 1152, 700},
                                           SizeCase{{16, 16}, 1600, 1000}, SizeCase{{64, 64}, 1600, 1000}),
                         [](const auto& size) {
                           return std::to_string(size.param.tile.width) + "x" +
                                  std::to_string(size.param.tile.height) + "at" +
                                  std::to_string(size.param.width);
                         });

}  // namespace talus::polygon_ui_test
