// Where the user has put the panels that have tabs, and whole layouts with a name.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "panels/canvas/canvases_view.h"
#include "window_view.h"

namespace talus {

struct View;

// A layout that the user has saved.
struct SavedLayout {
  std::string name;  // not empty; no two are the same
  Layout sizes;
  CanvasMode canvas = CanvasMode::play;
  bool left_open = true, right_open = true, right_low_open = true, dock_open = false;
  std::vector<std::string> tabs;  // as WindowView::tabs
  std::vector<MovedTab> moved_tabs;
  friend bool operator==(const SavedLayout&, const SavedLayout&) = default;
};

// Where the user has put a panel; nothing: it is where the program puts it.
std::optional<TabPlace> moved_place(const WindowView& window, std::string_view panel);
// Puts a panel there, opens the column, and brings the panel to the front.
void move_tab(WindowView& window, const std::string& panel, TabPlace place);
// Shows the left column, in a narrow window instead of the right one.
void show_left_column(WindowView& window);
// Puts a closed panel back to where the program puts it.
void reopen_tab(WindowView& window, std::string_view panel);

// Replaces the saved layout of that name, or adds one; the oldest of too many goes.
void save_layout(View& view, const std::string& name);
void show_layout(const SavedLayout& layout, View& view);

}  // namespace talus
