// Companions: a companion is a file beside a level's file, with all of the level that the file's format
// cannot hold. The companion of `game.tic` is `game.tic.talus.json`:
//
//   "talus"      version, as in a native level (see native.h).
//   "companion"  "file": name of the file that it was saved with; "with": for each member that such a file
//                holds itself (see Format::holds), by its name, a hash of the member at that time.
//
//                Of a map of Tiled also "frame": how its tiles and cells were numbered, since reading the map
//                alone may number them otherwise. "tiles": for each run of tiles of the level the number of
//                the first in cells of the map and how many there are, 0 for tiles of no tileset; "columns"
//                of the sheet; "used", whether only the tiles that the map shows were taken; "map": [x, y,
//                width, height] in cells; "ground", where its ground was, as moved_members.h says.
//
// The other members are those of a native level that differ from the level that the file alone gives; of an
// object only the members that differ. null removes a member that the file gives; for a role it means no
// flag, as in a level.
//
// So the two share nothing, and version control can compare each. If a member of the file no longer has the
// hash in "with", another program has changed it. Then the companion is used all the same, but a changed
// member that has a value in the file keeps it; lists of objects are joined; flags that no cart has are added
// to those of a cart's tiles; and a map is never smaller than the cells that the file fills. If the ground of
// the map lies elsewhere now, all that has a place moves with it.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

inline constexpr std::string_view kCompanionEnding = ".talus.json";

// Returns the path of a file's companion: beside the real file, if the path is a link.
std::string companion_path(const std::string& file);
// Returns the file that a companion belongs to, "a/game.tic" for "a/game.tic.talus.json"; empty if the name
// is not a companion's. Where only `a/game.ldtk` exists, "a/game.talus.json" is that of this one (see
// ldtk/ldtk_companion.h).
std::string owner_of_companion(const std::string& path);
// One sentence without its full stop on why nothing else may be written there; empty if the name is not that
// of a companion of an existing file.
std::string companion_place_problem(const std::string& path);
// How the companion of a map of Tiled says that the map was numbered; nothing if it does not, or wrongly.
std::optional<TiledFrame> frame_of_companion(std::string_view bytes);
// Whether the text is a companion, maybe a faulty one: JSON with the member "companion".
bool is_companion(std::string_view bytes);
// The same by the beginning of the text alone, where Talus writes that member.
bool begins_as_companion(std::string_view start);

// Returns the companion of a level whose file holds `held`, read as `format`. Empty if the file holds the
// whole level, unless `even_empty` asks for a companion without members. file: its name without folders.
FormatResult<std::string> write_companion(const Level& level, const Level& held, const Format& format,
                                          const std::string& file, bool even_empty = false);

struct JoinedLevel {
  Level level;
  std::string note = {};  // for the user, a sentence without its full stop; empty: file and companion fit
  bool is_whole = true;   // whether all of the companion was used
};
// Joins a companion, read from its bytes, with what its file holds. The cart stays that of `held`.
FormatResult<JoinedLevel> join_companion(std::string_view bytes, const Level& held, const Format& format,
                                         const std::string& file);

}  // namespace talus
