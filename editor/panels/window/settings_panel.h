// The settings window: theme, sizes, colours, other programs. Choices take effect at once.
#pragma once

#include <optional>
#include <string>

#include "panels/panel.h"

namespace talus {

class SettingsPanel : public Panel {
 public:
  std::string_view id() const override { return "settings"; }
  std::string_view title() const override { return "Settings"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_programs(Ui& ui);
  ProgramCommands typed_;  // text of the fields; used when a field is left
};

}  // namespace talus
