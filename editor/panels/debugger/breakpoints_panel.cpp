// The list of breakpoints, with the controls that add one and run to one.
#include "breakpoints_panel.h"

#include <algorithm>
#include <string>
#include <utility>

#include "panels/commands/commands.h"
#include "panels/ui/text_focus.h"
#include "typed_condition.h"

namespace talus {
namespace {

constexpr float kConditionWidth = 240;  // px at scale 1, at least

const BreakpointKindInfo& info_of(BreakpointKind kind) {
  return breakpoint_kind_infos()[static_cast<std::size_t>(kind)];
}

std::size_t field_count(const BreakpointKindInfo& info) {
  return static_cast<std::size_t>(
      std::count_if(info.fields.begin(), info.fields.end(),
                    [](const BreakpointField& field) { return !field.label.empty(); }));
}

bool is_about_place(BreakpointKind kind) {
  return kind == BreakpointKind::touches_tile || kind == BreakpointKind::enters_cell ||
         kind == BreakpointKind::enters_rect;
}

bool has_stopped(const Session& session, const Breakpoint& breakpoint) {
  const auto& stop = session.debugger().stop();
  return stop && stop->breakpoint == breakpoint.id && stop->frame == session.state().frame;
}

std::string condition_name(int breakpoint) {
  return "breakpoints/" + std::to_string(breakpoint) + "/condition";
}

// The field that a key moves to from this condition.
std::string next_field(const std::vector<Breakpoint>& all, const Breakpoint& from, FieldWay way) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const Breakpoint& b) { return b.id == from.id; });
  if (way == FieldWay::on) return "breakpoints/" + std::to_string(from.id) + "/body";
  if (way == FieldWay::up) return at == all.begin() ? "breakpoints/new" : condition_name((at - 1)->id);
  return condition_name(at + 1 == all.end() ? from.id : (at + 1)->id);
}

}  // namespace

void BreakpointsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_run(session, actions, ui);
  draw_add(session, actions, ui);
  if (session.debugger().breakpoints().all().empty()) {
    ui.hint(
        "No breakpoint yet. Choose a kind and add it, or type a condition. The game stops there while it "
        "runs, and you can run back to the last frame in which the condition began to hold.");
    return;
  }
  draw_list(session, actions, ui);
}

void BreakpointsPanel::draw_run(const Session& session, Actions& actions, Ui& ui) {
  const Breakpoints& breakpoints = session.debugger().breakpoints();
  command_button("breakpoints/back"_command, session, actions, ui);
  ImGui::SameLine();
  command_button("breakpoints/forwards"_command, session, actions, ui);
  ImGui::SameLine();
  if (session.debugger().searching()) {
    const int percent = static_cast<int>(session.debugger().search_progress() * 100);
    if (ui.text_button("breakpoints/cancel", "searching " + std::to_string(percent) + " %  x", false,
                       "Stops searching; the shown frame stays.", keys_of("timeline/cancel"_command, ui)))
      actions.push_back(action::CancelSearch{});
    return;
  }
  if (session.debugger().stop()) {
    ui.label(text_of(*session.debugger().stop()));
  } else if (session.debugger().search_failed() && !breakpoints.all().empty()) {
    ui.label(breakpoints.direction() == SearchDirection::backwards ? "No frame before this one stops."
             : session.playback().running ? "No recorded frame stops: playing on to the next stop."
                                          : "No recorded frame after this one stops.");
  } else {
    ui.label("");
  }
}

