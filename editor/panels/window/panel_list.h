// The list of panels. To add one: write its file, and add its row to panel_list.cpp.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace talus {

// Where the workspace puts a panel. Panels that share a region are its tabs, in the order of the list.
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
// The ids of the panels that have a tab, because they share a region.
std::vector<std::string> tab_ids();

}  // namespace talus
