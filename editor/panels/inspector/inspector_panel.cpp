// The body's numbers and the table of contacts.
#include "inspector_panel.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "chosen_curve.h"
#include "chosen_spawn.h"
#include "debug/explain.h"
#include "edit/spawn_tools.h"
#include "overlay/number_label.h"
#include "panels/commands/body_hint.h"
#include "panels/commands/commands.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

constexpr std::array<const char*, 5> kResponseNames = {"ignore", "touch", "cross", "slide", "bounce"};

std::string_view response_label(Response response) {
  const auto i = static_cast<std::size_t>(response);
  return i < kResponseNames.size() ? kResponseNames[i] : "own";
}

// Short, for the table: "up 12,9".
std::string_view short_role(TileRole role) {
  switch (role) {
    case TileRole::up_slope:
      return "up";
    case TileRole::down_slope:
      return "down";
    case TileRole::ball:
      return "ball";
    default:
      return "solid";
  }
}

// The name of a curve, if it has one.
std::string obstacle_text(const Scene& scene, const Obstacle& other) {
  if (other.body != 0) return "body " + std::to_string(other.body);
  if (other.curve >= 0) return name_of_curve(scene, other.curve);
  return std::string(short_role(other.role)) + " " + std::to_string(other.cell.x) + "," +
         std::to_string(other.cell.y);
}

// A number with two decimals, at the right edge. The tooltip has all digits, and a click copies them.
// meaning: a sentence below the digits.
void draw_number(const char* id, double value, Ui& ui, std::string_view meaning = {}) {
  ImGui::PushID(id);
  const std::string text = two_decimals(value), digits = all_digits(value);
  const float width = size_of_text(text).x, room = ImGui::GetContentRegionAvail().x;
  if (room > width) ImGui::SetCursorPosX(ImGui::GetCursorPosX() + room - width);
  draw_text(text);
  if (ImGui::IsItemClicked()) ImGui::SetClipboardText(digits.c_str());
  ui.tooltip(meaning.empty() ? digits : digits + "\n" + std::string(meaning), "click to copy");
  ImGui::PopID();
}

// The menu of a number of a body, by the right button. expression: of the number, for plots and breakpoints.
struct NumberMenu {
  const Session& session;
  Actions& actions;
  int body;  // id

  void draw(const char* expression, double value, Ui& ui) const {
    const std::string id = std::string("inspector/") + expression;
    ui.item(id);
    if (!ImGui::BeginPopupContextItem(id.c_str())) return;
    if (menu_item("Copy", "copy")) ImGui::SetClipboardText(all_digits(value).c_str());
    ui.item(id + "/copy", "Copies all digits.");
    if (menu_item("Plot this", "plot")) {
      actions.push_back(action::SetPlot{session.debugger().plots().all().size(), {expression, body}});
      show(panel_id::kPlots, ui);
    }
    ui.item(id + "/plot", "Shows the number over the frames.");
    if (menu_item("Stop when it changes", "stop")) {
      Breakpoint breakpoint;
      breakpoint.condition = "changed(" + std::string(expression) + ")";
      breakpoint.body = body;
      actions.push_back(action::SetBreakpoint{breakpoint});
      show(panel_id::kBreakpoints, ui);
    }
    ui.item(id + "/stop", "Adds a breakpoint.");
    ImGui::EndPopup();
  }
  static void show(std::string_view panel, Ui& ui) {
    ui.view.window.dock_open = true;
    ui.ask(request::ShowTab(panel));
  }
};

void draw_text_cell(std::string_view text, Ui& ui, std::string_view meaning = {}) {
  draw_text(text);
  ui.tooltip(meaning.empty() ? text : meaning);
}

std::string_view meaning_of_impact(const ContactRecord& contact) {
  if (contact.overlaps)
    return "The boxes overlapped before the move: minus the area that they shared, px\xc2\xb2.";
  return "Time of impact: the fraction of the move that was done when they met, from 0 to 1.";
}

std::string_view meaning_of_done(const ContactRecord& contact) {
  return contact.handled
             ? "The step acted on this contact."
             : "The step found this contact but did nothing with it, as after a correction onto a slope.";
}

// x, y: the expressions of the two numbers.
void draw_body_row(const char* label, const char* unit, Vec2 v, const NumberMenu& menu, const char* x,
                   const char* y, Ui& ui) {
  ImGui::PushID(label);
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ui.muted(label);
  ImGui::TableNextColumn();
  draw_number("x", v.x, ui);
  menu.draw(x, v.x, ui);
  ImGui::TableNextColumn();
  draw_number("y", v.y, ui);
  menu.draw(y, v.y, ui);
  ImGui::TableNextColumn();
  ui.muted(unit);
  ImGui::PopID();
}

