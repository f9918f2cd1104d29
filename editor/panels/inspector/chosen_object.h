// The chosen object, for the object tool.
#pragma once

#include "session/session.h"

namespace talus {

// The chosen object; null: none is chosen, or it is gone.
const MapObject* chosen_object(const Session& session);
// Carries out Delete for the object tool: removes the chosen object.
void delete_object(const Session& session, Actions& actions);
// Moves the chosen object by so many px; moves in a row are one undo step. Says why if it cannot be moved.
void move_chosen_object(const Session& session, Actions& actions, Vec2 by);

}  // namespace talus
