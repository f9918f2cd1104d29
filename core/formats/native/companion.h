// Companions: what a level has and the file of its format cannot hold, in a file beside that. The companion
// of `game.tic` is `game.tic.talus.json`:
//
//   "talus"      version, as in a native level (see native.h).
//   "companion"  "file": the name of the file that it was saved with; "with": a hash of each member that such
//                a file holds itself (see Format::holds), as it was then, by the member's name.
//   and the members of a native level in which the level differs from what the file alone gives; of an object
//   only the members that differ. null takes a member away that the file gives; of a role it means none, as
//   in a level.
//
// So the two share nothing, and each can be compared from version to version. Where the file holds something
// else now than "with" says, another program has changed it: the companion's members are taken all the same,
// but where the file has a value of its own in a member that was changed, that one counts; lists of objects
// are joined; and a map is never smaller than the cells that the file fills.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <talus/formats/format.h>

namespace talus {

inline constexpr std::string_view kCompanionEnding = ".talus.json";

// Where the companion of a file is: beside the file that it is, where its path is a link.
std::string companion_path(const std::string& file);
// The file that a companion of this name belongs to, "a/game.tic" for "a/game.tic.talus.json"; empty: by its
// name it is none.
std::string owner_of_companion(const std::string& path);
// One sentence without its full stop on why nothing else may be written there; empty: by its name it is not
// the place of a companion of a file that is there.
std::string companion_place_problem(const std::string& path);
// Whether the text is a companion, be it a faulty one: JSON with the member "companion".
bool is_companion(std::string_view bytes);

// The companion of a level whose file holds `held`, read as `format`; empty: the file holds the whole level,
// and `even_empty` does not ask for a companion without anything. file: its name, without folders.
FormatResult<std::string> write_companion(const Level& level, const Level& held, const Format& format,
                                          const std::string& file, bool even_empty = false);

struct JoinedLevel {
  Level level;
  std::string note = {};  // what is to be told, a sentence without its full stop; empty: they fit
  bool is_whole = true;   // nothing of the companion was left out
};
// A companion, read from its bytes, together with what its file holds. The cart stays that of `held`.
FormatResult<JoinedLevel> join_companion(std::string_view bytes, const Level& held, const Format& format,
                                         const std::string& file);

}  // namespace talus
