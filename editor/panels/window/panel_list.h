// The list of panels. To add one: write its file, and add its row to panel_list.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace talus {

// Where the workspace puts a panel. Panels of a region with tabs are in the order of the list.
enum class Region {
  menu,
  sheet,
  pixels,
  palette,
  flags,
  canvas,
  right_top,
  right_bottom,
  dock,
  timeline,
  transport,
  status,
  floating
};

struct PanelPlace {
  std::unique_ptr<Panel> panel;
  Region region;
};

std::vector<PanelPlace> make_panels();
// The region of a place that is not closed, and back; nothing: its panels have no tabs.
Region region_of_place(TabPlace place);
std::optional<TabPlace> place_of_region(Region region);
// Whether what holds a place, the left column, a part of the right one or the dock, is open. The place must
// not be TabPlace::closed (asserted).
bool is_open_at(const WindowView& window, TabPlace place);
// Opens it. The same must be true of the place.
void open_place(WindowView& window, TabPlace place);
// Whether the panels of a region have tabs, by which they can be moved to another such region.
bool has_tabs(Region region);
struct TabInfo {
  std::string id, title;  // of the panel
  TabPlace place;         // where the program puts it
};
// The panels that have a tab.
const std::vector<TabInfo>& tab_infos();

}  // namespace talus
