// What the things in a project of LDtk can stand for, and what those of a level do (see LdtkMapping).
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "../import/import_drops.h"
#include "ldtk_tiles.h"

namespace talus {

struct LdtkWord {
  std::string_view word;   // in files
  std::string_view label;  // on screen
};
std::span<const LdtkWord> ldtk_shape_words();
std::span<const LdtkWord> ldtk_flag_words();
std::span<const LdtkWord> ldtk_body_words();
// Whether all words of a choice are there.
bool is_good(const LdtkMapping::Choice& choice);

// What a value or a tag stands for.
struct LdtkMeaning {
  TileShape shape = {};            // kind none: no ground
  bool has_shape = true;           // of a tag: whether it says anything of the shape
  std::string flag = {};           // name of its flag; empty: none by a name
  int FlagRoles::*role = nullptr;  // of its flag; null: none by a role
  bool is_unclear = false;         // whether its name speaks of a slope without saying how it goes
};
LdtkMeaning ldtk_meaning_of_value(const LdtkProject& project, const LdtkMapping& mapping, LdtkCellValue value,
                                  TileSize tile);
LdtkMeaning ldtk_meaning_of_tag(const LdtkMapping& mapping, const std::string& tileset,
                                const std::string& tag, TileSize tile);
std::optional<BodyKind> ldtk_meaning_of_entity(const LdtkMapping& mapping, const std::string& type);

// A tile of the level.
struct LdtkTileMeaning {
  TileShape shape;
  std::vector<std::string> flags;       // names, each once, in order
  std::vector<int FlagRoles::*> roles;  // of its other flags
};
std::vector<LdtkTileMeaning> ldtk_tile_meanings(const LdtkProject& project, const LdtkMapping& mapping,
                                                const LdtkTiles& tiles, ImportDrops& drops);

// Those of the project that the level has, and those of the project that it has not. At most kMaxLdtkThings.
inline constexpr std::size_t kMaxLdtkThings = 2000;
std::vector<LdtkThing> ldtk_things_of(const LdtkProject& project, const LdtkLevel& level);

}  // namespace talus
