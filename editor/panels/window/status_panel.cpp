// One line at the bottom of the window.
#include "status_panel.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "debug/number_text.h"
#include "edit/layer_tools.h"
#include "edit/picture_palette.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/commands/commands.h"
#include "panels/level/problem_list.h"
#include "panels/level/proof_rows.h"
#include "panels/panel_ids.h"
#include "panels/sprites/tile_number.h"
#include "panels/tiles/flag_label.h"

namespace talus {
namespace {

constexpr float kWide = 900;      // px at scale 1: in a narrower window the parts move together
constexpr float kLayer = 150;     // px at scale 1, of the layer's part
constexpr float kLeastFile = 40;  // px at scale 1, below which the file is not shown
// Tiles of the stamp's picture in a row or column: more would be too small to see.
constexpr int kMaxShown = 8;

// px at scale 1, where the parts of the line begin.
struct Places {
  float stamp, bodies;
  float file;  // and the layer
};

// width: px, of the window.
Places places_in(float width, const Ui& ui) {
  const float share = std::min(1.0f, width / ui.px(kWide));
  return {360 * share, 570 * share, 670 * share};
}

// " (solid, flag 2)"; empty if there are no flags.
std::string flags_text(const Level& level, FlagSet flags) {
  std::string text;
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    if (!has_flag(flags, flag)) continue;
    const std::string name = flag_name(level, flag);
    text += (text.empty() ? " (" : ", ") + (name.empty() ? "flag " + std::to_string(flag) : name);
  }
  return text.empty() ? text : text + ")";
}

// A place of the mouse, which nobody needs in hundredths of a pixel.
std::string mouse_place_text(double pixels) { return short_text(std::round(pixels * 10) / 10); }

void draw_part(Ui& ui, float x, const std::string& text, std::uint32_t color, std::string_view help) {
  ImGui::SameLine(ui.px(x));
  ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(color));
  draw_text(text);
  ImGui::PopStyleColor();
  ui.tooltip(help);
}

// "tile 9, mirrored".
std::string text_of_cell(MapCell cell) {
  const std::string turn = text_of(cell.turn);
  return "tile " + std::to_string(cell.tile) + (turn.empty() ? "" : ", " + turn);
}

std::string stamp_text(const Stamp& stamp) {
  if (stamp.tiles.size() == 1) return "stamp: " + text_of_cell(stamp.tiles.front());
  return "stamp: " + std::to_string(stamp.w) + "x" + std::to_string(stamp.h) + " tiles from " +
         std::to_string(stamp.tiles.front().tile);
}

// A picture of the stamp as high as the line, followed by its text. x, end: px at scale 1, where its room
// begins and ends.
void draw_stamp_part(const Stamp& stamp, float x, float end, Ui& ui) {
  ImGui::SameLine(ui.px(x));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ImGui::GetTextLineHeight();
  const CellRect shown{0, 0, std::min(stamp.w, kMaxShown), std::min(stamp.h, kMaxShown)};
  const float zoom = side / static_cast<float>(std::max(shown.w, shown.h) * kCartTileSize);
  const CanvasView view{at, {at.x + side - 1, at.y + side - 1}, {at.x, at.y}, zoom};
  draw_stamp(*ImGui::GetWindowDrawList(), stamp, shown, view, ui, 255);
  ImGui::Dummy({side, side});
  ui.item("status/stamp");
  ImGui::SameLine(ui.px(x + 20));
  const std::string text = stamp_text(stamp);
  draw_short_text(text, ui.px(end - x - 28), theme::tone(theme::kMuted));
  ui.item("status/stamp_text", text +
                                   ": what the map tools paint. Select tiles on the sheet, or pick them "
                                   "from the map.");
}

// A bar instead of the number of bodies.
void draw_progress(const char* name, const std::string& text, double progress, float x, const char* help,
                   Ui& ui) {
  ImGui::SameLine(ui.px(x));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 size{ui.px(88), ImGui::GetTextLineHeight()};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, theme::color(theme::kDark));
  list.AddRectFilled(at, {at.x + size.x * static_cast<float>(progress), at.y + size.y},
                     theme::tone(theme::kAccent, 110));
  add_text(list, {at.x + ui.px(4), at.y}, theme::tone(theme::kText), text);
  ImGui::Dummy(size);
  ui.item(name, help);
}

// Bodies are still on the old ground.
void draw_compiling(double progress, float x, Ui& ui) {
  draw_progress("status/compiling", "ground " + std::to_string(static_cast<int>(progress * 100)) + " %",
                progress, x,
                "The ground of a large level is being compiled; until it is, bodies move on it as it "
                "was.",
                ui);
}

void draw_exporting(const ExportProgress& progress, float x, Ui& ui) {
  draw_progress("status/exporting", "exporting", progress.share, x,
                "The level is being exported: File > Export shows how far it is, and ends it.", ui);
}

