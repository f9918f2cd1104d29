// Finds, moves and removes the chosen object.
#include "chosen_object.h"

#include <utility>

#include "edit/object_tools.h"

namespace talus {

const MapObject* chosen_object(const Session& session) {
  return find_object(session.level(), session.choices().object);
}

void delete_object(const Session& session, Actions& actions) {
  const ObjectRef chosen = session.choices().object;
  if (chosen_object(session) == nullptr) return;
  if (const auto problem = problem_of_layer(session.level(), chosen.layer))
    return actions.push_back(action::ShowMessage{*problem, true});
  actions.push_back(action::EditLevel{remove_object(session.level(), chosen)});
  actions.push_back(action::SelectObject{{chosen.layer, -1}});
}

void move_chosen_object(const Session& session, Actions& actions, Vec2 by) {
  const ObjectRef chosen = session.choices().object;
  const MapObject* const object = chosen_object(session);
  if (object == nullptr) return;
  if (const auto problem = problem_of_layer(session.level(), chosen.layer))
    return actions.push_back(action::ShowMessage{*problem, true});
  MapObject moved = *object;
  moved.position = moved.position + by;
  if (const auto problem = problem_of_object(moved))
    return actions.push_back(action::ShowMessage{"Not moved: the object " + *problem + ".", true});
  MovedObject move = move_object(session.level(), session.history(), chosen, by, session.next_stroke());
  actions.push_back(action::EditLevel{std::move(move.edit), move.stroke});
}

}  // namespace talus
