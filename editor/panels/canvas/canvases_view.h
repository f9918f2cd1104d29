// What the canvases of the level show: the map, the play view, and the second map.
#pragma once

#include <memory>
#include <optional>

#include <talus/collision/geometry.h>
#include "key_cursor.h"

namespace talus {

struct FixPreview;
struct Overlay;

// What the middle of the window shows.
enum class CanvasMode { map, play, both, two_maps };

// Where the mouse is over a canvas, for the status bar.
struct Hover {
  std::optional<Cell> cell;     // on the map
  std::optional<Vec2> pixel;    // px, in the level
  std::optional<Cell> sprite;   // px, in the pixel canvas
  std::optional<int> tile;      // on the sheet, 0..255
  std::optional<Cell> dragged;  // cells, width and height of the rectangle that is being dragged on the map
};

struct CanvasesView {
  CanvasMode mode = CanvasMode::play;
  KeyCursor cursor;  // a pointer for the keyboard
  bool paint_in_play =
      false;  // the chosen tool works in the play view, instead of the hand that holds bodies
  bool split_compared = false;  // the other side of a comparison has a view of its own
  bool follow_body = true;      // the play view scrolls with the chosen body, else with the player
  bool legend_folded = false;   // the legend of the overlays has no names
  const Overlay* hovered_overlay = nullptr;  // under the mouse in the list of overlays, and so shown; or null
  bool labels_all = false;                   // the overlays label every body; else see OverlayOptions
  bool opens_on_player = true;  // a level is shown at what matters of it first, and followed; else not
  bool minimap = false;         // the whole map in a corner of the map, to go elsewhere
  bool play_active = false;     // of the two canvases, the play view was used last
  bool second_map = false;      // of two maps, the second was used last
  // The cell that is outlined on the map: a found one, or one with a problem. A click on the map or Escape
  // clears it.
  std::optional<Cell> marked_cell;
  std::optional<Cell> clicked_cell;  // the last cell of the map that was clicked with the left button
  Cell middle;                       // of what the canvas that was drawn last shows; it may be off the map
  std::shared_ptr<const FixPreview> fix_preview;  // of the fix under the mouse; null: there is none
  int level_number = 0;  // grows when another file is opened: the canvases start afresh
  Hover hover;           // of this frame, as far as it is drawn
  Hover hover_before;    // of the whole frame before: for panels that are drawn before the canvas

  // The cell from which a search on the map continues.
  std::optional<Cell> search_start() const { return marked_cell ? marked_cell : hover.cell; }
  // Whether the hand is the tool, and not the one that was chosen.
  bool has_hand() const { return mode == CanvasMode::play && !paint_in_play; }
  // A tool was chosen: where the play view is alone, it works there.
  void take_up_tool() { paint_in_play = paint_in_play || mode == CanvasMode::play; }
  void forget_level() {  // another level is open
    ++level_number;
    follow_body = opens_on_player;
    marked_cell.reset();
    clicked_cell.reset();
  }
};

}  // namespace talus
