// The part of the inspector for the tools that draw curves: the kind of the next curve, and the chosen curve.
#pragma once

#include <string>

#include "panels/ui/number_field.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

class CurveInspector {
 public:
  void draw(const Session& session, Actions& actions, Ui& ui);

 private:
  void draw_kind(const Session& session, Actions& actions, Ui& ui) const;
  void draw_name(const Session& session, Actions& actions, Ui& ui, int curve);
  void draw_faces(const Session& session, Actions& actions, Ui& ui, int curve);
  void draw_numbers(const Session& session, Actions& actions, Ui& ui, int curve);
  void change(const Session& session, Actions& actions, int curve, LevelCurve changed, std::string label,
              int stroke);

  int shown_ = -1;       // the curve of the fields below
  std::string name_;     // as it is being typed
  std::string problem_;  // why the last number was refused; empty: it was accepted
  NumberEdit number_;
};

}  // namespace talus
