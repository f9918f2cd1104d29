// Side by side: the same input through another solver or precision, or another branch, and where they part.
#pragma once

#include "panels/panel.h"

namespace talus {

class ComparePanel final : public Panel {
 public:
  std::string_view id() const override { return panel_id::kCompare; }
  std::string_view title() const override { return "Compare"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_choice(const Session& session, Actions& actions, Ui& ui);
  void draw_parting(const Session& session, Actions& actions, Ui& ui);
  void draw_missing(const Session& session, Actions& actions, Ui& ui);
  void draw_bodies(const Session& session, Actions& actions, Ui& ui);
};

}  // namespace talus
