// What a hard case holds down while it runs.
#pragma once

#include <span>

#include <talus/sim/state.h>
#include "../level/recording.h"

namespace talus {

// The input of the step that leads to `frame` (from 1): the last entry that is not later; none before the
// first. Entries by frame.
Input case_input(std::span<const CaseInput> entries, std::int64_t frame);

Input input_of(const RecordedInput& entry);

// Both at once: what either holds is held, and the mouse is where `live` has it unless the case alone
// holds its button.
Input added(const Input& of_case, const Input& live);

}  // namespace talus
