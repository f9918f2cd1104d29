// Why: the stages of the chosen body's last step, one by one.
#pragma once

#include "panels/panel.h"

namespace talus {

class WhyPanel final : public Panel {
 public:
  std::string_view id() const override { return panel_id::kWhy; }
  std::string_view title() const override { return "Why"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_stages(const Session& session, Ui& ui);

  int shown_stage_ = -1;  // in the last frame
};

}  // namespace talus
