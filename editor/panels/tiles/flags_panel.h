// The flags of the selected tiles: lamps of single flags, choices of fields, and all eight as a byte.
#pragma once

#include <string>

#include "flag_menu.h"
#include "panels/panel.h"

namespace talus {

class FlagsPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kFlags; }
  std::string_view title() const override { return "Flags"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_header(const Session& session, Actions& actions, Ui& ui);
  void draw_byte(const Session& session, Actions& actions, Ui& ui);
  void draw_lamp(const Session& session, Actions& actions, Ui& ui, int flag, float width);
  void draw_field(const Session& session, Actions& actions, Ui& ui, const FlagField& field);

  FlagMenu menu_;
  std::string byte_;          // as it is being typed
  bool byte_active_ = false;  // in the last frame
};

}  // namespace talus
