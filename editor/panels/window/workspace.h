// Workspace: lays the panels out in fixed regions with splitters between them.
#pragma once

#include <optional>

#include "panel_list.h"
#include "tab_hand.h"

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
  void open_wanted_columns(View& view) const;
  bool has_panels(Region region, const WindowView& window) const;
  void note_tab_areas(ImVec2 canvas_min, ImVec2 canvas_max);
  // The menu, the columns with the canvas between them, and the bars.
  void draw_regions(Frame& frame, ImVec2 window);
  // The canvas and nothing else.
  void draw_alone(Frame& frame, ImVec2 window);
  void draw_left(Frame& frame, ImVec2 at, ImVec2 size);
  void draw_left_folded(Frame& frame, ImVec2 at, ImVec2 size);
  // Draws the debugger's panels at the bottom of the room, if they are open. Returns their height.
  float draw_dock(Frame& frame, ImVec2 at, ImVec2 room);
  // Draws the pixel canvas above the map and the play view, if it is enlarged. Returns its height.
  float draw_enlarged_pixels(Frame& frame, ImVec2 at, ImVec2 room);
  void draw_right(Frame& frame, ImVec2 at, ImVec2 size);
  // One region: its panel, or tabs of its panels.
  void draw_region(Frame& frame, Region region, ImVec2 at, ImVec2 size);
  void draw_only_panel(Frame& frame, Region region);
  void draw_tabs(Frame& frame, Region region);
  // Its first control gets the focus, if the keys are wanted there.
  void draw_panel(Panel& panel, Frame& frame);
  void follow_mouse(View& view);

  std::vector<PanelPlace> panels_;
  TabHand tab_hand_;
  double alone_since_ = -1;  // s, when the canvas was left alone; negative: it is not
  // The side under the mouse, in this frame and when the mouse moved last.
  std::optional<Focus> pointed_at_, pointed_before_;
};

}  // namespace talus
