// The window's own state: its layout, its dialogs, and the part that gets the keys.
#pragma once

#include <string>
#include <vector>

#include "frame_metrics.h"
#include "panels/commands/keys.h"

namespace talus {

// The part of the window that gets the keys.
enum class Focus { sprites, map, input, shape };  // input: the input roll; shape: the shape editor

// Sizes of the fixed regions, as fractions of the window, so that they survive a change of its size; what
// does not fit is clamped to the regions' smallest sizes.
struct Layout {
  double left = 0.1844;       // width of the left column
  double right = 0.2032;      // width of the right column
  double sheet = 0.5;         // height of the sheet, of the left column
  double right_split = 0.68;  // height of the inspector, of the right column
  double pixels = 0.55;       // height of the enlarged pixel canvas, of the middle
  double canvas_split = 0.5;  // share of the first of two canvases
  double dock = 0.3;          // height of the debugger's panels, of what is between menu and timeline
  friend bool operator==(const Layout&, const Layout&) = default;
};

// Where a panel with a tab can be.
enum class TabPlace { left, right_top, right_bottom, dock, closed };
struct MovedTab {
  std::string panel;  // id
  TabPlace place = TabPlace::closed;
  friend bool operator==(const MovedTab&, const MovedTab&) = default;
};

struct WindowView {
  Layout layout;
  Focus focus = Focus::map;
  std::vector<std::string> tabs;         // ids of the panels that are shown where several share a region
  std::vector<std::string> wanted_tabs;  // ids of those that come to the front in the next frame
  std::vector<MovedTab> moved_tabs;      // panels that the user has put elsewhere, or closed
  bool left_open = true;                 // the sheet and what is below it are shown
  bool right_open = true;                // the inspector and what is below it are shown
  bool right_low_open = true;            // in an open right column, what is below the inspector is shown
  bool dock_open = false;                // the debugger's panels are shown
  bool left_shown = true;                // the left column is open and has room, in the last frame
  bool right_shown = true;               // the same of the right one
  TabPlace first = TabPlace::left;       // the one of these three that is shown where one has room
  bool alone = false;                    // the canvas fills the window: every panel and bar is hidden
  bool full_screen = false;              // the window fills the screen
  double ui_scale = 0;                   // 0: by the window's height; else 1 to 4
  bool keys_in_panel = false;            // the arrows, Tab, Space and Enter go from control to control
  bool help_open = false;
  bool welcome_open = false;  // the welcome page, over the level
  bool settings_open = false;
  bool layouts_open = false;  // the saved layouts
  bool metrics_open = false;
  bool recovery_open = false;  // the dialog with work that was saved automatically before a crash
  // Why unsaved work is not saved automatically at present: "the file cannot be written: No space left on
  // device"; empty if it is.
  std::string autosave_problem;
  KeyChord dialog_key;  // the key that went down in this frame while a dialog was open, except by repetition
  bool is_in_front = true;  // the display's keys go to the program; else nothing moves that need not
  FrameMetrics metrics;
};

}  // namespace talus
