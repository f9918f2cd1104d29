// The dialog that shows what an imported picture would change in the level.
#pragma once

#include "panels/panel.h"

namespace talus {

class PictureImportPanel : public Panel {
 public:
  std::string_view id() const override { return "import"; }
  std::string_view title() const override { return "Import a picture"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  // Each returns the options as the user has now set them.
  static PngImportOptions draw_options(const PngImport& import, Ui& ui);
  static PngImportOptions draw_pictures(const Session& session, const PngImport& import,
                                        PngImportOptions options, Ui& ui);
  static void draw_report(const PngImport& import, Ui& ui);
  static void draw_buttons(const PngImport& import, Actions& actions, Ui& ui);
};

}  // namespace talus
