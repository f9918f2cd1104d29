// The part of the inspector about the chosen object: its name, class, place, form and properties.
#pragma once

#include <string>

#include "edit/object_tools.h"
#include "panels/ui/number_field.h"
#include "panels/ui/property_table.h"
#include "panels/ui/ui.h"

namespace talus {

class ObjectInspector {
 public:
  void draw(const Session& session, Actions& actions, Ui& ui);

 private:
  void draw_kind(const Session& session, Actions& actions, Ui& ui) const;
  void draw_layer(const Session& session, Actions& actions, Ui& ui) const;
  void draw_texts(const Session& session, const MapObject& object, Actions& actions, Ui& ui);
  void draw_numbers(const Session& session, const MapObject& object, Actions& actions, Ui& ui);
  void draw_properties(const Session& session, const MapObject& object, Actions& actions, Ui& ui);

  ObjectRef shown_;          // in the last frame
  std::string name_, type_;  // while they are typed
  PropertyTable properties_;
  NumberEdit number_;
};

}  // namespace talus