void BreakpointsPanel::draw_add(const Session& session, Actions& actions, Ui& ui) {
  fill_in_place(session, ui);
  const BreakpointKindInfo& info = info_of(kind_);
  ui.begin_row();
  if (ui.begin_combo("breakpoints/kind", std::string(info.label), ui.px(190), "The kind of the breakpoint.",
                     keys_of("breakpoints/kind"_command, ui))) {
    for (const BreakpointKindInfo& each : breakpoint_kind_infos()) {
      if (selectable(each.label, {}, each.kind == kind_)) {
        kind_ = each.kind;
        fields_set_ = false;
        if (field_count(each) > 0) ui.ask(request::FocusField("breakpoints/field0"));
      }
      ui.item("breakpoints/kind_" + std::to_string(static_cast<int>(each.kind)));
    }
    ImGui::EndCombo();
  }
  draw_fields(info, session, actions, ui);
  ui.same_line_if_fits(ui.px(48), ui.px(8));
  const int body = session.choices().body;
  const bool by_key = ui.view.requests.take<request::FocusField>("breakpoints/add");
  if (ui.text_button(
          "breakpoints/add", "Add", false,
          body != 0 ? "Adds this breakpoint for the chosen body." : "Adds this breakpoint for any body.",
          keys_of("breakpoints/add"_command, ui)) ||
      by_key)
    actions.push_back(
        action::SetBreakpoint{{.condition = condition_of(kind_, std::span(fields_).first(field_count(info))),
                               .body = body,
                               .each_frame = info.each_frame}});
  ui.same_line_if_fits(ui.px(kConditionWidth), ui.px(16));
  std::string& typed = ui.view.debugger.new_condition;
  if (new_field_.draw("breakpoints/new", typed, true, -1, "or a condition: vy > 3 && grounded", ui) &&
      !typed.empty()) {
    add_breakpoint(typed, session, actions);
    typed.clear();
  }
  ui.end_row();
  const auto& all = session.debugger().breakpoints().all();
  if (new_field_.way() == FieldWay::down && !all.empty())
    ui.ask(request::FocusField(condition_name(all.front().id)));
}

// The numbers of the chosen kind.
void BreakpointsPanel::draw_fields(const BreakpointKindInfo& info, const Session& session, Actions& actions,
                                   Ui& ui) {
  for (std::size_t i = 0; i < field_count(info); ++i) {
    const BreakpointField& field = info.fields[i];
    const std::string name = "breakpoints/field" + std::to_string(i);
    ui.same_line_if_fits(ui.px(110));
    ImGui::SetNextItemWidth(ui.px(64));
    take_text_focus(name, ui);
    if (ImGui::InputDouble(("##field" + std::to_string(i)).c_str(), &fields_[i], 0, 0, "%.6g"))
      fields_typed_ = true;
    ui.item(name, std::string(field.label) + (field.unit.empty() ? "" : ", " + std::string(field.unit)),
            "Tab: the next one");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ui.muted(field.label);
  }
  if (!is_about_place(kind_)) return;
  ui.same_line_if_fits(ui.px(theme::kButton));
  command_button("breakpoints/pick"_command, session, actions, ui);
}

// A kind begins with its defaults; a kind about a place begins with what is selected or was clicked last.
void BreakpointsPanel::fill_in_place(const Session& session, Ui& ui) {
  const bool is_picking = ui.view.debugger.picks_cell || ui.view.requests.has<request::PutBreakpointAt>();
  if (is_picking && !is_about_place(kind_)) {
    kind_ = BreakpointKind::touches_tile;
    fields_set_ = false;
  }
  if (!fields_set_) {
    fields_typed_ = false;
    for (std::size_t i = 0; i < fields_.size(); ++i) fields_[i] = info_of(kind_).fields[i].standard;
  }
  fields_set_ = true;
  if (const auto picked = ui.view.requests.take<request::PutBreakpointAt>()) {
    put_place({picked->cell.x, picked->cell.y, 1, 1}, session.level().map);
    fields_typed_ = true;
  } else if (!is_about_place(kind_) || fields_typed_) {
    return;
  } else if (const auto selected = session.choices().selection) {
    put_place(*selected, session.level().map);
  } else if (const auto& clicked = ui.view.canvas.clicked_cell) {
    put_place({clicked->x, clicked->y, 1, 1}, session.level().map);
  }
}

void BreakpointsPanel::put_place(CellRect cells, const TileMap& map) {
  if (kind_ == BreakpointKind::enters_rect)
    fields_ = {map.x_of(cells.x), map.y_of(cells.y), map.x_of(cells.w), map.y_of(cells.h)};
  else
    fields_ = {1.0 * cells.x, 1.0 * cells.y, 1.0 * cells.w, 1.0 * cells.h};
}

