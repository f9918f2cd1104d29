// The objects of an LDtk project with every key that LDtk's schema requires: assets/templates/ldtk.json, and
// what stands on the map.
#pragma once

#include <string>

#include <talus/collision/geometry.h>
#include "exporter.h"
#include "plain_text.h"

namespace talus {

class LdtkSkeleton {
 public:
  explicit LdtkSkeleton(OrderedJson parts) : parts_(std::move(parts)) {}
  // A part, by its key in the asset, with these members instead of its own; its other members keep their
  // places.
  OrderedJson filled(const char* part, const OrderedJson& changes) const;
  // type: see ldtk_field().
  OrderedJson field_definition(const std::string& name, const std::string& type, int uid) const;

 private:
  OrderedJson parts_;
};

// An error when the asset cannot be read, or lacks a part that an export fills.
FormatResult<LdtkSkeleton> read_ldtk_skeleton(const ReadAsset& read_asset);

// Unique in the project by its number, and the same whenever a level is exported.
std::string ldtk_iid(int number);

// A field of an entity. type: Int, Float, Bool, String or Tile, whose value is a part of a tileset; each may
// be null. uid: of its definition.
OrderedJson ldtk_field(const std::string& name, const std::string& type, const OrderedJson& value, int uid);

struct LdtkEntityHead {
  std::string identifier, color;  // of its definition
  int uid = 0;                    // of its definition
  int iid = 0;                    // see ldtk_iid()
  Rect box;                       // px of the map, which LDtk rounds; sides below 1 px become 1 px
};
// An entity without fields and without a tile. cell: px, the side of a cell.
OrderedJson ldtk_entity(const LdtkEntityHead& head, int cell);

}  // namespace talus
