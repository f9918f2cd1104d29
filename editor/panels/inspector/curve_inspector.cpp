// Fields of curves, by their kinds.
#include "curve_inspector.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "chosen_curve.h"
#include "exact_hint.h"
#include "panels/commands/commands.h"
#include "panels/ui/text_field.h"

namespace talus {
namespace {

constexpr std::size_t kMaxHeights = 65;  // of a polyline; so many heights get a field each

// The numbers of a form, one after another.
class FormFields {
 public:
  // is_refused: the last number was refused, which a message below the fields says: their help would cover
  // it.
  FormFields(const Session& session, NumberEdit& edit, Ui& ui, bool is_refused)
      : session_(session), edit_(edit), ui_(ui), is_refused_(is_refused) {}
  bool changed() const { return changed_; }

  void draw(Segment& s) {
    point("from", "From", s.from);
    point("to", "To", s.to);
  }
  void draw(Arc& a) {
    point("centre", "Centre", a.center);
    row("Radius");
    number("radius", "", a.radius, "The radius of the circle, px.");
    ends(a.x0, a.x1);
    row("");
    if (ImGui::Checkbox("hill", &a.upper)) note_click();
    ui_.item("inspector/curve_upper", "The upper half of its circle; off: the lower half, a bowl.");
  }
  void draw(Parabola& p) {
    point("from", "From", p.from);
    point("to", "To", p.to);
    row("Control");
    number("control", "y ", p.control_y,
           "The y of its control point half way, px; the curve goes half as far.");
  }
  void draw(Cubic& c) {
    point("from", "From", c.from);
    point("to", "To", c.to);
    row("Slope");
    number("from_slope", "", c.from_slope, "How many px it goes down for each px, at its start.", 0.02f);
    number("to_slope", "to ", c.to_slope, "How many px it goes down for each px, at its end.", 0.02f);
  }
  void draw(Sine& s) {
    ends(s.x0, s.x1);
    row("Middle");
    number("middle", "y ", s.middle, "The height about which it swings, px.");
    number("amplitude", "swing ", s.amplitude,
           "How far it swings, px; positive: first down from its origin.");
    row("Wave");
    number("wavelength", "", s.wavelength, "The length of a whole wave, px.");
    number("origin", "at x ", s.origin, "Where it crosses its middle, px.");
  }
  void draw(Polyline& p) {
    ends(p.x0, p.x1);
    row("Heights");
    if (p.ys.size() > kMaxHeights)
      return ui_.hint("It has " + std::to_string(p.ys.size()) + " heights, too many for fields.");
    for (std::size_t i = 0; i < p.ys.size(); ++i)
      number("y" + std::to_string(i), "", p.ys[i], "Its y there, px.");
  }

  void draw_conveyor(Curve& curve) {
    row("Conveyor");
    number("conveyor", "", curve.conveyor,
           "How fast its surface goes, px a frame: above it to the right. It carries players, and what rubs "
           "on it where bodies meet.",
           1.0f / 64);
    curve.conveyor = std::clamp(curve.conveyor, -kMaxConveyor, kMaxConveyor);
  }

 private:
  // Begins a row with this label.
  void row(std::string_view label) {
    ui_.field_label(label);
    is_first_ = true;
  }
  // text: in the field, before the number.
  void number(const std::string& part, const std::string& text, double& value, std::string_view help,
              float speed = 1) {
    if (!is_first_) ui_.same_line_if_fits(ui_.px(kFormField));
    is_first_ = false;
    const std::string name = "inspector/curve_" + part, format = text + "%.8g";
    if (is_refused_) help = {};
    changed_ |=
        draw_number_field({name, format.c_str(), help, kFormField, speed}, value, session_, edit_, ui_);
  }
  void point(const std::string& part, std::string_view label, Vec2& value) {
    row(label);
    number(part + "_x", "x ", value.x, "px");
    number(part + "_y", "y ", value.y, "px");
  }
  void ends(double& x0, double& x1) {
    row("Ends");
    number("x0", "x ", x0, "Where it begins, px.");
    number("x1", "to x ", x1, "Where it ends, px.");
  }
  void note_click() {
    changed_ = true;
    edit_.stroke = 0;
  }

