// The curve that is chosen, and the tools for curves.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

inline bool draws_curves(MapTool tool) { return tool == MapTool::segment || tool == MapTool::curve; }

// The chosen curve's index; -1: none, or it is gone.
int chosen_curve(const Session& session);
// What Delete does with these tools: takes away the curve under the mouse, else the chosen one.
void delete_curve(const Session& session, Actions& actions, const Ui& ui);

}  // namespace talus
