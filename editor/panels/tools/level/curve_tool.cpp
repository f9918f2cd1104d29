// The tools for segments and curves: draw a curve, choose one and move it, or drag one of its handles.
#include <algorithm>
#include <cmath>
#include <string>

#include "edit/curve_tools.h"
#include "edit/snap.h"
#include "level/transform.h"
#include "level_tools.h"
#include "panels/canvas/curve_drawing.h"
#include "panels/inspector/chosen_curve.h"

namespace talus {
namespace {

constexpr double kHandleReach = 7, kLineReach = 5;  // px of the screen
constexpr int kTitleParts = 64;                     // of a curve, to see whether it is in sight
constexpr double kStill = 3;                        // px of the screen: a shorter movement is not a drag

SnapRules rules_of(const CanvasView& view, int without_curve = -1) {
  const ImGuiIO& io = ImGui::GetIO();
  return {.zoom = view.zoom, .off = io.KeyAlt, .halves = io.KeyCtrl, .without_curve = without_curve};
}

// Where an end of a curve goes with the mouse: ends stay on the map.
SnappedPoint end_at(const LevelToolUse& use, int without_curve = -1) {
  const Level& level = use.session.level();
  return snap(level, onto_map(level.map, use.at), rules_of(use.view, without_curve));
}

CurveKind kind_to_draw(const Choices& choices) {
  return choices.map_tool == MapTool::segment ? CurveKind::segment : choices.curve_kind;
}

const LevelCurve& curve_of(const Session& session, int index) {
  return session.level().curves[static_cast<std::size_t>(index)];
}

// The handle of a curve nearest to a point; -1 if none is within reach.
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

// What a press would grab.
struct Grip {
  int curve = -1;   // -1: nothing, a line would begin
  int handle = -1;  // of the chosen curve; -1: the whole curve
};
Grip grip_at(const LevelToolUse& use) {
  if (ImGui::GetIO().KeyShift) return {};
  if (const int chosen = chosen_curve(use.session); chosen >= 0) {
    const int handle = handle_at(curve_of(use.session, chosen).curve, use.at, kHandleReach / use.view.zoom);
    if (handle >= 0) return {chosen, handle};
  }
  return {curve_at(use.session.level(), use.at, kLineReach / use.view.zoom), -1};
}

// For the chosen curve, if any part of it is in sight.
void draw_title(const CurvePen& pen, const LevelToolUse& use, int index) {
  const Curve& curve = curve_of(use.session, index).curve;
  const Rect visible = use.view.visible();
  const std::vector<Vec2> points = points_of(curve, visible.x, visible.right(), kTitleParts);
  const auto [top, bottom] =
      std::minmax_element(points.begin(), points.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
  if (points.empty() || top->y > visible.bottom() || bottom->y < visible.y) return;
  const ImVec2 beside = use.view.to_screen(handles_of(curve)[0]);
  pen.title(title_of(use.session.level(), index), beside, theme::kAccent);
  use.ui.place("map/chosen_curve", beside, beside);
}

class CurveTool : public LevelTool {
 public:
  bool press(const LevelToolUse& use, Actions& actions) override;
  void drag(const LevelToolUse& use, Actions& actions) override;
  void release(const LevelToolUse& use, Actions& actions) override;
  void cancel(const LevelToolUse& use, Actions& actions) override;
  // Draws the chosen curve with its handles, which are registered as "map/curve_handle0" and so on, and, if
  // the mouse is over the canvas, what a press would grab or begin.
  void draw(ImDrawList& list, const LevelToolUse& use) const override;

 private:
  enum class Drag { none, line, handle, whole };

  SnappedPoint handle_goes_to(const LevelToolUse& use) const;
  LevelCurve changed(const LevelToolUse& use) const;
  void finish_line(const LevelToolUse& use, Actions& actions) const;
  void draw_new_line(ImDrawList& list, const LevelToolUse& use) const;

  Drag drag_ = Drag::none;
  Vec2 from_;           // px, where a line begins, or where a curve or handle was grabbed
  bool moved_ = false;  // further than a shaking hand
  Grip held_;
  LevelCurve before_;    // the held curve before the drag
  std::string problem_;  // why the curve cannot be at the mouse; empty: it can
};

bool CurveTool::press(const LevelToolUse& use, Actions& actions) {
  moved_ = false;
  problem_.clear();
  held_ = grip_at(use);
  if (held_.curve < 0) {
    drag_ = Drag::line;
    from_ = end_at(use).point;
    return true;
  }
  drag_ = held_.handle >= 0 ? Drag::handle : Drag::whole;
  from_ = use.at;
  before_ = curve_of(use.session, held_.curve);
  actions.push_back(action::SelectCurve{held_.curve});
  return true;
}

void CurveTool::drag(const LevelToolUse& use, Actions& actions) {
  const Level& level = use.session.level();
  const bool is_gone = held_.curve >= static_cast<int>(level.curves.size());  // by Undo
  if (drag_ != Drag::line && is_gone) drag_ = Drag::none;
  moved_ = moved_ || std::hypot(use.at.x - from_.x, use.at.y - from_.y) * use.view.zoom > kStill;
  if (drag_ == Drag::none || drag_ == Drag::line || !moved_) return;
  LevelCurve curve = changed(use);
  problem_.clear();
  if (curve == curve_of(use.session, held_.curve)) return;
  auto edit = change_curve(level, held_.curve, std::move(curve),
                           (drag_ == Drag::handle ? "Bend a curve: " : "Move a curve: ") +
                               std::string(label_of(kind_of(before_.curve))));
  if (edit)
    actions.push_back(action::EditLevel{*std::move(edit), use.stroke});
  else
    problem_ = edit.error();
}

SnappedPoint CurveTool::handle_goes_to(const LevelToolUse& use) const {
  if (is_end_handle(before_.curve, held_.handle)) return end_at(use, held_.curve);
  return snap(use.session.level(), use.at, rules_of(use.view, held_.curve));
}

// The held curve with the handle, or all of it, at the mouse.
LevelCurve CurveTool::changed(const LevelToolUse& use) const {
  LevelCurve result = before_;
  if (drag_ == Drag::handle) {
    result.curve = with_handle(before_.curve, held_.handle, handle_goes_to(use).point);
  } else {
    const Vec2 end = ends_of_curve(before_.curve).first;
    const SnapRules rules = rules_of(use.view, held_.curve);
    result.curve = moved(before_.curve, snap(use.session.level(), end + use.at - from_, rules).point - end);
  }
  return result;
}

void CurveTool::release(const LevelToolUse& use, Actions& actions) {
  const bool draws_line = drag_ == Drag::line, is_click = !moved_;
  drag_ = Drag::none;
  if (!draws_line) {
    if (!problem_.empty())
      actions.push_back(
          action::ShowMessage{capitalized(problem_) + " there, so it stays where it was last valid.", true});
  } else if (is_click && use.session.choices().curve >= 0) {  // beside a curve
    actions.push_back(action::SelectCurve{});
  } else {
    finish_line(use, actions);
  }
}

void CurveTool::cancel(const LevelToolUse& use, Actions& actions) {
  LevelTool::cancel(use, actions);
  drag_ = Drag::none;
  problem_.clear();
}

void CurveTool::finish_line(const LevelToolUse& use, Actions& actions) const {
  const Level& level = use.session.level();
  const CurveKind kind = kind_to_draw(use.session.choices());
  const Vec2 to = end_at(use).point;
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

void CurveTool::draw(ImDrawList& list, const LevelToolUse& use) const {
  const Session& session = use.session;
  const CurvePen pen(list, use.view, use.ui.px(2));
  const bool active = drag_ != Drag::none;
  const Grip grip = active ? held_ : use.hovered ? grip_at(use) : Grip{};
  const int chosen = chosen_curve(session);
  if (use.hovered && !active && grip.curve >= 0 && grip.curve != chosen) {
    pen.stroke(curve_of(session, grip.curve).curve, theme::color(theme::kWarning));
    pen.title(title_of(session.level(), grip.curve), use.view.to_screen(use.at), theme::kText);
  }
  if (chosen >= 0) {
    const Curve& curve = curve_of(session, chosen).curve;
    pen.stroke(curve, theme::color(theme::kAccent));
    pen.handles(curve, grip.curve == chosen ? grip.handle : -1, use.ui);
    draw_title(pen, use, chosen);
  }
  if (drag_ == Drag::line || (use.hovered && grip.curve < 0)) return draw_new_line(list, use);
  if (drag_ == Drag::handle) pen.snapped(handle_goes_to(use), use.ui);
  if (!problem_.empty()) pen.title(problem_, ImGui::GetIO().MousePos, theme::kError);
}

void CurveTool::draw_new_line(ImDrawList& list, const LevelToolUse& use) const {
  const Session& session = use.session;
  const CurvePen pen(list, use.view, use.ui.px(2));
  const SnappedPoint to = end_at(use);
  const CurveKind kind = kind_to_draw(session.choices());
  if (drag_ == Drag::line && from_ != to.point) {
    const Curve curve = curve_between(kind, from_, to.point, use.session.level().map.tile_size());
    if (const auto problem = problem_of(curve, session.level().map)) {
      pen.line(from_, to.point, theme::color(theme::kError));
      pen.title("the " + std::string(label_of(kind)) + " " + *problem, ImGui::GetIO().MousePos,
                theme::kError);
    } else {
      pen.stroke(curve, theme::color(theme::kAccent));
    }
    pen.snapped({from_, SnappedPoint::To::pixel}, use.ui);
  }
  const bool says_kind = drag_ == Drag::none && session.choices().map_tool == MapTool::curve;
  pen.snapped(to, use.ui, says_kind ? label_of(kind) : "");
}

}  // namespace

std::unique_ptr<LevelTool> make_curve_tool() { return std::make_unique<CurveTool>(); }

}  // namespace talus
