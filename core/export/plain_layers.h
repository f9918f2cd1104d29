// What of a level lies beside its ground, as JSON values for all exports of plain data: layers, objects,
// flags' names and roles, tilesets, animations and the pictures of bodies. docs/export-data.md describes
// their members.
#pragma once

#include <vector>

#include <talus/level/level.h>
#include <talus/level/placed_picture.h>
#include "plain_text.h"

namespace talus {

// Where an object is.
struct ObjectPlace {
  const ObjectLayer* layer = nullptr;  // not null
  const MapObject* object = nullptr;   // not null
};
// All objects, layer by layer from the back to the front.
std::vector<ObjectPlace> objects_in_order(const Level& level);
OrderedJson plain_object_json(const Level& level, ObjectPlace place);

// Whether there is more than the one layer of tiles that the map itself is.
bool has_plain_layers(const Level& level);
// Kind, name and looks of a layer, without its cells and objects. What is usual is left out.
OrderedJson plain_layer_json(const Level& level, LayerInOrder layer);

// By number; flags without a name are left out.
OrderedJson plain_flag_names(const Level& level);
// The flags of the roles in use, by their keys.
OrderedJson plain_roles(const FlagRoles& roles);
// Each act has frames, its own or those that stand for it. The picture must not be empty.
OrderedJson plain_body_picture(const BodyPicture& picture);
OrderedJson plain_tilesets(const Level& level);
// By tile, the tiles that it shows and for how many ms, in turn.
OrderedJson plain_animations(const Level& level);
// By tile, what its user wrote.
OrderedJson plain_notes(const Level& level);
// The members of a JSON object; none if it is empty or damaged.
OrderedJson plain_properties(const std::string& properties);

}  // namespace talus
