// A row for each plot: its text, its value, and its curve.
#include "plots_panel.h"

#include <algorithm>
#include <cmath>

#include "debug/metrics.h"
#include "overlay/number_label.h"
#include "panels/commands/body_hint.h"
#include "panels/commands/commands.h"
#include "plot.h"

namespace talus {
namespace {

constexpr float kTextWidth = 190, kRowHeight = 40;  // px at scale 1

// Colours of Okabe and Ito, in turn.
ImU32 color_of(std::size_t index) {
  constexpr std::uint32_t kColors[] = {0x56b4e9, 0xe69f00, 0x009e73, 0xf0e442, 0xcc79a7, 0xd55e00};
  return theme::color(kColors[index % std::size(kColors)]);
}

std::string value_text(const PlotList::Entry& entry, double value) {
  if (std::isnan(value)) return "-";
  if (entry.expression->type() == ValueType::truth) return value != 0 ? "true" : "false";
  return two_decimals(value);
}

std::string text_name(std::size_t index) { return "plots/" + std::to_string(index) + "/text"; }

}  // namespace

void PlotsPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_add(session, actions, ui);
  if (session.debugger().plots().all().empty() && !ui.view.debugger.shows_times) {
    ui.hint(
        "No plot yet: choose a number, or type an expression. Each is plotted over the whole branch, "
        "for the chosen body; a click on a plot shows that frame.");
    return;
  }
  if (session.choices().body == 0) draw_body_hint(" to plot it", "plots", session, actions, ui);
  draw_rows(session, actions, ui);
}

void PlotsPanel::draw_add(const Session& session, Actions& actions, Ui& ui) {
  const std::size_t next = session.debugger().plots().all().size();
  ui.begin_row();
  if (ui.begin_combo("plots/choose", "plot...", ui.px(110), "Numbers of a body to plot.")) {
    for (const MetricInfo& info : metric_infos()) {
      if (info.metric == Metric::id) continue;
      if (selectable(info.name, {}, false))
        actions.push_back(action::SetPlot{next, {std::string(info.name), 0}});
      ui.item("plots/choose_" + std::string(info.name), info.help);
    }
    const Command& times = find_command("plots/choose_times"_command);
    if (ImGui::Selectable("ns a step", ui.view.debugger.shows_times)) times.run(session, actions, ui);
    ui.item("plots/choose_times", times.help, keys_of(times, ui));
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  if (new_field_.draw("plots/new", new_text_, false, ui.px(300), "or an expression: max(vx, vy) * 2", ui) &&
      !new_text_.empty()) {
    actions.push_back(action::SetPlot{next, {new_text_, 0}});
    new_text_.clear();
    if (new_field_.by_enter()) ui.ask(request::FocusField("plots/new"));  // so that the next one can be typed
  }
  if (new_field_.way() == FieldWay::down && next > 0) ui.ask(request::FocusField(text_name(0)));
  ui.end_row();
}

void PlotsPanel::draw_rows(const Session& session, Actions& actions, Ui& ui) {
  ImGui::BeginChild("rows");
  for (std::size_t i = 0; i < session.debugger().plots().all().size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    draw_row(i, session, actions, ui);
    ImGui::PopID();
  }
  if (ui.view.debugger.shows_times) draw_times(session, actions, ui);
  ImGui::EndChild();
}

void PlotsPanel::draw_row(std::size_t index, const Session& session, Actions& actions, Ui& ui) {
  const PlotList::Entry& entry = session.debugger().plots().all()[index];
  const std::string name = "plots/" + std::to_string(index);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::SmallButton("x")) actions.push_back(action::RemovePlot{index});
  ui.item(name + "/remove", "Removes it.", "Enter in its emptied field");
  ImGui::SameLine();
  ImGui::PushStyleColor(ImGuiCol_Text, color_of(index));
  draw_text(index, session, actions, ui);
  ImGui::PopStyleColor();
  const Row& row = rows_[index];
  if (row.field.is_open()) return;  // the typed text and its message take the room of the plot
  if (entry.expression && row.text == entry.plot.text) {
    const double value = PlotList::value(entry, session.frame_view(), session.choices().body);
    ImGui::SetCursorScreenPos({at.x + ui.px(18), at.y + ImGui::GetFrameHeight() + ui.px(1)});
    talus::draw_text(value_text(entry, value));
    ui.item(name + "/value", all_digits(value), "click to copy");
    if (ImGui::IsItemClicked()) ImGui::SetClipboardText(all_digits(value).c_str());
  }
  draw_curve(name, session.debugger().plots().series(entry), color_of(index), at, session, actions, ui);
}

void PlotsPanel::draw_text(std::size_t index, const Session& session, Actions& actions, Ui& ui) {
  const auto& all = session.debugger().plots().all();
  const PlotList::Entry& entry = all[index];
  if (rows_.size() < all.size()) rows_.resize(all.size());
  Row& row = rows_[index];
  if (row.shown != entry.plot.text) row.text = row.shown = entry.plot.text;
  const bool entered =
      row.field.draw(text_name(index), row.text, false, ui.px(kTextWidth - 34), "Enter removes it", ui);
  if (row.field.by_enter() &&
      !ui.view.requests.has<request::FocusField>())  // the next typed text is not a command
    ui.ask(request::FocusField(row.text.empty() ? "plots/new" : text_name(index)));
  if (entered && row.text.empty()) {
    actions.push_back(action::RemovePlot{index});
  } else if (entered && row.text != entry.plot.text) {
    actions.push_back(action::SetPlot{index, {row.text, entry.plot.body}});
  } else if (row.text.empty() && !row.field.is_open()) {
    row.text = entry.plot.text;
  }
  if (row.field.way() == FieldWay::up)
    ui.ask(request::FocusField(index == 0 ? "plots/new" : text_name(index - 1)));
  if (row.field.way() == FieldWay::down && index + 1 < all.size())
    ui.ask(request::FocusField(text_name(index + 1)));
}

// The time of the steps. It was measured when they were made, so no expression can compute it.
void PlotsPanel::draw_times(const Session& session, Actions& actions, Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  if (ImGui::SmallButton("x")) ui.view.debugger.shows_times = false;
  ui.item("plots/times/remove", "Stops showing it.", keys_of("plots/choose_times"_command, ui));
  ImGui::SameLine();
  ImGui::TextUnformatted("ns a step");
  ui.tooltip("Nanoseconds that each step took when it was made last, of all bodies together.");
  draw_curve("plots/times", session.step_times().series(), theme::tone(theme::kText), at, session, actions,
             ui);
}

void PlotsPanel::draw_curve(const std::string& name, const Series* series, ImU32 color, ImVec2 at,
                            const Session& session, Actions& actions, Ui& ui) {
  ImGui::SetCursorScreenPos({at.x + ui.px(kTextWidth), at.y});
  draw_timeline_plot(name + "/plot", "", series, color, ui.px(kRowHeight), session, actions, ui);
  ImGui::SetCursorScreenPos({at.x, at.y + ui.px(kRowHeight + 3)});
  ImGui::Dummy({0, 0});
}

}  // namespace talus
