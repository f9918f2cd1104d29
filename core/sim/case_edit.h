// The edits of a hard case during its run.
#pragma once

#include <span>

#include <talus/sim/state.h>
#include "../level/hard_case.h"

namespace talus {

// Makes the edits of the state's frame, in their order. One that removes a body which is not there removes
// none.
void make_edits(std::span<const CaseEdit> edits, State& state);

}  // namespace talus