  const Session& session_;
  NumberEdit& edit_;
  Ui& ui_;
  bool is_refused_;
  bool is_first_ = true;  // in its row
  bool changed_ = false;
};

}  // namespace

void CurveInspector::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_kind(session, actions, ui);
  const int curve = chosen_curve(session);
  if (curve != shown_) problem_.clear();
  if (curve < 0) {
    shown_ = -1;
    ui.hint(session.level().curves.empty()
                ? "No curve yet: drag on the map from one end to the other."
                : "No curve chosen: click one on the map, or drag to draw another.");
    return;
  }
  const CurveKind kind = kind_of(session.level().curves.at(static_cast<std::size_t>(curve)).curve);
  ui.heading("Curve " + std::to_string(curve) + ", " + with_article(kind));
  ui.begin_row();
  draw_name(session, actions, ui, curve);
  draw_faces(session, actions, ui, curve);
  draw_numbers(session, actions, ui, curve);
  ui.end_row();
  if (!problem_.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kError));
    draw_wrapped_text(problem_);
    ImGui::PopStyleColor();
    ui.item("inspector/curve_problem");
  }
  command_text_button("map/duplicate"_command, session, actions, ui, {.widget = "inspector/curve_duplicate"});
  ImGui::SameLine();
  if (ui.text_button("inspector/curve_remove", "Remove", false, "Removes the curve from the level.",
                     keys_of("map/delete"_command, ui))) {
    actions.push_back(action::EditLevel{remove_curve(session.level(), curve)});
    actions.push_back(action::SelectCurve{});
  }
  draw_exact_hint("Curves stop bodies only with the exact solver.", "inspector/exact", session, actions, ui);
  shown_ = curve;
}

void CurveInspector::draw_kind(const Session& session, Actions& actions, Ui& ui) const {
  const Choices& choices = session.choices();
  ui.begin_row();
  ui.label("A drag draws");
  ImGui::SameLine();
  if (choices.map_tool == MapTool::segment) {
    ui.label("a segment");
  } else if (ui.begin_combo("inspector/curve_kind", std::string(label_of(choices.curve_kind)), ui.px(108),
                            "The kind of the next curve; the tool's key goes on to the next one.")) {
    for (int i = 0; i < kCurveKindCount; ++i) {
      const auto kind = static_cast<CurveKind>(i);
      const std::string label(label_of(kind));
      if (selectable(label, {}, kind == choices.curve_kind)) actions.push_back(action::SetCurveKind{kind});
      ui.item("inspector/curve_kind_" + label);
    }
    ImGui::EndCombo();
  }
  ui.end_row();
}

void CurveInspector::draw_name(const Session& session, Actions& actions, Ui& ui, int curve) {
  LevelCurve named = session.level().curves.at(static_cast<std::size_t>(curve));
  if (curve != shown_) name_ = named.name;
  if (!draw_text_field(
          {"Name", "inspector/curve_name", "no name", "Its name, which the debugger's sentences use, too."},
          name_, named.name, ui))
    return;
  named.name = name_;
  change(session, actions, curve, std::move(named), "Name a curve", 0);
}

void CurveInspector::draw_faces(const Session& session, Actions& actions, Ui& ui, int curve) {
  constexpr std::array<std::string_view, 3> kFaces = {"up", "down", "both ways"};
  LevelCurve changed = session.level().curves.at(static_cast<std::size_t>(curve));
  const auto now = static_cast<std::size_t>(changed.curve.faces);
  ui.field_label("Faces");
  if (ui.begin_combo("inspector/curve_faces", std::string(kFaces[now]), ui.px(108),
                     "From which side it stops bodies: up is a floor, down a ceiling; of an upright segment, "
                     "up is left.")) {
    for (std::size_t i = 0; i < kFaces.size(); ++i) {
      if (selectable(kFaces[i], {}, i == now) && i != now) {
        changed.curve.faces = static_cast<Curve::Faces>(i);
        change(session, actions, curve, changed, "Turn a curve's face", 0);
      }
      ui.item("inspector/curve_faces" + std::to_string(i));
    }
    ImGui::EndCombo();
  }
}

void CurveInspector::draw_numbers(const Session& session, Actions& actions, Ui& ui, int curve) {
  LevelCurve changed = session.level().curves.at(static_cast<std::size_t>(curve));
  FormFields fields(session, number_, ui, !problem_.empty());
  std::visit([&](auto& form) { fields.draw(form); }, changed.curve.form);
  fields.draw_conveyor(changed.curve);
  if (fields.changed())
    change(session, actions, curve, std::move(changed), "Change a curve's numbers", number_.stroke);
}

void CurveInspector::change(const Session& session, Actions& actions, int curve, LevelCurve changed,
                            std::string label, int stroke) {
  auto edit = change_curve(session.level(), curve, std::move(changed), std::move(label));
  problem_ = edit ? std::string() : "Not changed: " + edit.error() + ".";
  if (edit) actions.push_back(action::EditLevel{*std::move(edit), stroke});
}

}  // namespace talus
