// The flags of the selected tiles: lamps of single flags, choices of fields, and all as a number.
#pragma once

#include <string>

#include "edit/flag_lamps.h"
#include "flag_menu.h"
#include "panels/panel.h"

namespace talus {

// The height in px that the flags which no cart has add to the panel.
float height_of_more_flags(const Level& level, const Ui& ui);

class FlagsPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kFlags; }
  std::string_view title() const override { return "Flags"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  void draw_header(const Session& session, Actions& actions, Ui& ui);
  void draw_number(const Session& session, Actions& actions, Ui& ui);
  void draw_more(const Level& level, Ui& ui);
  // The lamps of eight flags, and the fields that begin among them.
  void draw_eight(const Session& session, Actions& actions, Ui& ui, int first);
  void draw_lamp(const Session& session, Actions& actions, Ui& ui, int flag, float width);
  void draw_field(const Session& session, Actions& actions, Ui& ui, const FlagField& field);

  FlagMenu menu_;
  AreaFlags now_;               // of the selected tiles
  std::string number_;          // as it is being typed
  bool number_active_ = false;  // in the last frame
};

}  // namespace talus