// has_form: a form with its size follows.
void draw_body(const Body& body, bool has_form, const NumberMenu& menu, Ui& ui) {
  if (!ImGui::BeginTable("body", 4, ImGuiTableFlags_SizingFixedFit)) return;
  ImGui::TableSetupColumn("");
  ImGui::TableSetupColumn("x", ImGuiTableColumnFlags_WidthFixed, ui.px(72));
  ImGui::TableSetupColumn("y", ImGuiTableColumnFlags_WidthFixed, ui.px(72));
  ImGui::TableSetupColumn("");
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(1);
  ui.right_aligned("x", theme::tone(theme::kMuted));
  ImGui::TableSetColumnIndex(2);
  ui.right_aligned("y", theme::tone(theme::kMuted));
  draw_body_row("position", "px", body.box.position(), menu, "x", "y", ui);
  draw_body_row("velocity", "px/frame", body.velocity, menu, "vx", "vy", ui);
  if (!has_form) draw_body_row("size", "px", {body.box.w, body.box.h}, menu, "w", "h", ui);
  ImGui::EndTable();
}

struct Column {
  const char* title;
  float width;   // px at scale 1; 0 takes the rest
  bool numbers;  // numbers and their title end at the right edge
  const char* help;
};
constexpr std::array<Column, 8> kColumns = {{
    {"#", 14, true, "The order in which the step met them."},
    {"other", 0, false, "A solid tile, an up- or down-slope with its cell, or another body."},
    {"reaction", 54, false, "What the body did: it stopped, slid along, bounced off or crossed it."},
    {"t", 44, true,
     "Time of impact, a fraction of the move; minus the overlap area, px\xc2\xb2, if the boxes overlapped."},
    {"n", 40, true, "The normal out of the other."},
    {"delta", 34, true, "How far along the slope the centre is, from 0 to 1."},
    {"floor", 48, true, "The computed floor height, px, before rounding."},
    {"done", 32, false, "Whether it was handled; a slope correction skips the contacts after it."},
}};

// What a table has in its columns, by kColumns, line by line.
using ColumnLine = std::span<const std::uint8_t>;
constexpr float kLeastTableWidth = 396;  // px at scale 1; in a narrower panel a contact has two lines
constexpr std::array<std::uint8_t, 8> kWide = {0, 1, 2, 3, 4, 5, 6, 7}, kNarrow = {0, 1, 2, 3, 7, 4, 5, 6};

// column: of kColumns.
void draw_contact_cell(int column, const Scene& scene, const ContactRecord& contact, Ui& ui) {
  switch (column) {
    case 0:
      return ui.right_aligned(std::to_string(contact.order + 1));
    case 1:
      return draw_text_cell(obstacle_text(scene, contact.other), ui);
    case 2:
      return draw_text_cell(response_label(contact.response), ui);
    case 3:
      return draw_number("t", contact.ti, ui, meaning_of_impact(contact));
    case 4:
      ui.right_aligned(one_decimal(contact.normal.x) + "," + one_decimal(contact.normal.y));
      return ui.tooltip(all_digits(contact.normal.x) + "\n" + all_digits(contact.normal.y));
    case 5:
      if (contact.slope) draw_number("delta", contact.slope->delta, ui);
      return;
    case 6:
      if (contact.slope) draw_number("floor", contact.slope->floor_y, ui);
      return;
    default:
      return draw_text_cell(contact.handled ? "yes" : "no", ui, meaning_of_done(contact));
  }
}

void draw_contact_header(ColumnLine line, Ui& ui) {
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (const std::uint8_t number : line) {
    const Column& column = kColumns[number];
    ImGui::TableNextColumn();
    if (column.numbers)
      ui.right_aligned(column.title, theme::tone(theme::kMuted));
    else
      ui.muted(column.title);
    ui.item(std::string("inspector/contacts/") + column.title, column.help);
  }
}

void draw_contact_line(ColumnLine line, const Scene& scene, const ContactRecord& contact, Ui& ui) {
  ImGui::TableNextRow();
  const bool is_odd = contact.order % 2 != 0;  // all lines of a contact have one colour
  ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0,
                         ImGui::GetColorU32(is_odd ? ImGuiCol_TableRowBgAlt : ImGuiCol_TableRowBg));
  ImGui::PushID(contact.order);
  if (!contact.handled) ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(theme::kMuted));
  for (const std::uint8_t column : line) {
    ImGui::TableNextColumn();
    draw_contact_cell(column, scene, contact, ui);
  }
  if (!contact.handled) ImGui::PopStyleColor();
  ImGui::PopID();
}

