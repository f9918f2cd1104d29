// The likely problems of the level. A click shows the place; a button, or the menu of the right button, fixes
// the problem. Below them is the proof of the level.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "panels/panel.h"

namespace talus {

class ProblemsPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kProblems; }
  std::string_view title() const override { return "Problems"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // The labels of the fixes for a problem.
  struct Remedy {
    std::vector<std::string> fixes;
    std::uint64_t revision = 0;  // of the level that they were found for
  };

  void draw_bar(const Session& session, Actions& actions, Ui& ui);
  void draw_kinds(const Session& session, Ui& ui);
  void draw_seam(const Session& session, Actions& actions, Ui& ui);
  void draw_rows(const std::vector<std::size_t>& rows, const Session& session, Actions& actions, Ui& ui);
  void draw_row(std::size_t index, const Session& session, Actions& actions, Ui& ui);
  void draw_fix_near(Cell cell, std::size_t row, const Session& session, Actions& actions, Ui& ui);
  void draw_menu(const Problem& problem, const Remedy& remedy, const Session& session, Actions& actions,
                 Ui& ui);
  void preview(const Problem& problem, std::size_t fix, const Session& session, Ui& ui);
  bool has_no_fix(const Problem& problem, const Session& session) const;
  const Remedy& remedy_of(const Problem& problem, const Session& session);

  std::map<std::string, Remedy> remedies_;  // by the text of the problem
  bool is_previewed_ = false;               // in this frame, a fix
  int looked_for_ = 0;                      // number of remedies found in this frame
};

}  // namespace talus
