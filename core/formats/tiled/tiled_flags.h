// Flags of tiles as properties of Tiled, and back: the int `flags`, and a bool for each flag.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "../import/import_drops.h"
#include "tiled_map.h"

namespace talus {

// By flag, the name of the bool that its tiles have: the flag's own name; without one that of its role
// ("up_slope"); else "flag5". A name that another flag or property has is replaced by "flag5", too, and so is
// one that would be another's in XML (xml_text).
std::array<std::string, kMaxFlags> tiled_flag_names(const Level& level);
// Flags as the int `flags`, which Tiled keeps in 32 bits with a sign: below 0 if flag 31 is set.
std::int64_t tiled_number_of(FlagSet flags);
// Flags from such an int, also from one without a sign; nothing if it has more than 32 bits.
std::optional<FlagSet> flags_of_tiled_number(std::int64_t number);

// Which flags the bools of a map's tiles stand for.
class TiledFlagReader {
 public:
  // level: gives the names of its flags; gets those that the tiles give.
  explicit TiledFlagReader(Level& level);

  // A true bool with a name that no flag has gives its name to the flag that the same tiles have by number,
  // or else to a flag of which nothing is known. takes_roles: then to one with a role that no tile has, which
  // loses the role. tiles: of the level; null for those of no tileset.
  void name_flags(const std::vector<const TiledTile*>& tiles, bool takes_roles);
  // Whether a property of a tile is a flag, all flags, or about the shape.
  bool knows(const TiledProperty& property) const;
  // Whether it is the name of a flag.
  bool is_flag(const std::string& name) const { return flags_.contains(name); }
  // The flags of a tile. drops: gets `flags` that are no such int.
  FlagSet flags_of(const TiledTile& tile, ImportDrops& drops) const;

 private:
  using Numbers = std::set<std::size_t>;  // of tiles of the level

  bool is_free(int flag) const;
  bool has_role(int flag) const;
  std::optional<int> flag_for(const Numbers& tiles, bool takes_roles) const;

  Level& level_;
  std::map<std::string, int> flags_;          // by the name of their bools
  std::array<Numbers, kMaxFlags> by_number_;  // by flag, the tiles that have it in the int `flags`
  std::set<int> by_name_;                     // flags that a tile has by a name
};

}  // namespace talus
