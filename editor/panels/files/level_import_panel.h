// The dialog that asks which part of another program's file becomes the level, if the file has more than one
// can hold.
#pragma once

#include "panels/panel.h"

namespace talus {

class LevelImportPanel : public Panel {
 public:
  std::string_view id() const override { return "choose"; }
  std::string_view title() const override { return "What to open"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // Each returns the choices changed by the user.
  static void draw_levels(const LevelImport& import, ImportChoices& choices, Ui& ui);
  static void draw_layers(const LevelImport& import, ImportChoices& choices, Ui& ui);
  static void draw_mapping(const LevelImport& import, ImportChoices& choices, Ui& ui);
  static void draw_tiles(ImportChoices& choices, Ui& ui);
  static void draw_report(const LevelImport& import, Ui& ui);
  static void draw_buttons(const LevelImport& import, Actions& actions, Ui& ui);
};

}  // namespace talus
