// What the left button does with the ground tool: it paints ground, with Ctrl takes it away, and with Shift
// does so to a rectangle.
#pragma once

#include <optional>

#include "camera.h"
#include "edit/auto_tile.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

class GroundGesture {
 public:
  // As MapGesture::update.
  void update(const Session& session, Actions& actions, Ui& ui, Cell cell, bool pressed, bool down);
  void draw_preview(ImDrawList& list, const CanvasView& view, const Ui& ui, Cell cell) const;
  bool active() const { return from_.has_value(); }

 private:
  std::optional<Cell> from_;  // where the button went down
  Cell last_;
  GroundChange change_ = GroundChange::add;
  bool is_rectangle_ = false;
  int stroke_ = 0;
};

// Brings the panel with the ground's tiles to the front and says what it is for.
void ask_for_ground_tiles(Actions& actions, Ui& ui);

}  // namespace talus
