// The picture with the cut over it on the left, the numbers on the right.
#include "tile_import_panel.h"

#include <algorithm>
#include <cmath>

#include "formats/files/real_path.h"
#include "formats/tilesets/tile_cut.h"
#include "map_size.h"
#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr float kPictureWidth = 480, kPictureHeight = 360;  // px at scale 1, at most
constexpr float kMaxPixel = 6;                              // px at scale 1, of a pixel of the picture
constexpr float kImportButton = 112;                        // px at scale 1, the width of a button

// How many tiles come out, and what is left over.
std::string text_of_grid(const TileImport& import, const action::ApplyTiles& order) {
  const CutGrid grid = grid_of(order.cut, import.width(), import.height());
  std::string text = std::to_string(grid.count()) + (grid.count() == 1 ? " tile" : " tiles") + " in " +
                     std::to_string(grid.columns) + (grid.columns == 1 ? " column" : " columns") + ".";
  const int right = grid.rest_x - order.cut.margin, bottom = grid.rest_y - order.cut.margin;
  if (right > 0) text += " " + std::to_string(right) + " px are left over at the right.";
  if (bottom > 0) text += " " + std::to_string(bottom) + " px are left over at the bottom.";
  return text;
}

}  // namespace

void TileImportPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto is_open = [](const Session& now, const View&) { return now.tile_import().has_value(); };
  if (!begin_dialog("Tiles from a picture", is_open, {0, 0}, session, ui)) return;
  if (const auto& import = session.tile_import()) {
    if (file_.lock() != import->file) begin(*import);
    const std::string problem = problem_of(*import, order_);
    draw_text((import->adds ? "A tileset from " : "A new level with the tiles of ") +
              last_name(import->path));
    draw_picture(*import, problem_of(order_.cut, import->width(), import->height()).empty(), ui);
    ImGui::SameLine(0, ui.px(16));
    ImGui::BeginGroup();
    draw_fields(*import, ui);
    ImGui::EndGroup();
    draw_answers(*import, problem, session, actions, ui);
  }
  ImGui::EndPopup();
}

void TileImportPanel::begin(const TileImport& import) {
  file_ = import.file;
  order_ = {};
  order_.cut = import.guess;
}

void TileImportPanel::draw_picture(const TileImport& import, bool is_good, Ui& ui) const {
  const ImVec2 room{ui.px(kPictureWidth), ui.px(kPictureHeight)}, at = ImGui::GetCursorScreenPos();
  const float width = static_cast<float>(import.width()), height = static_cast<float>(import.height());
  float zoom = std::min({room.x / width, room.y / height, kMaxPixel * ui.scale});
  if (zoom > 1) zoom = std::floor(zoom);
  ImGui::Dummy(room);
  const ImVec2 from{std::floor(at.x + (room.x - width * zoom) / 2),
                    std::floor(at.y + (room.y - height * zoom) / 2)};
  const ImVec2 to{from.x + width * zoom, from.y + height * zoom};
  ui.place("tiles/picture", from, to);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + room.x, at.y + room.y}, theme::tone(theme::kDark));
  list.AddImage(ui.preview, from, to);
  if (!is_good) return;
  const TileCut& cut = order_.cut;
  const CutGrid grid = grid_of(cut, import.width(), import.height());
  constexpr float kLeastTile = 4;  // px of the screen; closer lines would hide the picture
  if (static_cast<float>(std::min(cut.tile.width, cut.tile.height)) * zoom < kLeastTile) {
    list.AddRect(from, to, theme::tone(theme::kAccent));
    return;
  }
  const ImU32 color = theme::tone(theme::kAccent, 200);
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const auto x = static_cast<float>(cut.margin + column * (cut.tile.width + cut.spacing));
      const auto y = static_cast<float>(cut.margin + row * (cut.tile.height + cut.spacing));
      const ImVec2 corner{from.x + x * zoom, from.y + y * zoom};
      list.AddRect(corner,
                   {corner.x + static_cast<float>(cut.tile.width) * zoom + 1,
                    corner.y + static_cast<float>(cut.tile.height) * zoom + 1},
                   color);
    }
  }
}

void TileImportPanel::draw_fields(const TileImport& import, Ui& ui) {
  draw_text("A tile, in px");
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  TileCut& cut = order_.cut;
  draw_map_number("tiles/tile_width", "Width", cut.tile.width, "px, 1 to 256.", ui);
  draw_map_number("tiles/tile_height", "Height", cut.tile.height, "px, 1 to 256.", ui);
  draw_map_number("tiles/spacing", "Spacing", cut.spacing, "px between two tiles.", ui);
  draw_map_number("tiles/margin", "Margin", cut.margin, "px around all tiles.", ui);
  if (!import.adds) {
    ImGui::Spacing();
    draw_text("The map, in cells");
    draw_map_number("tiles/width", "Columns", order_.width, "Cells in a row. " + text_of_map_limits(), ui);
    draw_map_number("tiles/height", "Rows", order_.height, "Rows of cells. " + text_of_map_limits(), ui);
  }
  ImGui::Spacing();
  draw_text("The pixels");
  if (ui.text_button("tiles/copied", "copied", !order_.is_linked, "The level stores the pixels."))
    order_.is_linked = false;
  ImGui::SameLine();
  if (ui.text_button(
          "tiles/linked", "linked", order_.is_linked,
          "The level stores the path of the picture, which is read whenever the level is opened. The "
          "level must be saved in the folder of the picture, or above it."))
    order_.is_linked = true;
}

void TileImportPanel::draw_answers(const TileImport& import, const std::string& problem,
                                   const Session& session, Actions& actions, Ui& ui) {
  ImGui::Spacing();
  if (problem.empty())
    draw_map_note(text_of_grid(import, order_), theme::kMuted);
  else
    draw_map_note(problem, theme::kError);
  ui.item("tiles/note");
  const bool applies = dialog_button({.widget = "tiles/apply",
                                      .label = import.adds ? "Add tileset" : "New level",
                                      .help = import.adds ? "Adds the tiles to the level; undoable."
                                                          : "Starts an empty level with these tiles.",
                                      .letter = import.adds ? 'A' : 'N',
                                      .is_default = true,
                                      .enabled = problem.empty(),
                                      .width = ui.px(kImportButton)},
                                     ui);
  ImGui::SameLine();
  const bool cancels = dialog_button({.widget = "tiles/cancel",
                                      .label = "Cancel",
                                      .help = "Keeps the level as it is.",
                                      .letter = 'C',
                                      .is_cancel = true,
                                      .width = ui.px(kImportButton)},
                                     ui);
  if (applies) actions.push_back(order_);
  if (cancels) actions.push_back(action::CancelTiles{});
  if (import.adds || session.level().sheet(SheetId::tiles).picture) return;
  ImGui::SameLine();
  const bool draws =
      dialog_button({.widget = "tiles/draw",
                     .label = "Draw on sheet...",
                     .help = "Draws the picture on the sheet of the open level, in its 16 colours.",
                     .letter = 'D',
                     .width = ui.px(kImportButton)},
                    ui);
  if (!draws) return;
  actions.push_back(action::CancelTiles{});
  actions.push_back(action::OpenPng{import.path});
}

}  // namespace talus
