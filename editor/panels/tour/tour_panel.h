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
  void follow(const Session& session, Ui& ui);
  void draw_note(Ui& ui);
  void draw_end(Ui& ui);

  std::optional<TourStart> start_;  // of the current step; nothing: it begins with the next frame
  ImVec2 size_;                     // px of the screen, of the note in the frame before
};

}  // namespace talus
