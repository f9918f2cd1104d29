// The places of the overlays' labels.
#include "harness.h"
#include "panels/canvas/overlay_labels.h"

namespace talus::label_test {

// Labels on a canvas of 400 by 300 px, in the sizes of the editor's font.
class UiLabels : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
  }
  static OverlayLabel label(const Overlay& overlay, int body, Rect box, Vec2 at, const char* text) {
    return {&overlay, at, text, false, body, box};
  }
  CanvasView view(float zoom) { return {{0, 0}, {400, 300}, {0, 0}, zoom}; }
  ScreenBox on_screen(const Rect& r, float zoom) {
    const CanvasView v = view(zoom);
    return {v.to_screen({r.x, r.y}), v.to_screen({r.right(), r.bottom()})};
  }
};

TEST_F(UiLabels, StayNearTheirBody) {
  const Rect body{20, 40, 8, 8};
  const CanvasView canvas = view(4);
  for (double speed : {0.0, 2.0, 10.0, 40.0}) {
    const std::vector<OverlayLabel> labels = {
        label(overlay::velocity, 1, body, {24 + speed * 4, 44 + speed}, "10.00, 0.18")};
    for (const PlacedLabel& placed : LabelPlacer(canvas, 1, 1, {}).place(labels))
      EXPECT_LE(placed.box.distance(on_screen(body, 4)), kLabelReach) << speed;
  }
}

TEST_F(UiLabels, DoNotOverlapAndRareOnesComeFirst) {
  const CanvasView canvas = view(4);
  std::vector<OverlayLabel> labels;
  for (int i = 0; i < 6; ++i) {
    const Rect body{20.0 + 9 * i, 40, 8, 8};
    labels.push_back(label(overlay::velocity, i + 1, body, {body.x + 20, 44}, "10.00, 0.18"));
  }
  labels.push_back(label(overlay::slope_delta, 3, {38, 40, 8, 8}, {42, 36}, "delta 0.61"));
  const auto placed = LabelPlacer(canvas, 1, 0, {}).place(labels);
  ASSERT_GE(placed.size(), 2u);
  EXPECT_EQ(placed[0].label->text, "delta 0.61");
  for (std::size_t i = 0; i < placed.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) EXPECT_GE(placed[i].box.distance(placed[j].box), 2) << i << ' ' << j;
}

TEST_F(UiLabels, WithoutRoomAreLeftOutAndListedUnderTheMouse) {
  const Rect body{40, 40, 8, 8};
  const CanvasView canvas = view(4);
  const std::vector<OverlayLabel> labels = {label(overlay::velocity, 1, body, {60, 44}, "5.00, 0.00"),
                                            label(overlay::floor_height, 1, body, {52, 48}, "floor 48.00")};
  const std::vector<ScreenBox> everything = {{{0, 0}, {400, 300}}};
  EXPECT_TRUE(LabelPlacer(canvas, 1, 0, everything).place(labels).empty());
  EXPECT_TRUE(LabelPlacer(canvas, 1, 2, everything).place(labels).empty()) << "another body";
  const auto listed = LabelPlacer(canvas, 1, 1, everything).place(labels);
  ASSERT_EQ(listed.size(), 2u);
  EXPECT_EQ(listed[1].box.min.y, listed[0].box.max.y);
  EXPECT_FALSE(listed[0].point);
}

// For example the label of a stage, which comes last.
TEST_F(UiLabels, ListedOnesCoverNoOthers) {
  const Rect body{40, 40, 8, 8};
  const CanvasView canvas = view(4);
  std::vector<OverlayLabel> labels = {label(overlay::velocity, 1, body, {60, 30}, "0.55, 0.00"),
                                      label(overlay::touch_points, 1, body, {48, 40}, "t 0.00")};
  for (OverlayLabel& each : labels) each.important = true;
  // There is room for one label, beside the body's upper right corner.
  const std::vector<ScreenBox> taken = {
      {{0, 0}, {200, 300}}, {{0, 0}, {400, 120}}, {{0, 150}, {400, 300}}, {{320, 0}, {400, 300}}};
  const auto placed = LabelPlacer(canvas, 1, 0, taken).place(labels);
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_TRUE(placed[0].point);
  EXPECT_FALSE(placed[1].point) << "it is listed";
  EXPECT_FALSE(placed[0].box.meets(placed[1].box));
}

// At zoom 16 a ramp and a gauge take all the room beside a body.
TEST_F(UiLabels, OfTheChosenBodyAreListedWithoutRoom) {
  const Rect body{10, 8, 8, 8};
  const CanvasView canvas = view(16);
  std::vector<OverlayLabel> labels = {label(overlay::velocity, 1, body, {20, 12}, "5.00, 0.00"),
                                      label(overlay::slope_delta, 1, body, {14, 6}, "delta 0.61")};
  const std::vector<ScreenBox> everything = {{{0, 0}, {400, 300}}};
  EXPECT_TRUE(LabelPlacer(canvas, 1, 0, everything).place(labels).empty());
  for (OverlayLabel& each : labels) each.important = true;
  const auto listed = LabelPlacer(canvas, 1, 0, everything).place(labels);
  ASSERT_EQ(listed.size(), 2u);
  for (const PlacedLabel& placed : listed) EXPECT_TRUE(placed.box.inside({{0, 0}, {400, 300}}));
  EXPECT_EQ(listed[1].box.min.y, listed[0].box.max.y);
  for (OverlayLabel& each : labels) each.body_box = {100, 8, 8, 8};
  EXPECT_TRUE(LabelPlacer(canvas, 1, 0, everything).place(labels).empty()) << "the body is out of sight";
}

TEST_F(UiLabels, AtLowZoomOnlyTheBodyUnderTheMouseHasLabels) {
  const Rect body{40, 40, 8, 8};
  const CanvasView canvas = view(1);
  const std::vector<OverlayLabel> labels = {label(overlay::velocity, 1, body, {60, 44}, "5.00, 0.00")};
  EXPECT_TRUE(LabelPlacer(canvas, 1, 0, {}).place(labels).empty());
  EXPECT_EQ(LabelPlacer(canvas, 1, 1, {}).place(labels).size(), 1u);
}

TEST_F(UiLabels, SlowArrowsHaveNoLabelUnlessPointedAt) {
  const Rect body{40, 40, 8, 8};
  const CanvasView canvas = view(4);
  const std::vector<OverlayLabel> labels = {label(overlay::velocity, 1, body, {44, 43}, "0.00, -0.18")};
  EXPECT_TRUE(LabelPlacer(canvas, 1, 0, {}).place(labels).empty());
  EXPECT_EQ(LabelPlacer(canvas, 1, 1, {}).place(labels).size(), 1u);
}

TEST_F(UiLabels, EqualOnesThatStandNearAreOne) {
  const CanvasView canvas = view(4);
  const std::vector<OverlayLabel> labels = {label(overlay::velocity, 1, {20, 40, 8, 8}, {30, 44}, "1.00"),
                                            label(overlay::velocity, 2, {30, 40, 8, 8}, {34, 44}, "1.00"),
                                            label(overlay::velocity, 3, {28, 30, 8, 8}, {40, 34}, "2.00"),
                                            label(overlay::velocity, 4, {70, 40, 8, 8}, {80, 44}, "1.00")};
  std::vector<int> bodies;
  for (const PlacedLabel& placed : LabelPlacer(canvas, 1, 0, {}).place(labels))
    bodies.push_back(placed.label->body);
  std::sort(bodies.begin(), bodies.end());
  EXPECT_EQ(bodies, (std::vector<int>{1, 3, 4}));
}

}  // namespace talus::label_test
