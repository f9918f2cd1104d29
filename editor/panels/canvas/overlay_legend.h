// The legend of the overlays: the names of the shown ones in the corner of a play view, if the switches have
// no room for them.
#pragma once

#include <optional>

#include "overlay_labels.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class OverlayLegend {
 public:
  // top: y below which it lies, px of the screen. If names would hide too much, or are folded away, it has
  // only swatches.
  OverlayLegend(const Session& session, const CanvasView& view, float top, const Ui& ui);

  // Its largest width, px; 0: there is no legend. The rest of the line is free beside it.
  static float width(const Session& session, const Ui& ui);
  bool has_names() const { return has_names_; }
  const std::optional<ScreenBox>& box() const { return box_; }  // nothing: there is none
  void draw(ImDrawList& list) const;
  // Call it after the canvas's item. Returns true if the mouse is on the legend, and so not meant for what is
  // below. A click folds the names away or shows them again.
  bool take_mouse(Ui& ui) const;

 private:
  void lay_out_names(ImVec2 corner);
  void lay_out_swatches(ImVec2 corner, float room);
  std::string help() const;

  const Session& session_;
  const Ui& ui_;
  std::vector<const Overlay*> shown_;
  std::optional<ScreenBox> box_;
  bool has_names_ = false;
  bool is_tight_ = false;  // whether names would have no room
  int rows_ = 1;           // rows of swatches
};

}  // namespace talus
