// A level: what the editor edits, the formats read and write, and the simulation compiles.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "flag_roles.h"
#include "tile_map.h"
#include "tileset.h"
#include "tuning.h"

namespace talus {

// A body placed by hand, besides those that ball tiles of the map make.
struct Spawn {
  std::string name;   // for people; may be empty or repeated
  Vec2 position;      // px, top-left corner of the 8x8 box
  Vec2 velocity;      // px/frame
  std::string extra;  // JSON object of keys that this version does not know, or empty
  friend bool operator==(const Spawn&, const Spawn&) = default;
};

// The cart that a level came from, kept so that saving gives back every byte that was not edited.
// formats/ alone looks inside.
struct CartOrigin {
  enum class Kind { tic, text };
  Kind kind = Kind::tic;
  std::string comment;  // text only: the comment prefix, such as "--"
  std::string bytes;    // the whole file, as read
  friend bool operator==(const CartOrigin&, const CartOrigin&) = default;
};

struct Level {
  std::array<Sheet, 2> sheets;  // by SheetId
  Palette palette = default_palette();
  std::array<std::string, kFlagCount> flag_names;  // what the user calls each flag; empty: unnamed
  FlagRoles roles;
  TileMap map;
  Tuning tuning;
  std::vector<Spawn> spawns;
  std::shared_ptr<const CartOrigin> cart;  // null for a level that never was a cart
  std::string extra;                       // JSON object of keys that this version does not know, or empty

  Sheet& sheet(SheetId id) { return sheets[static_cast<std::size_t>(id)]; }
  const Sheet& sheet(SheetId id) const { return sheets[static_cast<std::size_t>(id)]; }
  std::uint8_t tile_flags(std::uint8_t tile) const { return sheet(SheetId::tiles).flags[tile]; }
  TileRole role_at(Cell cell) const { return role_of(tile_flags(map.at(cell)), roles); }
};

// The same content; carts are compared by their bytes.
bool operator==(const Level& a, const Level& b);

}  // namespace talus
