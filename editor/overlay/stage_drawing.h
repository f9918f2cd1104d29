// Draws one stage of a body's step.
#pragma once

#include "debug/stages.h"
#include "overlay.h"

namespace talus {

// Adds one stage. record: of the stage's step. The parts have the colours of the overlays that show similar
// things.
void add_stage(const Stage& stage, int body, const StepRecord& record, OverlayDrawing& drawing);

// Tints the cells and boxes that the stages tested, each once.
void add_visited(std::span<const Stage> stages, OverlayDrawing& drawing);

}  // namespace talus
