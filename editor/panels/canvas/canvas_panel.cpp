// The toolbar and the split of the canvases.
#include "canvas_panel.h"

#include <algorithm>
#include <string>

#include "panels/commands/commands.h"
#include "panels/debugger/compare_choice.h"
#include "panels/tiles/flag_choice.h"
#include "panels/tiles/flag_label.h"
#include "panels/ui/splitter.h"

namespace talus {
namespace {

// Short enough for the toolbar.
std::string short_label(const Level& level, FlagPattern pattern) {
  const bool is_flag = pattern == pattern_of_flag(pattern.lowest_flag());
  return is_flag ? "flag " + std::to_string(pattern.lowest_flag()) : pattern_label(level, pattern);
}

}  // namespace

void CanvasPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  draw_toolbar(session, actions, ui);
  switch (ui.view.canvas.mode) {
    case CanvasMode::map:
      map_.draw(session, actions, ui, ImGui::GetContentRegionAvail());
      break;
    case CanvasMode::play:
      draw_play(session, actions, ui, ImGui::GetContentRegionAvail());
      break;
    case CanvasMode::both:
    case CanvasMode::two_maps:
      draw_both(session, actions, ui);
      break;
  }
}

void CanvasPanel::draw_play(const Session& session, Actions& actions, Ui& ui, ImVec2 size) {
  if (!ui.view.canvas.split_compared || !is_compared(session)) return play_.draw(session, actions, ui, size);
  const float gap = ui.px(2), half = (size.x - gap) / 2;
  play_.draw(session, actions, ui, {half, size.y});
  ImGui::SameLine(0, gap);
  play_.draw_other_side(session, ui, {half, size.y});
}

void CanvasPanel::draw_both(const Session& session, Actions& actions, Ui& ui) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const float bar = ui.px(kSplitterWidth), least = ui.px(80);
  float upper = static_cast<float>(ui.view.window.layout.canvas_split) * room.y;
  upper = std::clamp(upper, std::min(least, room.y / 2), std::max(room.y - least - bar, room.y / 2));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  map_.draw(session, actions, ui, {room.x, upper});
  const float moved = splitter("canvas/split", {room.x, bar}, SplitterAxis::vertical, ui);
  if (moved != 0) ui.view.window.layout.canvas_split = (upper + moved) / room.y;
  const ImVec2 lower{room.x, room.y - upper - bar};
  if (ui.view.canvas.mode == CanvasMode::two_maps)
    second_map_.draw(session, actions, ui, lower);
  else
    draw_play(session, actions, ui, lower);
  ImGui::PopStyleVar();
}

void CanvasPanel::draw_toolbar(const Session& session, Actions& actions, Ui& ui) {
  // Half the usual gap, so that everything fits in two lines of a window 1152 px wide.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), ImGui::GetStyle().ItemSpacing.y));
  command_text_button("canvas/map"_command, session, actions, ui, {.label = "Map"});
  ImGui::SameLine();
  command_text_button("canvas/play"_command, session, actions, ui, {.label = "Play"});
  ImGui::SameLine();
  command_text_button("canvas/both"_command, session, actions, ui, {.label = "Both"});
  ImGui::SameLine();
  command_text_button("canvas/two_maps"_command, session, actions, ui, {.label = "Two maps"});
  constexpr CommandId kTools[] = {"map/stamp"_command,   "map/pan"_command,   "map/select"_command,
                                  "map/fill"_command,    "map/line"_command,  "map/rectangle"_command,
                                  "map/ellipse"_command, "map/slope"_command, "map/segment"_command,
                                  "map/curve"_command,   "map/body"_command,  "map/object"_command,
                                  "map/ground"_command,  "map/erase"_command, "map/pick"_command};
  const float button = ui.px(theme::kButton);
  for (const CommandId& tool : kTools) {
    ui.same_line_if_fits(button, &tool == kTools ? ui.px(8) : 0);
    command_button(tool, session, actions, ui);
  }
  constexpr CommandId kView[] = {"canvas/zoom_out"_command,      "canvas/zoom_in"_command,
                                 "map/random"_command,           "map/minimap"_command,
                                 "canvas/grid"_command,          "canvas/borders"_command,
                                 "canvas/paint_in_play"_command, "canvas/follow"_command};
  for (const CommandId& tool : kView) {
    const bool has_play = ui.view.canvas.mode == CanvasMode::play || ui.view.canvas.mode == CanvasMode::both;
    const bool is_of_play = tool == "canvas/paint_in_play"_command || tool == "canvas/follow"_command;
    if (is_of_play && !has_play) continue;
    // Both zooms go into the next line together.
    const float width =
        tool == "canvas/zoom_out"_command ? 2 * button + ImGui::GetStyle().ItemSpacing.x : button;
    ui.same_line_if_fits(width, &tool == kView ? ui.px(8) : 0);
    command_button(tool, session, actions, ui);
  }
  ui.same_line_if_fits(ui.px(84));
  draw_flag_tint_choice(session, actions, ui);
  ImGui::PopStyleVar();
}

void CanvasPanel::draw_flag_tint_choice(const Session& session, Actions& actions, Ui& ui) {
  const auto now = session.choices().flag_overlay;
  draw_flag_choice("canvas/flag_tint", now ? short_label(session.level(), *now) : "no tint", ui.px(84),
                   session, actions, ui);
}

}  // namespace talus
