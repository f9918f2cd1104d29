// Where a player gets to: the search, its progress, and the way to a cell.
#pragma once

#include "panels/panel.h"

namespace talus {

class ReachPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kReach; }
  std::string_view title() const override { return "Reach"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_way(const Session& session, Actions& actions, Ui& ui);

  std::optional<Cell> cell_;     // the reached cell that the panel describes
  std::optional<Cell> chosen_;   // the cell that was clicked last
  std::optional<Cell> clicked_;  // the clicked cell of the canvas at the last look, reached or not
};

}  // namespace talus
