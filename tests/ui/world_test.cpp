// Finding the way on large maps: the world view, the minimap and two maps; and what drawing them costs.
#include <cmath>

#include <talus/formats/format.h>
#include "harness.h"
#include "overlay/visible_items.h"

namespace talus::world_test {

class UiWorld : public UiTest {
 protected:
  // Opens a level of this size, with a solid tile in a quarter of its cells, in the map view alone.
  void open_large(int width, int height) {
    Level large = test_level();
    large.map = TileMap(width, height);
    std::uint32_t bits = 1;
    for (TileNumber& cell : large.map.cells().tiles()) {
      bits = bits * 1664525u + 1013904223u;
      cell = bits >> 30 == 0 ? 1 : 0;
    }
    large.tuning.solver = SolverKind::exact;
    ASSERT_TRUE(save_level(large, *find_format("native"), path("large.talus.json")));
    start(path("large.talus.json"));
    click(on_sheet(3));
    key(kKeyF3);
    key(ctrl('1'));
  }
  // The cell in the middle of a canvas.
  Cell middle(const std::string& canvas = "map") {
    move(centre(canvas + "/canvas"));
    return app().ui().view.canvas.hover.cell.value_or(Cell{-1, -1});
  }
  void expect_near(Cell a, Cell b, int most) {
    EXPECT_NEAR(a.x, b.x, most);
    EXPECT_NEAR(a.y, b.y, most);
  }
  float zoom(const std::string& canvas = "map") {
    const ImVec2 from = on_canvas(canvas, {0, 0}), to = on_canvas(canvas, {8, 0});
    return std::round(to.x - from.x) / 8;
  }
  ImVec2 size_of(std::string_view widget) {
    const Widget* found = find(widget);
    return found == nullptr ? ImVec2{} : ImVec2{found->max.x - found->min.x, found->max.y - found->min.y};
  }
};

TEST_F(UiWorld, AClickInTheWorldViewGoesThere) {
  open_large(600, 400);
  const float before = zoom();
  key(kKeyTab);
  expect_near(middle(), {300, 200}, 2);
  click(on_map({500, 320}));
  EXPECT_EQ(zoom(), before);
  expect_near(middle(), {500, 320}, 4);
  EXPECT_FALSE(session().modified()) << "nothing was painted";
  click(on_map({500, 320}));
  EXPECT_TRUE(session().modified()) << "now the tool works again";
}

TEST_F(UiWorld, TheCaptionOfTheWorldViewHidesLittle) {
  Level level = test_level();
  level.map = TileMap(240, 136);
  for (int x = 0; x < 30; ++x) level.map.set({x, 2}, 1);  // the only tiles on the first screen
  ASSERT_TRUE(save_level(level, *find_format("native"), path("first.talus.json")));
  start(path("first.talus.json"));
  const float top = find("map/captions")->min.y;
  key(kKeyTab);
  frames(2);
  EXPECT_GT(find("map/captions")->min.y, on_map({0, 70}).y);
  EXPECT_LE(find("map/captions")->max.y, find("map/canvas")->max.y);
  key(kKeyTab);
  frames(2);
  EXPECT_EQ(find("map/captions")->min.y, top);
  Edit floor{"Paint", {}};
  for (int x = 0; x < 240; ++x)
    for (int y = 120; y < 136; ++y) floor.changes.push_back(CellChange{{x, y}, 0, 1});
  session().apply(action::EditLevel{floor});
  key(kKeyTab);
  frames(2);
  EXPECT_EQ(find("map/captions")->min.y, top) << "the floor is at the bottom";
}

TEST_F(UiWorld, TabGoesBackFromTheWorldView) {
  open_large(600, 400);
  const Cell before = middle();
  key(kKeyTab);
  key(kKeyTab);
  EXPECT_EQ(middle(), before);
}

TEST_F(UiWorld, ThingsOutOfSightHaveNoLabel) {
  open_large(600, 400);
  const auto scroll_away_and_back = [&](const char* label) {
    EXPECT_NE(find(label), nullptr);
    for (int i = 0; i < 20; ++i) key(kKeyDown);
    EXPECT_EQ(find(label), nullptr) << label;
    for (int i = 0; i < 20; ++i) key(kKeyUp);
    EXPECT_NE(find(label), nullptr);
  };
  click("map/body");
  click(on_map({6, 6}));
  frames(2);
  click("map/first_body_player");
  ASSERT_TRUE(frames_until([&] { return find("map/chosen_body") != nullptr; }))
      << "its ground is compiled first";
  scroll_away_and_back("map/chosen_body");
  click("map/segment");
  drag(on_map({10, 10}), on_map({14, 10}));
  frames(2);
  scroll_away_and_back("map/chosen_curve");
}

TEST_F(UiWorld, TheMinimapMovesTheView) {
  open_large(600, 400);
  EXPECT_EQ(find("map/overview"), nullptr);
  key('o');
  frames();
  ASSERT_NE(find("map/overview"), nullptr);
  const float before = zoom();
  click("map/overview");
  expect_near(middle(), {300, 200}, 4);
  const ImVec2 at = centre("map/overview"), size = size_of("map/overview");
  EXPECT_NEAR(size.x / size.y, 1.5, 0.05);
  drag(at, {at.x + size.x / 3, at.y - size.y / 4});
  expect_near(middle(), {500, 100}, 8);  // one pixel of the minimap is more than three cells
  EXPECT_EQ(zoom(), before);
  EXPECT_FALSE(session().modified()) << "nothing was painted";
  key('o');
  frames();
  EXPECT_EQ(find("map/overview"), nullptr);
}

TEST_F(UiWorld, EachOfTwoMapsHasItsOwnCamera) {
  open_large(600, 400);
  key(ctrl('4'));
  frames(2);
  const Cell first = middle();
  const float before = zoom();
  move(centre("second_map/canvas"));
  wheel(1);
  EXPECT_GT(zoom("second_map"), before);
  EXPECT_EQ(zoom(), before);
  key(kKeyTab);
  expect_near(middle("second_map"), {300, 200}, 2);
  EXPECT_EQ(middle(), first) << "the keys are for the map that was used last";
  click(on_canvas("second_map", {500 * 8, 300 * 8}));
  click(centre("second_map/canvas"));
  EXPECT_TRUE(session().modified()) << "both are painted on";
}

// The cost of drawing depends on what is visible: the numbers are those of a map as large as the canvas.
TEST_F(UiWorld, DrawingAHugeMapCostsOnlyItsVisiblePart) {
  open_large(2048, 2048);
  const ImVec2 size = size_of("map/canvas");
  for (int i = 0; i < 30 && zoom() > 1; ++i) key('-');
  ASSERT_EQ(zoom(), 1);
  frames();
  const double cells = (size.x / 8 + 2) * (size.y / 8 + 2);
  const int window = 30'000;  // vertices for the rest of the window
  EXPECT_LT(ImGui::GetIO().MetricsRenderVertices, cells * 4 + window);
  EXPECT_GT(ImGui::GetIO().MetricsRenderVertices, cells / 4) << "a quarter of the cells has a tile";
  key(kKeyTab);
  frames();
  EXPECT_LT(ImGui::GetIO().MetricsRenderVertices, window);
  key('o');
  key(ctrl('3'));
  frames(2);
  EXPECT_LT(ImGui::GetIO().MetricsRenderVertices, cells * 4 + window);
}

// The longest possible map: all work on it takes as long as for its visible part, or is done piece by piece.
TEST_F(UiWorld, TheLongestMapIsOpenedAndShownAsAWhole) {
  open_large(1 << 21, 2);
  int frames_of_lint = 0;
  for (; session().is_linting() && frames_of_lint < 100'000; ++frames_of_lint) frames();
  EXPECT_FALSE(session().is_linting());
  for (int i = 0; i < 100'000 && session().compile_progress(); ++i) frames();
  ASSERT_FALSE(session().compile_progress());
  for (const Overlay* overlay : all_overlays()) session().apply(action::SetOverlay{overlay, true});
  key(ctrl('3'));  // the map and the play view
  key(kKeyTab);
  frames(2);
  EXPECT_LT(ImGui::GetIO().MetricsRenderVertices, 60'000);
  int visited = 0;
  for_each_visible_item(session().scene(), {1e6, -100, 400, 300}, [&](const SceneItem&) { ++visited; });
  EXPECT_LE(visited, 2 * (400 / 8 + 2));
  key(kKeyTab);
  app().ui().view.requests.ask(request::ShowCell{Cell{2'000'000, 1}});
  frames(2);
  key('=');
  const Cell far = middle();
  expect_near(far, {2'000'000, 1}, 3);
  click(on_map({far.x, 0}));
  EXPECT_EQ(tile_at({far.x, 0}), 3);
}

TEST_F(UiWorld, LargeGroundCompilesWhileTheEditorGoesOn) {
  open_large(1024, 1024);
  for (int i = 0; i < 100'000 && session().compile_progress(); ++i) frames();
  ASSERT_FALSE(session().compile_progress());
  const Scene* before = &session().scene();
  session().apply(action::EditLevel{Edit{"Solid", {FlagsChange{SheetId::tiles, 7, 0, 1}}}, 0});
  frames();
  if (session().compile_progress()) {
    EXPECT_NE(find("status/compiling"), nullptr);
    EXPECT_EQ(&session().scene(), before);
  }
  click(on_map({3, 3}));
  EXPECT_EQ(session().history().edits().size(), 2u) << "painted meanwhile";
  for (int i = 0; i < 100'000 && session().compile_progress(); ++i) frames();
  EXPECT_EQ(find("status/compiling"), nullptr);
  EXPECT_NE(&session().scene(), before);
}

}  // namespace talus::world_test