void draw_contacts(const Scene& scene, const StepRecord& record, int body, Ui& ui) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const int lines = room.x < ui.px(kLeastTableWidth) ? 2 : 1;
  const std::size_t columns = kColumns.size() / static_cast<std::size_t>(lines);
  const auto line = [&](int number) {
    return ColumnLine(lines == 1 ? kWide : kNarrow)
        .subspan(static_cast<std::size_t>(number) * columns, columns);
  };
  constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersOuterH;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(ui.px(3), ui.px(2)));
  if (ImGui::BeginTable("contacts", static_cast<int>(columns), kFlags, room)) {
    ImGui::TableSetupScrollFreeze(0, lines);
    for (std::size_t i = 0; i < columns; ++i) {
      float width = 0;  // of the widest in the column
      for (int k = 0; k < lines; ++k) width = std::max(width, kColumns[line(k)[i]].width);
      const bool takes_rest = kColumns[line(0)[i]].width == 0;
      ImGui::TableSetupColumn(
          kColumns[line(0)[i]].title,
          takes_rest ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed,
          takes_rest ? 0 : ui.px(width));
    }
    for (int k = 0; k < lines; ++k) draw_contact_header(line(k), ui);
    std::vector<const ContactRecord*> contacts;
    for (const ContactRecord& contact : record.contacts)
      if (contact.body == body) contacts.push_back(&contact);
    draw_rows(lines * static_cast<int>(contacts.size()), [&](int row) {
      draw_contact_line(line(row % lines), scene, *contacts[static_cast<std::size_t>(row / lines)], ui);
    });
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

int count_contacts(const StepRecord& record, int body) {
  int count = 0;
  for (const ContactRecord& contact : record.contacts) count += contact.body == body;
  return count;
}

// What the opened case shows, and how it should end.
void draw_hard_case(const HardCase& hard, Ui& ui) {
  ImGui::Spacing();
  ImGui::Separator();
  ImGui::Spacing();
  ImGui::BeginChild("hard case", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  ui.heading("Hard case " + std::to_string(hard.number));
  draw_wrapped_text(hard.title);
  ImGui::Spacing();
  ui.heading("Set-up");
  draw_wrapped_text(hard.set_up);
  ImGui::Spacing();
  ui.heading("Right answer");
  draw_wrapped_text(hard.right_answer);
  ui.item("inspector/answer");
  ImGui::EndChild();
}

void draw_no_body_hint(const Session& session, Actions& actions, Ui& ui) {
  ui.hint(
      "No body in this level: paint a tile that has the ball flag on the map, or place one with the body "
      "tool (" +
      keys_of("map/body"_command, ui) + ").");
  command_text_button("player/place"_command, session, actions, ui, {.widget = "inspector/place_player"});
}

}  // namespace

void InspectorPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (draws_curves(session.choices().map_tool)) return curve_.draw(session, actions, ui);
  if (session.choices().map_tool == MapTool::object) return object_.draw(session, actions, ui);
  const Body* body = session.state().find(session.choices().body);
  if (body == nullptr) {
    if (session.choices().map_tool == MapTool::body)
      ui.hint("No body chosen: click one on the map, or a free place to put one there.");
    else if (session.state().bodies.empty())
      draw_no_body_hint(session, actions, ui);
    else
      draw_body_hint("", "inspector", session, actions, ui);
    if (session.hard_case()) draw_hard_case(*session.hard_case(), ui);
    return;
  }
  std::string name = "Body " + std::to_string(body->id);
  const int spawn = chosen_spawn(session);
  name += spawn >= 0                         ? "  (" + title_of_spawn(session.level(), spawn) + ")"
          : body->origin.spawn == kLoneSpawn ? std::string("  (plays alone)")
          : body->origin.spawn >= 0          ? "  (" + std::string(traits_of(body->kind).word) + " " +
                                          std::to_string(body->origin.spawn + 1) + ")"
                                    : "  (from cell " + std::to_string(body->origin.cell.x) + "," +
                                          std::to_string(body->origin.cell.y) + ")";
  if (session.state().grabbed == body->id && session.playback().input.mouse_down) name += ", held";
  draw_text(name);
  draw_body(*body, spawn >= 0, {session, actions, body->id}, ui);
  if (spawn >= 0) spawn_.draw(session, spawn, actions, ui);
  ImGui::Spacing();
  if (session.state().frame == 0) {
    ui.hint("No step yet: make one, and its contacts are listed here.");
    command_text_button("play/step"_command, session, actions, ui, {.widget = "inspector/step"});
    return;
  }
  const int contacts = count_contacts(session.record(), body->id);
  ui.heading(contacts == 0 ? "No contact in the last step." : "Contacts of the last step, in order");
  if (contacts > 0) draw_contacts(session.scene(), session.record(), body->id, ui);
}

}  // namespace talus
