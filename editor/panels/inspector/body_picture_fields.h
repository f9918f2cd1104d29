// The part of the inspector for the picture of a body that was placed by hand.
#pragma once

#include "panels/ui/number_field.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class BodyPictureFields {
 public:
  // A row for each act: its frames, and buttons that give it the chosen tiles of the sheet or none. index:
  // into the level's spawns.
  void draw(const Session& session, int index, Actions& actions, Ui& ui);

 private:
  void draw_act(BodyAct act, const Session& session, int index, Actions& actions, Ui& ui);
  void draw_frame(const Session& session, int index, Actions& actions, Ui& ui);

  NumberEdit number_;
};

}  // namespace talus
