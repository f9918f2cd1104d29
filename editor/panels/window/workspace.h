// Workspace: lays the panels out in fixed regions with splitters between them.
#pragma once

#include <optional>

#include "panel_list.h"

namespace talus {

class Workspace {
 public:
  Workspace() : panels_(make_panels()) {}
  // Draws the whole window.
  void draw(const Session& session, Actions& actions, Ui& ui);

 private:
  struct Frame {
    const Session& session;
    Actions& actions;
    Ui& ui;
  };
  void draw_left(Frame& frame, ImVec2 at, ImVec2 size);
  void draw_left_folded(Frame& frame, ImVec2 at, ImVec2 size);
  // Draws the debugger's panels at the bottom of the room, if they are open. Returns their height.
  float draw_dock(Frame& frame, ImVec2 at, ImVec2 room);
  // Draws the pixel canvas above the map and the play view, if it is enlarged. Returns its height.
  float draw_enlarged_pixels(Frame& frame, ImVec2 at, ImVec2 room);
  void draw_right(Frame& frame, ImVec2 at, ImVec2 size);
  // One region: its panel, or tabs of its panels.
  void draw_region(Frame& frame, Region region, ImVec2 at, ImVec2 size);
  void draw_tabs(Frame& frame, Region region);
  // Its first control gets the focus, if the keys are wanted there.
  void draw_panel(Panel& panel, Frame& frame);
  void follow_mouse(View& view);

  std::vector<PanelPlace> panels_;
  // The side under the mouse, in this frame and when the mouse moved last.
  std::optional<Focus> pointed_at_, pointed_before_;
};

}  // namespace talus
