// The welcome page: a window over the workspace with what one may start with. The level goes on behind it.
#pragma once

#include <string>

#include "level_preview.h"
#include "panels/panel.h"

namespace talus {

class WelcomePanel : public Panel {
 public:
  std::string_view id() const override { return "welcome"; }
  std::string_view title() const override { return "Welcome"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_title(const Session& session, Ui& ui);
  void draw_start(const Session& session, Actions& actions, Ui& ui);
  void draw_new_level(const Session& session, Actions& actions, Ui& ui);
  void draw_levels(Actions& actions, Ui& ui);
  void draw_examples(Actions& actions, Ui& ui);

  LevelPreviews previews_;
  std::size_t group_ = 0;  // of the examples that are shown
  // The new level.
  int side_ = 16;  // px, of its tiles
};

}  // namespace talus
