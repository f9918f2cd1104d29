// Actions: changing the level, undo and redo.
#pragma once

#include <variant>

#include "level/edit.h"

namespace talus {
namespace action {

struct EditLevel {  // an edit made by a tool; a stroke > 0 merges with an entry of the same stroke before it
  Edit edit;
  int stroke = 0;
};
struct Undo {};
struct Redo {};

}  // namespace action

// The actions that LevelHandler carries out.
using LevelAction = std::variant<action::EditLevel, action::Undo, action::Redo>;

}  // namespace talus
