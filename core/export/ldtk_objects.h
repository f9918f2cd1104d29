// Layers of objects as layers of entities of LDtk: one for each layer, and one definition of entities for
// each class of objects.
//
// Entities have what docs/export-data.md says of objects as fields, and their properties as further ones.
// LDtk has neither turned entities nor outlines: an entity is the box of the object, and fields say the rest.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <talus/level/level.h>
#include "ldtk_skeleton.h"
#include "plain_layers.h"

namespace talus {

class LdtkObjects {
 public:
  struct Layer {
    const ObjectLayer* source = nullptr;  // not null
    std::string identifier;               // unique in the project
    int uid = 0, iid = 0;
    bool is_behind = false;  // whether it is behind all layers of tiles
  };

  // level: must stay alive. first_uid: it and all numbers behind it are free.
  LdtkObjects(const Level& level, int first_uid);

  const std::vector<Layer>& layers() const { return layers_; }  // from the top; none of pictures
  int next_uid() const { return next_uid_; }                    // the first one that is free
  // Of entities, to be added to the project's. cell: px, the side of a cell.
  std::vector<OrderedJson> definitions(const LdtkSkeleton& skeleton, int cell) const;
  // An object of the layer, which is one of layers().
  OrderedJson entity(const Layer& layer, std::size_t index, int cell) const;

 private:
  struct Field {
    std::string key;         // of the object, or of its properties
    std::string identifier;  // unique in its class
    std::string type;        // see ldtk_field()
  };
  struct Class {
    std::string identifier;
    int uid = 0;                                    // its fields have the numbers after it
    std::vector<Field> fields;                      // first those that all objects have
    std::map<std::string, std::size_t> properties;  // by key: index of its field
  };

  void add_classes();

  const Level& level_;
  std::vector<Layer> layers_;             // from the top
  std::map<std::string, Class> classes_;  // by the class of objects
  int next_uid_;
};

}  // namespace talus
