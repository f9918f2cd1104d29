// The inspector: the chosen body's numbers and every contact of its last step, in order. With a tool that
// draws curves it shows the chosen curve, and with the object tool the chosen object.
#pragma once

#include "curve_inspector.h"
#include "object_inspector.h"
#include "panels/panel.h"
#include "spawn_inspector.h"

namespace talus {

class InspectorPanel : public Panel {
 public:
  std::string_view id() const override { return panel_id::kInspector; }
  std::string_view title() const override { return "Inspector"; }
  void draw(const Session& session, Actions& actions, Ui& ui) override;

 private:
  SpawnInspector spawn_;
  CurveInspector curve_;
  ObjectInspector object_;
};

}  // namespace talus
