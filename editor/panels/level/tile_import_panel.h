// The dialog that shows how a picture is cut into tiles, for a new level or for a tileset of the open one.
#pragma once

#include <memory>

#include "panels/panel.h"

namespace talus {

class TileImportPanel : public Panel {
 public:
  std::string_view id() const override { return "tiles"; }
  std::string_view title() const override { return "Tiles from a picture"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void begin(const TileImport& import);
  void draw_picture(const TileImport& import, bool is_good, Ui& ui) const;
  void draw_fields(const TileImport& import, Ui& ui);
  void draw_answers(const TileImport& import, const std::string& problem, const Session& session,
                    Actions& actions, Ui& ui);

  std::weak_ptr<const TileFile> file_;  // the picture that the order is for
  action::ApplyTiles order_;            // as the fields say, possible or not
};

}  // namespace talus
