// The trace of a simulation: one JSON line for each frame.
#pragma once

#include <string>

#include <talus/sim/record.h>
#include <talus/sim/state.h>

namespace talus {

// {"frame":1,"bodies":[{"id":1,"x":..,"y":..,"vx":..,"vy":..}],"contacts":[..]}, without a line break;
// numbers are the shortest decimals that read back as the same double. Without a record it has bodies alone.
// The "other" of a contact is the role of a tile or the kind of a body: "solid", "crate"; "body" if an edit
// has taken it away. Only where there are some, events follow, and the ids of bodies that were capped or cut
// short (see BodyPath): "events":[{"kind":"landed","body":1}],"capped":[1],"cut_short":[1]. with_contacts:
// false leaves out contacts, capped and cut_short.
std::string trace_line(const State& state, const StepRecord* record, bool with_contacts = true);

// 16 lower-case hexadecimal digits.
std::string hash_text(std::uint64_t hash);

}  // namespace talus
