// TabHand: drags a tab to another region, or to an edge of the canvas.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

#include "panels/ui/ui.h"
#include "tab_places.h"

namespace talus {

class TabHand {
 public:
  void begin_frame() { areas_.clear(); }
  // A tab that is let go there goes to this place; px of the screen. Of areas over one another the first
  // counts.
  void add_area(TabPlace place, ImVec2 min, ImVec2 max) { areas_.push_back({place, min, max}); }
  // Must follow ImGui's item of a tab: begins to drag it, and has its menu.
  void take_tab(const std::string& panel, std::string_view title, Ui& ui);
  // After all regions: shows where the tab would go, and moves it when it is let go.
  void end_frame(Ui& ui);

 private:
  struct Area {
    TabPlace place;
    ImVec2 min, max;
    bool has(ImVec2 p) const { return p.x >= min.x && p.x < max.x && p.y >= min.y && p.y < max.y; }
  };
  void draw_menu(const std::string& panel, Ui& ui);

  std::vector<Area> areas_;
  bool is_cancelled_ = false;    // the drag is over, although the button is still held
  std::string dragged_, title_;  // of the panel; empty: none is dragged
};

}  // namespace talus
