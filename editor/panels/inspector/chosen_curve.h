// The chosen curve, for the tools that draw curves.
#pragma once

#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

inline bool draws_curves(MapTool tool) { return tool == MapTool::segment || tool == MapTool::curve; }

// Index of the chosen curve; -1: none is chosen, or it is gone.
int chosen_curve(const Session& session);
// Carries out Delete for these tools: removes the curve under the mouse, or else the chosen one.
void delete_curve(const Session& session, Actions& actions, const Ui& ui);

}  // namespace talus
