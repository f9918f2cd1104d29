// The dialog that asks what of a file of another program becomes the level, where it holds more than one can.
#pragma once

#include "panels/panel.h"

namespace talus {

class LevelImportPanel : public Panel {
 public:
  std::string_view id() const override { return "choose"; }
  std::string_view title() const override { return "What to open"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // Each changes the choices as the user does.
  static void draw_layers(const LevelImport& import, ImportChoices& choices, Ui& ui);
  static void draw_tiles(ImportChoices& choices, Ui& ui);
  static void draw_report(const LevelImport& import, Ui& ui);
  static void draw_buttons(const LevelImport& import, Actions& actions, Ui& ui);
};

}  // namespace talus
