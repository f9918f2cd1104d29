// View: what the window shows that is not the session's business: layout, focus, dialogs, hover. Part of it
// is remembered between starts (platform/settings.h).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <talus/collision/geometry.h>
#include <talus/level/tileset.h>
#include "panels/canvas/key_cursor.h"
#include "panels/debugger/debugger_view.h"
#include "panels/files/export_view.h"
#include "panels/level/problems_view.h"
#include "preferences.h"

namespace talus {

// Which part of the window the keys go to.
enum class Focus { sprites, map, input };  // input: the input roll

// What the middle of the window shows.
enum class CanvasMode { map, play, both, two_maps };

// Which file dialog is asked for.
enum class FileDialog {
  none,
  open,
  save_as,
  save_recording,
  import_png,
  export_tiles,
  export_sprites,
  export_palette,
  export_path  // of the preset that is shown
};

// Sizes of the fixed regions, as fractions of the window, so that they survive a change of its size; what
// does not fit is clamped to the regions' smallest sizes.
struct Layout {
  double left = 0.215;        // width of the left column
  double right = 0.305;       // width of the right column
  double sheet = 0.5;         // height of the sheet, of the left column
  double right_split = 0.68;  // height of the inspector, of the right column
  double pixels = 0.55;       // height of the enlarged pixel canvas, of the middle
  double canvas_split = 0.5;  // height of the map, of the middle, when map and play are both shown
  double dock = 0.3;          // height of the debugger's panels, of what is between menu and timeline
  friend bool operator==(const Layout&, const Layout&) = default;
};

// How the pixel canvas is shown.
struct PixelView {
  bool neighbours = false;  // among the tiles that stand around it on the map
  bool enlarged = false;    // above the map and the play view, instead of below the sheet
  friend bool operator==(const PixelView&, const PixelView&) = default;
};

// Where the mouse is over a canvas, for the status bar.
struct Hover {
  std::optional<Cell> cell;     // on the map
  std::optional<Vec2> pixel;    // px, in the level
  std::optional<Cell> sprite;   // px, in the pixel canvas
  std::optional<int> tile;      // on the sheet, 0..255
  std::optional<Cell> dragged;  // cells, width and height of the rectangle that is being dragged on the map
};

struct View {
  Layout layout;
  CanvasMode canvas = CanvasMode::both;
  Focus focus = Focus::map;
  KeyCursor cursor;            // a pointer for the keyboard
  bool paint_in_play = false;  // the left button paints in the play view, instead of holding balls
  bool dock_open = false;      // the debugger's panels are shown
  double ui_scale = 0;         // 0: by the window's height; else 1 to 4
  Preferences preferences;
  ProgramView program;
  FileDialog dialog = FileDialog::none;
  bool help_open = false;
  bool command_palette_open = false;
  bool resize_open = false;               // the dialog of the map's size
  bool find_tiles_open = false;           // the window that finds and replaces tiles
  int find_tile = 0;                      // 0..255, that it finds
  int replace_tile = 0;                   // 0..255, that it puts there instead
  std::vector<std::string> recent_files;  // absolute paths, the latest first
  std::vector<std::string> hard_cases;    // paths of the levels that come with the program, in order
  std::vector<std::string> tabs;          // ids of the panels that are shown where several share a region
  int palette_color = 12;                 // 0..15, which the sliders edit
  PixelView pixels;
  std::array<std::optional<Cell>, kTileCount>
      tile_places;  // where on the map the mouse was on each tile last

  int stage = -1;                           // of the chosen body's step, drawn in the play view; -1: none
  int input_row = 0;                        // of the input roll, that its keys change
  std::optional<std::int64_t> input_range;  // where the range of its keys began; it ends at the shown frame
  bool shows_times = false;                 // the time of each step is plotted
  std::string wants_tab;                    // id of a panel that is to come to the front of its region
  std::string wants_text;                   // name of a text field that is to get the keys
  std::string wants_keys;                   // id of a panel whose first control is to get the keys
  bool keys_in_panel = false;               // the arrows, Tab, Space and Enter go from control to control
  bool split_compared = false;              // the other side of a comparison has a view of its own
  std::optional<Cell> centre_on;            // asks the canvases to show this cell; taken by the next frame
  // Outlined on the map: what was looked for or is a problem. A click on the map or Escape takes it away.
  std::optional<Cell> marked_cell;
  ProblemsView problems;
  ExportView exports;
  DebuggerView debugger;
  bool play_active = false;       // of the two canvases, the play view was used last: it gets these requests,
  Vec2 scroll_by;                 // each taken by the next frame: scroll, px of the screen
  int zoom_by = 0;                // zoom in (> 0) or out
  bool minimap = false;           // the whole map in a corner of the map, to go elsewhere
  bool second_map = false;        // of two maps, the second was used last: as play_active
  bool fit_map = false;           // show the whole map, or go back
  bool fit_first_screen = false;  // as when the level was opened
  int level_number = 0;           // grows when another file is opened: the canvases start afresh
  Hover hover;                    // of this frame, as far as it is drawn
  Hover hover_before;             // of the whole frame before: for panels that are drawn before the canvas

  // Where a search on the map goes on from.
  std::optional<Cell> search_start() const { return marked_cell ? marked_cell : hover.cell; }
};

}  // namespace talus
