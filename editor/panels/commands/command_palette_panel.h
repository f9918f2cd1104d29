// The command palette: the user types a few letters of a command, and Enter runs it.
#pragma once

#include <optional>
#include <string>

#include "panels/panel.h"

namespace talus {

class CommandPalettePanel : public Panel {
 public:
  std::string_view id() const override { return "command_palette"; }
  std::string_view title() const override { return "Find a command"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_list(const Session& session, Actions& actions, Ui& ui);
  std::string typed_;
  std::optional<int> chosen_;  // row of the list that the arrow keys went to
};

}  // namespace talus
