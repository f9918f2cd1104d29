// The toolbar and the split of the canvases.
#include "canvas_panel.h"

#include <algorithm>
#include <string>

#include "panels/commands/command_row.h"
#include "panels/debugger/compare_choice.h"
#include "panels/tiles/flag_choice.h"
#include "panels/tiles/flag_label.h"
#include "panels/ui/splitter.h"

namespace talus {
namespace {

constexpr float kWide = 1.9f;  // width of the room by its height, from which two canvases lie side by side

// Short enough for the toolbar.
std::string short_label(const Level& level, FlagPattern pattern) {
  const bool is_flag = pattern == pattern_of_flag(pattern.lowest_flag());
  return is_flag ? "flag " + std::to_string(pattern.lowest_flag()) : pattern_label(level, pattern);
}

}  // namespace

void CanvasPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  if (!ui.view.window.alone) draw_toolbar(session, actions, ui);
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
  const bool is_wide = room.x > kWide * room.y;
  const float whole = is_wide ? room.x : room.y;
  float first = std::floor(static_cast<float>(ui.view.window.layout.canvas_split) * whole);
  first = std::clamp(first, std::min(least, whole / 2), std::max(whole - least - bar, whole / 2));
  const float rest = whole - first - bar;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, 0));
  map_.draw(session, actions, ui, is_wide ? ImVec2{first, room.y} : ImVec2{room.x, first});
  if (is_wide) ImGui::SameLine();
  const float moved = splitter("canvas/split", is_wide ? ImVec2{bar, room.y} : ImVec2{room.x, bar},
                               is_wide ? SplitterAxis::horizontal : SplitterAxis::vertical, ui);
  if (moved != 0) ui.view.window.layout.canvas_split = (first + moved) / whole;
  if (is_wide) ImGui::SameLine();
  const ImVec2 size = is_wide ? ImVec2{rest, room.y} : ImVec2{room.x, rest};
  if (ui.view.canvas.mode == CanvasMode::two_maps)
    second_map_.draw(session, actions, ui, size);
  else
    draw_play(session, actions, ui, size);
  ImGui::PopStyleVar();
}

void CanvasPanel::draw_toolbar(const Session& session, Actions& actions, Ui& ui) {
  // Half the usual gap, so that more tools have room.
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(ui.px(2), ImGui::GetStyle().ItemSpacing.y));
  command_text_button("canvas/play"_command, session, actions, ui, {.label = "Level"});
  ImGui::SameLine();
  command_text_button("canvas/map"_command, session, actions, ui, {.label = "Map"});
  ImGui::SameLine();
  command_text_button("canvas/both"_command, session, actions, ui, {.label = "Both"});
  ImGui::SameLine();
  command_text_button("canvas/two_maps"_command, session, actions, ui, {.label = "2 maps"});
  CommandRow row("canvas", ui);
  const CanvasMode mode = ui.view.canvas.mode;
  const bool has_play = mode == CanvasMode::play || mode == CanvasMode::both;
  row.add_gap();
  if (has_play) row.add({"canvas/paint_in_play"_command}, session, actions);
  // Who plays without the sheet beside it is not painting.
  const bool folds = ui.view.canvas.has_hand() && !ui.view.window.left_shown;
  for (const CommandId& tool :
       {"map/stamp"_command, "map/pan"_command, "map/select"_command, "map/fill"_command, "map/line"_command,
        "map/rectangle"_command, "map/ellipse"_command, "map/slope"_command, "map/segment"_command,
        "map/curve"_command, "map/body"_command, "map/object"_command, "map/ground"_command,
        "map/erase"_command, "map/pick"_command})
    if (folds)
      row.fold(tool);
    else
      row.add({tool}, session, actions);
  row.add_gap();
  row.add({"canvas/zoom_out"_command, "canvas/zoom_in"_command}, session, actions);
  if (has_play) row.add({"canvas/follow"_command}, session, actions);
  for (const CommandId& tool :
       {"canvas/grid"_command, "canvas/borders"_command, "map/random"_command, "map/minimap"_command})
    row.add({tool}, session, actions);
  row.end(
      session, actions, [&] { draw_flag_tint_choice(session, actions, ui); }, ui.px(84));
  ImGui::PopStyleVar();
}

void CanvasPanel::draw_flag_tint_choice(const Session& session, Actions& actions, Ui& ui) {
  const auto now = session.choices().flag_overlay;
  draw_flag_choice("canvas/flag_tint", now ? short_label(session.level(), *now) : "no tint", ui.px(84),
                   session, actions, ui);
}

}  // namespace talus
