// Drawing, choosing and bending curves.
#include "curve_gesture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "curve_drawing.h"
#include "level/transform.h"

namespace talus {
namespace {

constexpr double kHandleReach = 7, kLineReach = 5;  // px of the screen
constexpr double kStill = 3;                        // px of the screen: less is no drag

SnapRules rules_of(const CanvasView& view, int without_curve = -1) {
  const ImGuiIO& io = ImGui::GetIO();
  return {.zoom = view.zoom, .off = io.KeyAlt, .halves = io.KeyCtrl, .without_curve = without_curve};
}

CurveKind kind_to_draw(const Choices& choices) {
  return choices.map_tool == MapTool::segment ? CurveKind::segment : choices.curve_kind;
}

const LevelCurve& curve_of(const Session& session, int index) {
  return session.level().curves[static_cast<std::size_t>(index)];
}

// The handle of a curve nearest to a point; -1: none within reach.
int handle_at(const Curve& curve, Vec2 at, double reach) {
  int found = -1, number = 0;
  for (const Vec2 handle : handles_of(curve)) {
    const double distance = std::hypot(handle.x - at.x, handle.y - at.y);
    if (distance <= reach) {
      found = number;
      reach = distance;
    }
    ++number;
  }
  return found;
}

// What a press would take.
struct Grip {
  int curve = -1;   // -1: nothing, a line would begin
  int handle = -1;  // of the chosen curve; -1: the whole curve
};
Grip grip_at(const Session& session, const CanvasView& view, Vec2 at) {
  if (ImGui::GetIO().KeyShift) return {};
  if (const int chosen = chosen_curve(session); chosen >= 0) {
    const int handle = handle_at(curve_of(session, chosen).curve, at, kHandleReach / view.zoom);
    if (handle >= 0) return {chosen, handle};
  }
  return {curve_at(session.level(), at, kLineReach / view.zoom), -1};
}

std::string capitalized(std::string_view text) {
  std::string result(text);
  if (!result.empty() && result[0] >= 'a' && result[0] <= 'z') result[0] = static_cast<char>(result[0] - 32);
  return result;
}

}  // namespace

int chosen_curve(const Session& session) {
  const int chosen = session.choices().curve;
  const Level& level = session.level();
  if (chosen < 0 || chosen >= static_cast<int>(level.curves.size())) return -1;
  return problem_of(curve_of(session, chosen).curve, level.map) ? -1 : chosen;
}

void delete_curve(const Session& session, Actions& actions, const Ui& ui) {
  constexpr double kReach = 4;  // px
  const auto at = ui.view.hover.pixel;
  int curve = at ? curve_at(session.level(), *at, kReach) : -1;
  if (curve < 0) curve = chosen_curve(session);
  if (curve < 0) return;
  actions.push_back(action::EditLevel{remove_curve(session.level(), curve)});
  actions.push_back(action::SelectCurve{});
}

void CurveGesture::update(const Session& session, Actions& actions, const CanvasView& view, Vec2 at,
                          bool pressed, bool down) {
  if (pressed) begin(session, actions, view, at);
  const bool is_gone = curve_ >= static_cast<int>(session.level().curves.size());  // by Undo
  if (drag_ != Drag::line && is_gone) drag_ = Drag::none;
  if (drag_ == Drag::none) return;
  moved_ = moved_ || std::hypot(at.x - from_.x, at.y - from_.y) * view.zoom > kStill;
  if (!down) {
    finish(session, actions, view, at);
    drag_ = Drag::none;
  } else if (drag_ != Drag::line && moved_) {
    drag_on(session, actions, view, at);
  }
}

void CurveGesture::begin(const Session& session, Actions& actions, const CanvasView& view, Vec2 at) {
  const Grip grip = grip_at(session, view, at);
  moved_ = false;
  problem_.clear();
  curve_ = grip.curve;
  handle_ = grip.handle;
  stroke_ = session.next_stroke();
  if (grip.curve < 0) {
    drag_ = Drag::line;
    from_ = snap(session.level(), at, rules_of(view)).point;
    return;
  }
  drag_ = grip.handle >= 0 ? Drag::handle : Drag::whole;
  from_ = at;
  before_ = curve_of(session, grip.curve);
  actions.push_back(action::SelectCurve{grip.curve});
}

void CurveGesture::drag_on(const Session& session, Actions& actions, const CanvasView& view, Vec2 at) {
  const Level& level = session.level();
  LevelCurve changed = before_;
  std::string label(label_of(kind_of(before_.curve)));
  if (drag_ == Drag::handle) {
    changed.curve = with_handle(before_.curve, handle_, snap(level, at, rules_of(view, curve_)).point);
    label = "Bend a curve: " + label;
  } else {
    const Vec2 end = ends_of_curve(before_.curve).first;
    changed.curve = moved(before_.curve, snap(level, end + at - from_, rules_of(view, curve_)).point - end);
    label = "Move a curve: " + label;
  }
  if (changed == curve_of(session, curve_)) {
    problem_.clear();
    return;
  }
  auto edit = change_curve(level, curve_, std::move(changed), std::move(label));
  problem_ = edit ? std::string() : edit.error();
  if (edit) actions.push_back(action::EditLevel{*std::move(edit), stroke_});
}

void CurveGesture::finish(const Session& session, Actions& actions, const CanvasView& view, Vec2 at) {
  if (drag_ != Drag::line) {
    if (!problem_.empty())
      actions.push_back(
          action::ShowMessage{capitalized(problem_) + " there, so it stays where it was last good.", true});
    return;
  }
  if (!moved_ && session.choices().curve >= 0) {  // a click beside a curve
    actions.push_back(action::SelectCurve{});
    return;
  }
  const Level& level = session.level();
  const CurveKind kind = kind_to_draw(session.choices());
  const Vec2 to = snap(level, at, rules_of(view)).point;
  auto edit = add_curve(level, kind, from_, to);
  if (!edit) {
    actions.push_back(action::ShowMessage{capitalized(label_of(kind)) + " from " + position_text(from_) +
                                              " to " + position_text(to) + ": " + edit.error() + ".",
                                          true});
    return;
  }
  actions.push_back(action::EditLevel{*std::move(edit)});
  actions.push_back(action::SelectCurve{static_cast<int>(level.curves.size())});
}

void CurveGesture::draw(ImDrawList& list, const Session& session, const CanvasView& view, Ui& ui, Vec2 at,
                        bool hovered) const {
  const CurvePen pen(list, view, ui.px(2));
  const Grip grip = active() ? Grip{curve_, handle_} : hovered ? grip_at(session, view, at) : Grip{};
  const int chosen = chosen_curve(session);
  if (hovered && !active() && grip.curve >= 0 && grip.curve != chosen) {
    pen.stroke(curve_of(session, grip.curve).curve, theme::color(theme::kWarning));
    pen.title(title_of(session.level(), grip.curve), view.to_screen(at), theme::kText);
  }
  if (chosen >= 0) {
    const Curve& curve = curve_of(session, chosen).curve;
    pen.stroke(curve, theme::color(theme::kAccent));
    pen.handles(curve, grip.curve == chosen ? grip.handle : -1, ui);
    pen.title(title_of(session.level(), chosen), view.to_screen(handles_of(curve)[0]), theme::kAccent);
  }
  if (drag_ == Drag::line || (hovered && grip.curve < 0)) return draw_new_line(list, session, view, ui, at);
  if (drag_ == Drag::handle) pen.snapped(snap(session.level(), at, rules_of(view, curve_)), ui);
  if (!problem_.empty()) pen.title(problem_, ImGui::GetIO().MousePos, theme::kError);
}

void CurveGesture::draw_new_line(ImDrawList& list, const Session& session, const CanvasView& view,
                                 const Ui& ui, Vec2 at) const {
  const CurvePen pen(list, view, ui.px(2));
  const SnappedPoint to = snap(session.level(), at, rules_of(view));
  const CurveKind kind = kind_to_draw(session.choices());
  if (drag_ == Drag::line && from_ != to.point) {
    const Curve curve = curve_between(kind, from_, to.point);
    if (const auto problem = problem_of(curve, session.level().map)) {
      pen.line(from_, to.point, theme::color(theme::kError));
      pen.title("the " + std::string(label_of(kind)) + " " + *problem, ImGui::GetIO().MousePos,
                theme::kError);
    } else {
      pen.stroke(curve, theme::color(theme::kAccent));
    }
    pen.snapped({from_, SnappedPoint::To::pixel}, ui);
  }
  const bool says_kind = drag_ == Drag::none && session.choices().map_tool == MapTool::curve;
  pen.snapped(to, ui, says_kind ? label_of(kind) : "");
}

}  // namespace talus
