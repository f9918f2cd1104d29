// The brushes of the level, and the tiles of its ground.
#pragma once

#include <string>

#include "panels/panel.h"
#include "panels/ui/number_field.h"

namespace talus {

class BrushesPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kBrushes; }
  std::string_view title() const override { return "Brushes"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_buttons(const Session& session, Actions& actions, Ui& ui) const;
  void draw_probability(const Session& session, Actions& actions, Ui& ui);
  void draw_list(const Session& session, Actions& actions, Ui& ui);
  void draw_brush(int index, const Session& session, Actions& actions, Ui& ui);
  void draw_name(int index, float width, const Session& session, Actions& actions, Ui& ui);
  void draw_ground(const Session& session, Actions& actions, Ui& ui) const;

  NumberEdit number_edit_;
  int renamed_ = -1;      // the brush whose name is being typed; -1: none
  std::string new_name_;  // as it is being typed
};

}  // namespace talus
