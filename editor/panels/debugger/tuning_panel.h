// The solver, and every number of the physics: drag it, type it, reset it.
#pragma once

#include "panels/panel.h"

namespace talus {

class TuningPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kTuning; }
  std::string_view title() const override { return "Tuning"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  static void draw_group(std::string_view group, Ui& ui);
  void draw_field(const TuningField& field, const Session& session, Actions& actions, Ui& ui);
  int stroke_ = 0;  // of the current drag: one undo for each drag
};

}  // namespace talus
