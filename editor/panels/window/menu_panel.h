// The menu bar, made from the table of commands.
#pragma once

#include <string>
#include <vector>

#include "panels/panel.h"

namespace talus {

class MenuPanel : public Panel {
 public:
  std::string_view id() const override { return "menu"; }
  std::string_view title() const override { return "Menu"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_all_commands(const Session& session, Actions& actions, Ui& ui);
  void draw_recent_files(Actions& actions, Ui& ui);
  void draw_hard_cases(Actions& actions, Ui& ui);
  void draw_edit_rule(const Session& session, Actions& actions, Ui& ui);
  void draw_scale_choice(Ui& ui);
};

}  // namespace talus
