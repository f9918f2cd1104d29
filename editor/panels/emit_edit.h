// Emits edits of the level.
#pragma once

#include <utility>

#include "session/actions.h"

namespace talus {

// Emits the edit, unless it neither changes nor selects anything. stroke: as in action::EditLevel; 0 for one
// of its own.
inline void emit_edit(Actions& actions, Edit edit, int stroke = 0) {
  if (!edit.empty() || edit.selection) actions.push_back(action::EditLevel{std::move(edit), stroke});
}

}  // namespace talus
