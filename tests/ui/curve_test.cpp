// Segments and curves on the map: drawn, bent by their handles, named, copied and removed.
#include <imgui_internal.h>

#include "harness.h"

namespace talus::curve_test {

class UiCurve : public UiTest {
 protected:
  void SetUp() override {
    UiTest::SetUp();
    start();
    key(kKeyF3);
  }
  // Chooses a kind by its command in the palette, and draws a curve.
  void draw_kind(CurveKind kind, Vec2 from, Vec2 to) {
    click("map/curve");
    while (session().choices().curve_kind != kind) key('c');
    drag(on_canvas("map", from), on_canvas("map", to));
  }
  const Curve& curve(std::size_t i) { return level().curves.at(i).curve; }
  Vec2 place_of_handle(int i) {
    move(centre("map/curve_handle" + std::to_string(i)));
    return app().ui().view.canvas.hover.pixel.value_or(Vec2{});
  }
  void drag_handle(int i, Vec2 to) {
    drag(centre("map/curve_handle" + std::to_string(i)), on_canvas("map", to));
  }
};

TEST_F(UiCurve, EachKindIsDrawnByADrag) {
  draw_kind(CurveKind::arc, {16, 40}, {80, 40});
  draw_kind(CurveKind::parabola, {100, 40}, {160, 40});
  draw_kind(CurveKind::cubic, {16, 72}, {80, 64});
  draw_kind(CurveKind::sine, {100, 72}, {164, 68});
  draw_kind(CurveKind::polyline, {16, 96}, {40, 100});
  ASSERT_EQ(level().curves.size(), 5u);
  EXPECT_EQ(curve(0), (Curve{Arc{{48, 64}, 40, 16, 80, true}, Curve::Faces::up}));
  EXPECT_EQ(curve(1), (Curve{Parabola{{100, 40}, {160, 40}, 10}, Curve::Faces::up}));
  EXPECT_EQ(curve(2), (Curve{Cubic{{16, 72}, {80, 64}, 0, 0}, Curve::Faces::up}));
  EXPECT_EQ(curve(3), (Curve{Sine{100, 164, 72, -4, 64, 100}, Curve::Faces::up}));
  EXPECT_EQ(curve(4).form.index(), static_cast<std::size_t>(CurveKind::polyline));
  EXPECT_EQ(std::get<Polyline>(curve(4).form).ys.size(), 4u);
  EXPECT_EQ(session().history().edits().size(), 5u);
}

TEST_F(UiCurve, HandlesBendTheChosenCurveAsOneUndo) {
  draw_kind(CurveKind::arc, {16, 40}, {80, 40});
  EXPECT_EQ(session().choices().curve, 0);
  drag_handle(2, {48, 8});
  EXPECT_EQ(curve(0), (Curve{Arc{{48, 40}, 32, 16, 80, true}, Curve::Faces::up}));
  EXPECT_EQ(session().history().edits().size(), 2u);
  EXPECT_EQ(session().history().edits().back().label, "Bend a curve: arc");
  key(ctrl('z'));
  EXPECT_EQ(curve(0), (Curve{Arc{{48, 64}, 40, 16, 80, true}, Curve::Faces::up}));
  key(ctrl('y'));
  draw_kind(CurveKind::cubic, {100, 100}, {160, 96});
  drag_handle(2, {120, 90});
  EXPECT_DOUBLE_EQ(std::get<Cubic>(curve(1).form).from_slope, -0.5);
  drag_handle(1, {160, 108});
  EXPECT_EQ(std::get<Cubic>(curve(1).form).to, (Vec2{160, 108}));
}

TEST_F(UiCurve, EscapeLeavesACurveAsItWas) {
  const auto cancel_drag = [&](ImVec2 from, Vec2 to) {
    move(from);
    press();
    move(on_canvas("map", to));
    key(kKeyEscape);
    move(on_canvas("map", {to.x + 8, to.y}));
    release();
  };
  draw_kind(CurveKind::arc, {16, 40}, {80, 40});
  const Curve before = curve(0);
  cancel_drag(centre("map/curve_handle1"), {120, 60});
  EXPECT_EQ(curve(0), before) << "an end";
  cancel_drag(on_canvas("map", {48, 24}), {90, 70});
  EXPECT_EQ(curve(0), before) << "all of it";
  cancel_drag(on_canvas("map", {150, 60}), {200, 60});
  EXPECT_EQ(level().curves.size(), 1u) << "a new one";
  EXPECT_EQ(session().history().position(), 1u);
  EXPECT_EQ(session().choices().curve, 0) << "it stays chosen";
}

TEST_F(UiCurve, LineIsChosenByAClickAndMovedByADrag) {
  draw_kind(CurveKind::parabola, {16, 40}, {80, 40});
  click(on_canvas("map", {200, 20}));
  EXPECT_EQ(session().choices().curve, -1) << "a click beside it lets it go";
  EXPECT_EQ(find("map/curve_handle0"), nullptr);
  click(on_canvas("map", {48, 24}));
  EXPECT_EQ(session().choices().curve, 0);
  EXPECT_EQ(session().history().edits().size(), 1u) << "a click moves nothing";
  drag(on_canvas("map", {48, 24}), on_canvas("map", {59, 45}));
  EXPECT_EQ(curve(0), (Curve{Parabola{{27, 61}, {91, 61}, 29}, Curve::Faces::up}));
  EXPECT_EQ(session().history().edits().size(), 2u);
}

TEST_F(UiCurve, EndsSnapToOtherEndsUnlessAltIsHeld) {
  click("map/segment");
  drag(on_canvas("map", {16, 40}), on_canvas("map", {51, 27}));
  hold_modifiers(shift(kNoKey));
  drag(on_canvas("map", {52, 26}), on_canvas("map", {90, 27}));
  hold_modifiers();
  ASSERT_EQ(level().curves.size(), 2u) << "with Shift, a drag beside a line draws another";
  EXPECT_EQ(curve(1), (Curve{Segment{{51, 27}, {90, 27}}, Curve::Faces::up}));
  hold_modifiers(alt(kNoKey));
  drag_handle(0, {52, 25});
  hold_modifiers();
  const Vec2 free = std::get<Segment>(curve(1).form).from;
  EXPECT_NE(free, (Vec2{51, 27}));
  EXPECT_NEAR(free.x, 52, 0.6);
  EXPECT_NEAR(free.y, 25, 0.6);
}

TEST_F(UiCurve, AnInvalidPlaceSaysWhyAndChangesNothing) {
  draw_kind(CurveKind::sine, {50, 40}, {50, 80});
  EXPECT_TRUE(level().curves.empty());
  ASSERT_TRUE(session().message());
  EXPECT_EQ(session().message()->text, "Sine from 50, 40 to 50, 80: the sine has a width of zero.");
  draw_kind(CurveKind::parabola, {16, 40}, {80, 40});
  const Curve before = curve(0);
  move(centre("map/curve_handle0"));
  press();
  move(on_canvas("map", {120, 40}));
  release();
  EXPECT_EQ(curve(0), before);
  ASSERT_TRUE(session().message());
  EXPECT_EQ(
      session().message()->text,
      "The parabola has its right end left of its left end there, so it stays where it was last valid.");
}

TEST_F(UiCurve, EndsBesideTheMapAreMovedToItsEdge) {
  key('-');  // zooms out, so that there is room around the map
  frames(2);
  draw_kind(CurveKind::parabola, {-12, 40}, {80, 40});
  ASSERT_EQ(level().curves.size(), 1u);
  EXPECT_EQ(std::get<Parabola>(curve(0).form).from, (Vec2{0, 40}));
  drag_handle(1, {252, 48});
  EXPECT_EQ(std::get<Parabola>(curve(0).form).to, (Vec2{240, 48}));
  drag_handle(2, {120, -6});
  EXPECT_EQ(std::get<Parabola>(curve(0).form).control_y, -6) << "what bends it may be anywhere";
  click("map/slope");
  drag(on_canvas("map", {-12, 128}), on_canvas("map", {32, 120}));
  EXPECT_FALSE(session().message());
  EXPECT_EQ(session().history().edits().size(), 4u);
}

TEST_F(UiCurve, InspectorEditsNameAndNumbers) {
  draw_kind(CurveKind::parabola, {16, 40}, {80, 40});
  click("inspector/curve_name");
  type("hill");
  key(KeyChord{'\r'});
  EXPECT_EQ(level().curves.at(0).name, "hill");
  click("inspector/curve_control");
  click("inspector/curve_control");  // the second click of a double click
  key(ctrl('a'));
  type("12.5");
  key(KeyChord{'\r'});
  EXPECT_EQ(std::get<Parabola>(curve(0).form).control_y, 12.5);
  click("inspector/curve_faces");
  click("inspector/curve_faces2");
  EXPECT_EQ(curve(0).faces, Curve::Faces::both);
  const Curve before = curve(0);
  click("inspector/curve_from_x");
  click("inspector/curve_from_x");
  key(ctrl('a'));
  type("90");
  key(KeyChord{'\r'});
  EXPECT_EQ(curve(0), before);
  EXPECT_NE(find("inspector/curve_problem"), nullptr) << "the problem is shown below the fields";
  frames(90);
  const ImGuiWindow* tooltip = ImGui::FindWindowByName("##Tooltip_00");
  EXPECT_TRUE(tooltip == nullptr || !tooltip->Active) << "a tooltip would cover the problem";
}

TEST_F(UiCurve, TheLongestLabelIsApartFromItsField) {
  draw_kind(CurveKind::arc, {16, 40}, {80, 40});
  frames(2);
  const Widget* conveyor = find("inspector/curve_conveyor");
  ASSERT_NE(conveyor, nullptr);
  const float gap = 4, label = conveyor->clip_min.x + 4 + ImGui::CalcTextSize("Conveyor").x;  // px
  EXPECT_GE(conveyor->min.x, label + gap);
}

TEST_F(UiCurve, NumbersAreNotCutInTheirFields) {
  draw_kind(CurveKind::arc, {16, 40}, {80, 33});
  frames(2);
  const Widget* radius = find("inspector/curve_radius");
  ASSERT_NE(radius, nullptr);
  EXPECT_GT(radius->max.x - radius->min.x, ImGui::CalcTextSize("40.527344").x);
}

TEST_F(UiCurve, CopiedAndRemovedByKeys) {
  draw_kind(CurveKind::arc, {16, 40}, {80, 40});
  key(ctrl('d'));
  ASSERT_EQ(level().curves.size(), 2u);
  EXPECT_EQ(curve(1), (Curve{Arc{{56, 72}, 40, 24, 88, true}, Curve::Faces::up}));
  EXPECT_EQ(session().choices().curve, 1);
  move(on_canvas("map", {200, 20}));
  key(kKeyDelete);
  ASSERT_EQ(level().curves.size(), 1u) << "the chosen one, with none under the mouse";
  EXPECT_EQ(curve(0), (Curve{Arc{{48, 64}, 40, 16, 80, true}, Curve::Faces::up}));
  move(on_canvas("map", {48, 24}));
  key(kKeyDelete);
  EXPECT_TRUE(level().curves.empty());
}

}  // namespace talus::curve_test
