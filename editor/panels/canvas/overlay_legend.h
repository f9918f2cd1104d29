// The overlays' legend: the names of those that are shown, in the corner of a play view, while the switches
// have no room for them.
#pragma once

#include <optional>

#include "overlay_labels.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class OverlayLegend {
 public:
  // top: y below which it lies, px of the screen. Where names would hide too much, or are folded away, it has
  // swatches alone.
  OverlayLegend(const Choices& choices, const CanvasView& view, float top, const Ui& ui);

  // Its width at most, px; 0: there is none. To find out what is free beside it.
  static float width(const Choices& choices, const Ui& ui);
  bool has_names() const { return has_names_; }
  const std::optional<ScreenBox>& box() const { return box_; }  // nothing: there is none
  void draw(ImDrawList& list) const;
  // To be called after the canvas's item. True: the mouse is on it, and not meant for what is below. A click
  // folds it or shows the names again.
  bool take_mouse(Ui& ui) const;

 private:
  void lay_out_names(ImVec2 corner);
  void lay_out_swatches(ImVec2 corner, float room);
  std::string help() const;

  const Choices& choices_;
  const Ui& ui_;
  std::vector<OverlayId> shown_;
  std::optional<ScreenBox> box_;
  bool has_names_ = false;
  bool is_tight_ = false;  // names would have no room
  int rows_ = 1;           // of swatches
};

}  // namespace talus
