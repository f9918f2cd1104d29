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
  // path: "Debug/Timeline"
  void draw_menu(const std::string& path, const Session& session, Actions& actions, Ui& ui);
  void draw_end_of_section(const std::string& menu, int section, const Session& session, Actions& actions,
                           Ui& ui);
  void draw_title(const Session& session, Actions& actions, Ui& ui);
  void draw_all_commands(const Session& session, Actions& actions, Ui& ui);
  void draw_maps(const Session& session, Actions& actions, Ui& ui);
  void draw_recent_files(const Session& session, Actions& actions, Ui& ui);
  void draw_hard_cases(const Session& session, Actions& actions, Ui& ui);
  void draw_export_targets(const Session& session, Actions& actions, Ui& ui);
  void draw_panels(const Session& session, Actions& actions, Ui& ui);
  void draw_edit_rule(const Session& session, Actions& actions, Ui& ui);
  void draw_scale_choice(const Session& session, Actions& actions, Ui& ui);
};

}  // namespace talus