void BreakpointsPanel::draw_list(const Session& session, Actions& actions, Ui& ui) {
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY;
  if (!ImGui::BeginTable("breakpoints", 7, kFlags, ImGui::GetContentRegionAvail())) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("no.", ImGuiTableColumnFlags_WidthFixed, ui.px(24));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ui.px(24));
  ImGui::TableSetupColumn("stops when", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableSetupColumn("body", ImGuiTableColumnFlags_WidthFixed, ui.px(44));
  ImGui::TableSetupColumn("from hit", ImGuiTableColumnFlags_WidthFixed, ui.px(60));
  ImGui::TableSetupColumn("hits", ImGuiTableColumnFlags_WidthFixed, ui.px(40));
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, ui.px(24));
  ImGui::TableHeadersRow();
  for (const Breakpoint& breakpoint : session.debugger().breakpoints().all()) {
    ImGui::PushID(breakpoint.id);
    draw_row(breakpoint, session, actions, ui);
    ImGui::PopID();
  }
  ImGui::EndTable();
}

void BreakpointsPanel::draw_row(const Breakpoint& breakpoint, const Session& session, Actions& actions,
                                Ui& ui) {
  const std::string name = "breakpoints/" + std::to_string(breakpoint.id);
  Breakpoint changed = breakpoint;
  const bool stopped = has_stopped(session, breakpoint);
  ImGui::TableNextRow();
  if (stopped) ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, theme::tone(theme::kAccent, 60));
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ui.right_aligned(std::to_string(breakpoint.id), theme::tone(stopped ? theme::kAccent : theme::kMuted));
  ui.item(name + (stopped ? "/stopped" : "/number"),
          stopped ? "This one stopped the game at the shown frame." : "Its number, which messages show.");
  ImGui::TableNextColumn();
  ImGui::Checkbox("##enabled", &changed.enabled);
  ui.item(name + "/enabled", "Whether it is switched on.", "Ctrl+Enter in its condition");
  ImGui::TableNextColumn();
  std::string& text = texts_.try_emplace(breakpoint.id, breakpoint.condition).first->second;
  ExpressionField& field = condition_fields_[breakpoint.id];
  const bool entered = field.draw(condition_name(breakpoint.id), text, true, -1, "Enter removes it", ui);
  if (entered && text.empty()) {
    actions.push_back(action::RemoveBreakpoint{breakpoint.id});
  } else if (entered) {
    changed.condition = text;
    changed.enabled = changed.enabled != ImGui::GetIO().KeyCtrl;
  } else if (text.empty() && !field.is_open()) {
    text = breakpoint.condition;
  }
  if (field.way() != FieldWay::none)
    ui.ask(request::FocusField(next_field(session.debugger().breakpoints().all(), breakpoint, field.way())));
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  take_text_focus(name + "/body", ui);
  ImGui::InputInt("##body", &changed.body, 0);
  changed.body = std::max(changed.body, 0);
  ui.item(name + "/body", "The id of the body that the condition is about; 0: any body.");
  ImGui::TableNextColumn();
  ImGui::SetNextItemWidth(-1);
  ImGui::InputInt("##count", &changed.count, 0);
  changed.count = std::max(changed.count, 1);
  ui.item(name + "/count", "Stops at this hit and all later ones; hits are counted from frame 0.");
  ImGui::TableNextColumn();
  const auto hits = session.debugger().breakpoints().hits(breakpoint.id, session.state().frame);
  ui.right_aligned(!breakpoint.enabled ? "-" : hits ? std::to_string(*hits) : "...");
  ui.item(name + "/hits", hits ? "Its hits from frame 0 to the shown frame." : "Its hits are being counted.");
  ImGui::TableNextColumn();
  if (ImGui::SmallButton("x")) actions.push_back(action::RemoveBreakpoint{breakpoint.id});
  ui.item(name + "/remove", "Removes it.", "Enter in its emptied condition");
  if (changed != breakpoint) actions.push_back(action::SetBreakpoint{std::move(changed)});
}

}  // namespace talus
