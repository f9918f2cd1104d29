// The sheet: all tiles, those of a tileset, or sprites. The wheel zooms it, and the middle button, or Space
// and the left one, move it. A click or a drag selects what the other panels work on, or paints flags.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "panels/panel.h"
#include "panels/tiles/flag_brush.h"
#include "sheet_camera.h"
#include "sheet_finder.h"

namespace talus {

class SheetPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kSheet; }
  std::string_view title() const override { return "Sheet"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_sheet(const Session& session, Actions& actions, Ui& ui);
  void follow_choice(const Session& session, Ui& ui);
  void draw_layers(ImDrawList& list, const Session& session, const SheetView& view, const Ui& ui);
  void draw_header(const Session& session, Actions& actions, Ui& ui);
  void draw_tabs(const Session& session, Actions& actions, Ui& ui);
  static bool has_tileset_menu(const Session& session, const Ui& ui);
  bool draw_tileset_tabs(const Session& session, std::span<const std::string> names, Ui& ui);
  static bool draw_tileset_list(const Session& session, std::span<const std::string> names, Ui& ui);
  void draw_tileset_menu(const Session& session, int index, Actions& actions, Ui& ui);
  void draw_marks(ImDrawList& list, const Session& session, const SheetView& view, const Ui& ui);
  void handle_mouse(const Session& session, Actions& actions, Ui& ui, const SheetView& view);
  SheetCamera camera_;
  CellRect shown_choice_;     // the chosen tiles in the last frame
  TileNumber displaced_ = 0;  // see displaced_tile(); 0 also while the sprites are shown
  int shown_tab_ = -2;        // index of the tileset whose tab is chosen; -1: all tiles; -2: none yet
  SheetFinder finder_;
  std::string tileset_name_;  // as typed, while the menu of a tileset is open
  FlagBrush flag_brush_;
  std::optional<Cell> drag_from_;  // the tile where the button went down
};

}  // namespace talus
