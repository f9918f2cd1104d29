// The part of the inspector for a body that was placed by hand: what it is, and how it starts.
#pragma once

#include <string>

#include "body_picture_fields.h"
#include "panels/ui/number_field.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class SpawnInspector {
 public:
  // index: into the level's spawns.
  void draw(const Session& session, int index, Actions& actions, Ui& ui);

 private:
  void draw_name(const Session& session, int index, Actions& actions, Ui& ui);
  void draw_kind(const Session& session, int index, Actions& actions, Ui& ui);
  void draw_foot(const Session& session, int index, Actions& actions, Ui& ui);
  void draw_start(const Session& session, int index, Actions& actions, Ui& ui);
  void draw_size(const Session& session, int index, Actions& actions, Ui& ui);

  int shown_ = -1;    // the spawn that name_ belongs to
  std::string name_;  // as it is being typed
  NumberEdit number_;
  BodyPictureFields picture_;
};

}  // namespace talus
