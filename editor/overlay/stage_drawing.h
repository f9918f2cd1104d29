// Draws one stage of a body's step.
#pragma once

#include "debug/stages.h"
#include "overlay.h"

namespace talus {

// record: of the step that the stage is of. Its parts have the colours of the overlays that show the like.
void add_stage(const Stage& stage, int body, const StepRecord& record, OverlayDrawing& drawing);

}  // namespace talus
