#include "tab_places.h"

#include <algorithm>

#include "panel_list.h"
#include "panels/view.h"

namespace talus {

std::optional<TabPlace> moved_place(const WindowView& window, std::string_view panel) {
  const auto moved = std::ranges::find(window.moved_tabs, panel, &MovedTab::panel);
  return moved != window.moved_tabs.end() ? std::optional(moved->place) : std::nullopt;
}

void move_tab(WindowView& window, const std::string& panel, TabPlace place) {
  std::erase_if(window.moved_tabs, [&](const MovedTab& moved) { return moved.panel == panel; });
  window.moved_tabs.push_back({panel, place});
  if (place == TabPlace::closed) return;
  open_place(window, place);
  window.wanted_tabs.push_back(panel);
}

void show_left_column(WindowView& window) {
  window.left_open = true;
  window.first = TabPlace::left;
  window.alone = false;
}

void reopen_tab(WindowView& window, std::string_view panel) {
  std::erase(window.moved_tabs, MovedTab{std::string(panel), TabPlace::closed});
}

void save_layout(View& view, const std::string& name) {
  const WindowView& window = view.window;
  std::vector<SavedLayout>& saved = view.layouts;
  std::erase_if(saved, [&](const SavedLayout& layout) { return layout.name == name; });
  if (saved.size() == kMaxLayouts) saved.erase(saved.begin());
  saved.push_back({name, window.layout, view.canvas.mode, window.left_open, window.right_open,
                   window.right_low_open, window.dock_open, window.tabs, window.moved_tabs});
}

void show_layout(const SavedLayout& layout, View& view) {
  WindowView& window = view.window;
  window.alone = false;
  window.layout = layout.sizes;
  window.left_open = layout.left_open;
  window.right_open = layout.right_open;
  window.right_low_open = layout.right_low_open;
  window.dock_open = layout.dock_open;
  window.moved_tabs = layout.moved_tabs;
  window.wanted_tabs = layout.tabs;
  view.canvas.mode = layout.canvas;
  view.requests.ask(request::KeepZoom{});
}

}  // namespace talus
