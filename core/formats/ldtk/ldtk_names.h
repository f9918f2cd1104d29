// What the names of IntGrid values, enum tags and entities say.
#pragma once

#include <optional>
#include <string_view>

#include <talus/level/body_kind.h>

namespace talus {

// The ground that a name stands for.
struct LdtkGround {
  TileShape shape;       // kind none: no ground
  bool is_plain = true;  // whether the name says no more than the shape, so that no flag needs to keep it
  // Whether the name is that of a slope without saying which way it goes up: the shape is a whole tile.
  bool is_unclear = false;
};

// Returns nothing for a name that says nothing about ground. Names are split into words at other characters
// than letters and digits, and where a capital follows a small letter. They say:
//   one way, platform, jump through   a whole tile that is one-way
//   slope 0 to 8 over 2 tiles         a slope with these heights, px, as Talus writes its name ("2p5"
//   is 2.5);
//                                     with "one way" and "ceiling" before it
//   slope up, slope down              a slope over one tile, seen from the left
//   wall, solid, block, ...           a whole tile
//   ladder, water, background, ...    no ground
std::optional<LdtkGround> ldtk_ground_of_name(std::string_view name, TileSize tile);

// The kind of body that an entity of this type is: a ball if it is called Ball, as
// BodyTraits::ldtk_identifier has it for each kind; a player also if it is called PlayerStart, Hero, ....
// Nothing for others.
std::optional<BodyKind> ldtk_body_of_name(std::string_view type);

}  // namespace talus
