// RgbaSwatches: the colours of the two buttons, and those of the picture, to choose from.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "edit/sprite_area.h"
#include "panels/ui/ui.h"
#include "rgba_picker.h"
#include "session/session.h"

namespace talus {

class RgbaSwatches {
 public:
  void draw(const Session& session, Actions& actions, Ui& ui, ImVec2 room);

 private:
  void draw_buttons(const Session& session, Ui& ui, ImVec2 size);
  void draw_grid(const Session& session, Actions& actions, Ui& ui, ImVec2 room);
  void draw_swatch(const Session& session, Actions& actions, Ui& ui, int index, ImVec2 size);
  void draw_popup(const Session& session, Actions& actions, Ui& ui);
  void count_colors(const Session& session);

  RgbaPicker picker_{"picker"};
  std::vector<Rgba> colors_;  // of the picture
  SpriteArea counted_area_;   // what they were counted for
  std::optional<std::uint64_t> counted_revision_;
};

}  // namespace talus
