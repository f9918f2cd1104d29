// The changes that can be undone and redone. A click goes to one.
#pragma once

#include "panels/panel.h"

namespace talus {

class HistoryPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kHistory; }
  std::string_view title() const override { return "History"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  std::size_t followed_ = 0;  // the position in the history that the list last scrolled to
};

}  // namespace talus
