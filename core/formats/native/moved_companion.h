// Companions of maps whose ground another program has moved.
#pragma once

#include <optional>
#include <string>

#include "../text/json_text.h"
#include "level/moved_ground.h"

namespace talus {

// Where the ground of a map of Tiled was when its companion was saved; nothing if that is not known. about:
// the member "companion".
std::optional<GroundPlace> ground_of_frame(const Json& about);
// Moves all members of a companion that have a place. place: where its ground was. held: what its file gives
// now. Returns how many curves have no place on the map any more, which are left out.
int move_companion(Json& companion, Cell by, const GroundPlace& place, const Level& held);
// What the file gives now, as if its ground were where it was; nothing if that would be no level.
std::optional<Json> document_before_shift(const Level& held, Cell by, const GroundPlace& place);
// A note of a joined level, with a sentence on the shift behind it. file: the name of the level's file.
// has_grown: whether its map became larger or smaller by that shift.
std::string with_shift_note(const std::string& note, const std::string& file, Cell by, bool has_grown,
                            int lost_curves);

}  // namespace talus
