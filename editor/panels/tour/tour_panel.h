// The tour: a note beside what it is about, which waits until the user has done it.
#pragma once

#include <optional>

#include "panels/panel.h"
#include "tour_steps.h"

namespace talus {

class TourPanel : public Panel {
 public:
  std::string_view id() const override { return "tour"; }
  std::string_view title() const override { return "Tour"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // Goes to the next step if this one is done.
  void follow(const Session& session, Actions& actions, Ui& ui);
  void draw_note(Ui& ui);
  void draw_end(Ui& ui);

  // Opens the tour when its level is open, unless the user has kept the one before.
  void wait_for_level(const Session& session, View& view);
  std::optional<TourStart> start_;  // of the current step; nothing: it begins with the next frame
  int frames_waited_ = 0;           // for the level of the tour, while nothing says that it will come
  int level_number_ = -1;           // of the level in which the step began
  ImVec2 size_;                     // px of the screen, of the note in the frame before
};

}  // namespace talus
