// The pictures of large tiles, objects and layers in one picture, for games in Lua that draw a level.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <utility>

#include <talus/level/level.h>

namespace talus {

struct LuaPictures {
  SheetPicture picture;                         // all of them
  std::map<const SheetPicture*, Cell> corners;  // px, where the top left of each is in it
};

// The large tiles that cells of a level turn, and how.
std::set<std::pair<TileNumber, TileTurn>> turned_large_tiles(const Level& level);

inline constexpr std::size_t kMaxLuaPictures =
    4096;  // tiles, each turn of them, objects and layers that show a part of it

// Nothing if a level has no such pictures, or too many or too large ones.
std::optional<LuaPictures> lua_pictures(const Level& level);
// Whether it has any.
bool has_pictures(const Level& level);

}  // namespace talus
