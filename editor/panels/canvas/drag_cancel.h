// Escape during a drag: cancels it.
#pragma once

#include "panels/ui/dialog.h"
#include "session/session.h"

namespace talus {

inline bool is_drag_cancelled() { return key_pressed(ImGuiKey_Escape); }

// Undoes the edits of the drag's stroke. Redo makes them again.
inline void take_back(const Session& session, Actions& actions, int stroke) {
  if (stroke > 0 && session.history().open_stroke() == stroke) actions.push_back(action::Undo{});
}

}  // namespace talus
