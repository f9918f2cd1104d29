// Draws one stage of a body's step.
#pragma once

#include "debug/stages.h"
#include "overlay.h"

namespace talus {

// record: of the step that the stage is of. Its parts have the colours of the overlays that show the like.
void add_stage(const Stage& stage, int body, const StepRecord& record, OverlayDrawing& drawing);

// Tints the cells that the stages looked at and the boxes that they tested, each once.
void add_visited(std::span<const Stage> stages, OverlayDrawing& drawing);

}  // namespace talus