// The layer that the tools paint on, if there are several. Returns where the next part begins, px at scale 1.
// end: px, where the room for both ends.
float draw_layer_part(const Session& session, float x, float end, Ui& ui) {
  const TileLayers& layers = session.level().layers;
  if (layers.count() == 1) return x;
  const TileLayer& chosen = layers.list[static_cast<std::size_t>(layers.chosen)];
  const LayerLooks looks = shown_looks(layers.groups, chosen);
  const std::string state = looks.locked ? " (locked)" : looks.visible ? "" : " (hidden)";
  const bool is_free = state.empty();
  ImGui::SameLine(ui.px(x));
  draw_short_text("layer: " + layer_name(session.level(), layers.chosen) + state,
                  std::min(ui.px(kLayer), end - ui.px(x)),
                  theme::tone(is_free ? theme::kMuted : theme::kWarning));
  ui.item("status/layer", "The layer of the map that the tools paint on: choose it under Layers.",
          keys_of("layers/above"_command, ui) + ", " + keys_of("layers/below"_command, ui));
  return x + kLayer + 12;
}

// The level's file, or why its changes are not saved, if there is room for that. x: px at scale 1. end: px,
// where the room ends.
void draw_file(const Session& session, float x, float end, Ui& ui) {
  if (end - ui.px(x) < ui.px(kLeastFile)) return;
  const std::string& problem = ui.view.window.autosave_problem;
  const std::string name = session.file_name() + (session.modified() ? "  (not saved)" : "");
  const std::string text = problem.empty() ? name : "Not saved automatically: " + problem;
  const bool warns = session.modified() || !problem.empty();
  ImGui::SameLine(ui.px(x));
  draw_short_text(text, end - ui.px(x), theme::tone(warns ? theme::kWarning : theme::kMuted));
  if (!problem.empty())
    ui.item("status/not-saved-by-itself", text + ". Talus tries again until it succeeds.");
  else
    ui.item("status/file", session.path().empty() ? "Not in a file yet." : session.path());
}

}  // namespace

std::string hover_text(const Session& session, const Hover& hover) {
  if (hover.sprite) {
    const SpriteArea& area = session.choices().area;
    const PixelColor color = pixel_at(session.level(), area, hover.sprite->x, hover.sprite->y);
    return "pixel " + std::to_string(hover.sprite->x) + "," + std::to_string(hover.sprite->y) + "  colour " +
           (is_in_rgba(session.level(), area.sheet) ? hex_text(rgba_of(color)) : std::to_string(color));
  }
  if (hover.tile) {
    const SheetId sheet = session.choices().area.sheet;
    return (sheet == SheetId::tiles ? "tile " : "sprite ") +
           std::to_string(number_on_screen(sheet, *hover.tile));
  }
  if (!hover.pixel) return "";
  std::string text = "outside the map   ";
  if (hover.cell) {
    const MapCell content = session.level().map.at(*hover.cell);
    text = "(" + std::to_string(hover.cell->x) + ", " + std::to_string(hover.cell->y) + ")  " +
           text_of_cell(content) + flags_text(session.level(), session.level().tile_flags(content.tile)) +
           "   ";
  }
  const TileSize tile = session.level().map.tile_size();
  if (hover.dragged)
    return text + std::to_string(hover.dragged->x) + "x" + std::to_string(hover.dragged->y) + " cells, " +
           std::to_string(hover.dragged->x * tile.width) + "x" +
           std::to_string(hover.dragged->y * tile.height) + " px";
  return text + "px " + mouse_place_text(hover.pixel->x) + ", " + mouse_place_text(hover.pixel->y);
}

void StatusPanel::draw(const Session& session, Actions&, Ui& ui) {
  const std::string hover = hover_text(session, ui.view.canvas.hover);
  const Places places = places_in(ImGui::GetWindowWidth(), ui);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::PushClipRect(at, {at.x + ui.px(places.stamp - 12), at.y + ImGui::GetTextLineHeight()}, true);
  draw_text(hover.empty() ? "Point at the map, the sheet or the pixels" : hover);
  ImGui::PopClipRect();
  ui.item("status/mouse", hover.empty() ? "The place under the mouse." : hover);
  draw_stamp_part(session.choices().stamp, places.stamp, places.bodies, ui);
  if (const auto progress = session.compile_progress()) {
    draw_compiling(*progress, places.bodies, ui);
  } else if (const auto exporting = session.exporting().progress()) {
    draw_exporting(*exporting, places.bodies, ui);
  } else if (session.playback().running && session.timeline().in_past()) {
    draw_part(
        ui, places.bodies, "replaying", theme::kAccent,
        "The recording is shown again. End replay, play on, beside the timeline, leaves it at the shown "
        "frame.");
    ui.item("status/replaying");
  } else {
    const std::size_t bodies = session.state().bodies.size();
    draw_part(ui, places.bodies, std::to_string(bodies) + (bodies == 1 ? " body" : " bodies"), theme::kMuted,
              "Bodies of the simulation.");
  }
  const std::string problems = problems_text(session, ui);
  const float end = ImGui::GetWindowContentRegionMax().x - size_of_text(problems).x - ui.px(16);
  // What is not saved is worth more than the layer's name.
  const bool warns = !ui.view.window.autosave_problem.empty();
  draw_file(session, warns ? places.file : draw_layer_part(session, places.file, end, ui), end, ui);
  ImGui::SameLine(end);
  ui.right_aligned(
      problems,
      theme::tone(ui.problems->empty() && findings_of(session) == 0 ? theme::kMuted : theme::kWarning));
  ui.item("status/problems", "Click: the Problems tab.");
  if (ImGui::IsItemClicked()) ui.ask(request::ShowTab(panel_id::kProblems));
}

}  // namespace talus
