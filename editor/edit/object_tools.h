// Edits of the layers of objects and of pictures, and of single objects.
#pragma once

#include <optional>
#include <string>

#include "level/edit.h"
#include "undo_stack.h"

namespace talus {

// An object of the level.
struct ObjectRef {
  int layer = -1;  // index in Level::objects; -1: no object
  int index = -1;  // in its list; -1: none of the layer
  friend bool operator==(const ObjectRef&, const ObjectRef&) = default;
};
// The object; null if the level has no such one.
const MapObject* find_object(const Level& level, ObjectRef ref);

// layer, here and below: an index in Level::objects. Each edit is empty if there is no such layer, or if it
// changes nothing.

// Makes areas and lines of the layer ground, or no ground.
Edit set_object_ground(const Level& level, int layer, bool is_ground);
// Shows or hides it.
Edit set_object_visible(const Level& level, int layer, bool visible);
// Locks or unlocks it.
Edit set_object_locked(const Level& level, int layer, bool locked);
// Gives it another name.
Edit rename_objects(const Level& level, int layer, const std::string& name);

// Why the objects of a layer cannot be changed: it is hidden or locked, or a picture. A sentence; nothing if
// they can, or if there is no such layer.
std::optional<std::string> problem_of_layer(const Level& level, int layer);
// Why no level can hold the object, as the end of a sentence ("is too far from the map"); nothing if one can.
std::optional<std::string> problem_of_object(const MapObject& object);

// Puts an object in front of the others of its layer. Without such a layer, a new one gets it, in front of
// all.
Edit add_object(const Level& level, int layer, MapObject object);
// The place of the object that add_object() adds.
ObjectRef place_of_added(const Level& level, int layer);
// Each of these is empty if there is no such object, or if it changes nothing.
Edit change_object(const Level& level, ObjectRef ref, MapObject object, std::string label);
Edit remove_object(const Level& level, ObjectRef ref);
// Moves it by so many px. stroke: that of the last entry of the history, if that moved the same object in
// this way and still takes edits, so that a row of moves is one undo step; else new_stroke.
struct MovedObject {
  Edit edit;
  int stroke;
};
MovedObject move_object(const Level& level, const UndoStack& history, ObjectRef ref, Vec2 by, int new_stroke);
// The copy is one tile further right and down, in front of the others.
Edit duplicate_object(const Level& level, ObjectRef ref);

// The name on screen: its name, or its class, or its form and its number from 1: "ellipse 2".
std::string object_title(const Level& level, ObjectRef ref);
// "rectangle", "point", "ellipse", "polygon", "polyline", "tile" or "other".
std::string_view word_of_form(const MapObject& object);

// The name of a layer for people, and how many objects it has: "walls, 12 objects", "sky, a picture".
std::string object_layer_text(const Level& level, int layer);

}  // namespace talus
