// The export window: the level's presets, what the chosen one would write, and writing it.
#pragma once

#include "panels/panel.h"

namespace talus {

class ExportPanel : public Panel {
 public:
  std::string_view id() const override { return "export"; }
  std::string_view title() const override { return "Export"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  static void draw_first_targets(const Session& session, Actions& actions, Ui& ui);
  void draw_presets(const Session& session, Actions& actions, Ui& ui);
  void draw_preset_buttons(const Session& session, Actions& actions, Ui& ui);
  void draw_preset(const Session& session, Actions& actions, Ui& ui);
  void draw_name(const Session& session, Actions& actions, Ui& ui);
  void draw_target(const Session& session, Actions& actions, Ui& ui);
  void draw_target_choice(const Session& session, Actions& actions, Ui& ui);
  void draw_path(const Session& session, Actions& actions, Ui& ui);
  void draw_parts(const Session& session, Actions& actions, Ui& ui);

  std::string name_, path_, parts_;  // as typed, until the field is left
  std::string target_;               // text to search for among the targets
};

}  // namespace talus
