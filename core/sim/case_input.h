// The input of a hard case during its run.
#pragma once

#include <span>

#include <talus/sim/state.h>
#include "../level/recording.h"

namespace talus {

// The input of the step that leads to `frame` (from 1): the last entry that is not later, or empty input
// before the first one. Entries must be sorted by frame.
Input case_input(std::span<const CaseInput> entries, std::int64_t frame);

Input input_of(const RecordedInput& entry);

// Joins two inputs: what either holds is held. The mouse is where `live` has it, unless only the hard case
// holds its button.
Input added(const Input& of_case, const Input& live);

}  // namespace talus
