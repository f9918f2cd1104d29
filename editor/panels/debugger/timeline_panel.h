// The timeline: every recorded frame in one strip to drag along, with marks and other interesting frames.
#pragma once

#include "panels/panel.h"

namespace talus {

class TimelinePanel final : public Panel {
 public:
  std::string_view id() const override { return "timeline"; }
  std::string_view title() const override { return "Timeline"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_take_over(const Session& session, Actions& actions, Ui& ui);
  void draw_track(const Session& session, Actions& actions, Ui& ui, ImVec2 size);

  std::int64_t shown_ = -1;  // the shown frame when it was drawn last
};

}  // namespace talus
