// The interactive widgets of a frame by name, such as "flags/lamp3", with their places on the screen. Tests
// and the help find widgets here.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>
#include <vector>

namespace talus {

struct Widget {
  std::string name;           // "<panel>/<widget>", unique in a frame
  ImVec2 min, max;            // px of the window, half open
  ImVec2 clip_min, clip_max;  // what its region shows
  bool scrolls = false;       // lies in a region that scrolls, so it may be cut off above and below
  bool enabled = true;
  ImVec2 centre() const { return {(min.x + max.x) / 2, (min.y + max.y) / 2}; }
};

class WidgetRegistry {
 public:
  void begin_frame() { widgets_.clear(); }
  void add(Widget widget) { widgets_.push_back(std::move(widget)); }
  // Returns null if this frame has no such widget. The last one of a name wins: it lies on top.
  const Widget* find(std::string_view name) const {
    for (auto it = widgets_.rbegin(); it != widgets_.rend(); ++it)
      if (it->name == name) return &*it;
    return nullptr;
  }
  const std::vector<Widget>& all() const { return widgets_; }

 private:
  std::vector<Widget> widgets_;
};

}  // namespace talus
