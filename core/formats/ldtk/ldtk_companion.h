// Companions of projects of LDtk: `cave.talus.json` beside `cave.ldtk` has all that was added to its levels.
//
//   "talus"      version, as in a native level (see native.h)
//   "companion"  "file": name of the project's file; "project": its iid, if it has one; "last": the iid of
//                the level that was saved last
//   "mapping"    what things of the project stand for: a list of "kind", "value", "tag" or "entity"; "of" and
//                "name", as in LdtkMapping; and "shape", "flag" and "body", if they are chosen
//   "levels"     by the iid of the level: its "name"; "tiles", LdtkOrigin::tiles; "ground", where the ground
//                of LDtk's level was, as ../native/moved_members.h says; and "added", what ldtk_additions.h
//                says. If the ground lies elsewhere now, what was added moves with it.
#pragma once

#include "../native/companion.h"
#include "../text/json_text.h"

namespace talus {

// What the reader of a project needs of it.
struct LdtkMemory {
  std::optional<LdtkMapping> mapping = {};  // nothing: none is remembered
  std::string last = {};                    // iid of a level; empty: unknown
};
LdtkMemory ldtk_memory_of(std::string_view companion);
// A mapping as under "mapping" of a companion: the list itself, or an object with it. Nothing for other
// texts.
std::optional<LdtkMapping> ldtk_mapping_in(std::string_view text);
Json json_of_mapping(const LdtkMapping& mapping);  // the list
// Of a level; empty: unknown.
std::vector<std::string> ldtk_tiles_of_companion(std::string_view companion, const std::string& level);

// Whether the text in the place of a companion is one that is damaged, or that this version cannot read: not
// an object in JSON, or one with the member "companion" and a fault. Others are files of their own.
bool is_damaged_ldtk_companion(std::string_view text);

// before: what is in the place of the companion; empty: nothing. A file of another project, or that is no
// companion, is an error. file: name of the project's file, without folders.
FormatResult<std::string> write_ldtk_companion(const Level& level, std::string_view before,
                                               const std::string& file);
// Joins a companion with what the project gives. A level that it does not have stays as it is.
FormatResult<JoinedLevel> join_ldtk_companion(std::string_view bytes, const Level& held,
                                              const std::string& file);
// Lays what was added to a level of LDtk over a newer reading of it.
FormatResult<JoinedLevel> move_ldtk_additions(const Level& level, const Level& fresh,
                                              const std::string& file);

}  // namespace talus
