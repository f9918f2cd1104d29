#include "object_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "level/single_change.h"
#include "object_handles.h"

namespace talus {
namespace {

bool has_object_layer(const Level& level, int layer) {
  return layer >= 0 && layer < static_cast<int>(level.objects.size());
}

Edit set_mark(const Level& level, int layer, bool ObjectLayer::*mark, bool on, std::string label) {
  if (!has_object_layer(level, layer)) return {std::move(label), {}};
  std::vector<ObjectLayer> layers = level.objects;
  layers[static_cast<std::size_t>(layer)].*mark = on;
  return single_change(std::move(label), ObjectsChange{level.objects, std::move(layers)});
}

ObjectLayer& layer_in(std::vector<ObjectLayer>& layers, int layer) {
  return layers[static_cast<std::size_t>(layer)];
}

// The edit to these layers.
Edit objects_edit(const Level& level, std::string label, std::vector<ObjectLayer> after) {
  return single_change(std::move(label), ObjectsChange{level.objects, std::move(after)});
}

constexpr const char* kMoveLabel = "Move an object by keys";

// Whether the last entry of the history moved this object, and still takes edits.
bool goes_on(const Level& level, const UndoStack& history, ObjectRef ref) {
  if (history.open_stroke() == 0) return false;
  const Edit& last = history.edits()[history.position() - 1];
  if (last.label != kMoveLabel || last.changes.size() != 1) return false;
  const auto* const change = std::get_if<ObjectsChange>(&last.changes.front());
  if (change == nullptr || change->before.size() != level.objects.size()) return false;
  std::vector<ObjectLayer> before = change->before;
  std::vector<MapObject>& objects = layer_in(before, ref.layer).objects;
  const auto index = static_cast<std::size_t>(ref.index);
  if (index >= objects.size()) return false;
  objects[index] = *find_object(level, ref);
  return before == level.objects;
}

}  // namespace

const MapObject* find_object(const Level& level, ObjectRef ref) {
  if (!has_object_layer(level, ref.layer)) return nullptr;
  const std::vector<MapObject>& objects = level.objects[static_cast<std::size_t>(ref.layer)].objects;
  const bool is_there = ref.index >= 0 && ref.index < static_cast<int>(objects.size());
  return is_there ? &objects[static_cast<std::size_t>(ref.index)] : nullptr;
}

std::optional<std::string> problem_of_layer(const Level& level, int layer) {
  if (!has_object_layer(level, layer)) return std::nullopt;
  const ObjectLayer& its = level.objects[static_cast<std::size_t>(layer)];
  const std::string name = "The layer of objects \"" + its.name + "\" is ";
  const LayerLooks looks = shown_looks(level.layers.groups, its);
  const auto remedy = [](bool is_own, const char* what) {
    return std::string(": ") + what + (is_own ? " it" : " its group") + " under Layers to change it.";
  };
  if (its.image) return name + "a picture, which has no objects.";
  if (looks.locked) return name + "locked" + remedy(its.locked, "unlock");
  if (!looks.visible) return name + "hidden" + remedy(!its.visible, "show");
  return std::nullopt;
}

std::optional<std::string> problem_of_object(const MapObject& object) {
  const auto is_near = [](Vec2 p) {  // false for what is not a number
    return std::abs(p.x) <= kMaxObjectPlace && std::abs(p.y) <= kMaxObjectPlace;
  };
  if (!is_near(object.position) || !std::all_of(object.points.begin(), object.points.end(), is_near))
    return "is too far from the map";
  if (!is_near(object.size)) return "is too large";
  if (object.size.x < 0 || object.size.y < 0) return "has a negative size";
  constexpr double kMaxTurn = 1e9;  // degrees
  if (!(std::abs(object.rotation) <= kMaxTurn)) return "is turned by too much";
  return std::nullopt;
}

Edit add_object(const Level& level, int layer, MapObject object) {
  std::vector<ObjectLayer> after = level.objects;
  if (!has_object_layer(level, layer)) {
    layer = static_cast<int>(after.size());
    after.emplace_back().name = "objects";
  }
  const std::string label = "Add a " + std::string(word_of_form(object));
  layer_in(after, layer).objects.push_back(std::move(object));
  return objects_edit(level, label, std::move(after));
}

ObjectRef place_of_added(const Level& level, int layer) {
  if (!has_object_layer(level, layer)) return {static_cast<int>(level.objects.size()), 0};
  return {layer, static_cast<int>(level.objects[static_cast<std::size_t>(layer)].objects.size())};
}

Edit change_object(const Level& level, ObjectRef ref, MapObject object, std::string label) {
  if (find_object(level, ref) == nullptr) return {std::move(label), {}};
  std::vector<ObjectLayer> after = level.objects;
  layer_in(after, ref.layer).objects[static_cast<std::size_t>(ref.index)] = std::move(object);
  return objects_edit(level, std::move(label), std::move(after));
}

MovedObject move_object(const Level& level, const UndoStack& history, ObjectRef ref, Vec2 by,
                        int new_stroke) {
  const MapObject* const object = find_object(level, ref);
  if (object == nullptr) return {{kMoveLabel, {}}, new_stroke};
  const int stroke = goes_on(level, history, ref) ? history.open_stroke() : new_stroke;
  return {change_object(level, ref, moved_object(*object, by), kMoveLabel), stroke};
}

Edit remove_object(const Level& level, ObjectRef ref) {
  if (find_object(level, ref) == nullptr) return {"Remove an object", {}};
  std::vector<ObjectLayer> after = level.objects;
  std::vector<MapObject>& objects = layer_in(after, ref.layer).objects;
  objects.erase(objects.begin() + ref.index);
  return objects_edit(level, "Remove an object", std::move(after));
}

Edit duplicate_object(const Level& level, ObjectRef ref) {
  const MapObject* const object = find_object(level, ref);
  if (object == nullptr) return {"Duplicate an object", {}};
  MapObject copy = *object;
  const TileSize tile = level.map.tile_size();
  copy.position = copy.position + Vec2{1.0 * tile.width, 1.0 * tile.height};
  Edit edit = add_object(level, ref.layer, std::move(copy));
  edit.label = "Duplicate an object";
  return edit;
}

std::string_view word_of_form(const MapObject& object) {
  constexpr std::array<std::string_view, 6> kWords = {"rectangle", "ellipse", "polygon",
                                                      "polyline",  "tile",    "other"};
  if (object.form == MapObject::Form::box && object.size == Vec2()) return "point";
  return kWords[static_cast<std::size_t>(object.form)];
}

std::string object_title(const Level& level, ObjectRef ref) {
  const MapObject* const object = find_object(level, ref);
  if (object == nullptr) return "no object";
  if (!object->name.empty()) return object->name;
  if (!object->type.empty()) return object->type;
  return std::string(word_of_form(*object)) + " " + std::to_string(ref.index + 1);
}

Edit set_object_ground(const Level& level, int layer, bool is_ground) {
  return set_mark(level, layer, &ObjectLayer::is_ground, is_ground,
                  is_ground ? "Make objects ground" : "Make objects no ground");
}

Edit set_object_visible(const Level& level, int layer, bool visible) {
  return set_mark(level, layer, &ObjectLayer::visible, visible, visible ? "Show objects" : "Hide objects");
}

Edit set_object_locked(const Level& level, int layer, bool locked) {
  return set_mark(level, layer, &ObjectLayer::locked, locked, locked ? "Lock objects" : "Unlock objects");
}

Edit rename_objects(const Level& level, int layer, const std::string& name) {
  std::string label = "Rename layer";
  if (!has_object_layer(level, layer)) return {std::move(label), {}};
  std::vector<ObjectLayer> layers = level.objects;
  layers[static_cast<std::size_t>(layer)].name = name;
  return single_change(std::move(label), ObjectsChange{level.objects, std::move(layers)});
}

std::string object_layer_text(const Level& level, int layer) {
  const ObjectLayer& objects = level.objects[static_cast<std::size_t>(layer)];
  const std::size_t count = objects.objects.size();
  const std::string kind = objects.image ? "Picture " : "Objects ";
  const std::string name = objects.name.empty() ? kind + std::to_string(layer + 1) : objects.name;
  if (objects.image) return name + ", a picture";
  return name + ", " + std::to_string(count) + (count == 1 ? " object" : " objects");
}

}  // namespace talus
