// The transport bar: play, step, speed, and the switches of the overlays, which are also their legend.
#pragma once

#include "panels/panel.h"

namespace talus {

class TransportPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kTransport; }
  std::string_view title() const override { return "Play"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_frame(const Session& session, Actions& actions, Ui& ui);

  std::int64_t typed_ = 0;  // text of the frame's field
  bool typing_ = false;
};

}  // namespace talus
