// Draws one stage of a body's step.
#pragma once

#include "debug/stages.h"
#include "overlay.h"

namespace talus {

// Adds one stage. record: of the stage's step. tile, visible: as in add_visited(). The parts have the colours
// of the overlays that show similar things.
void add_stage(const Stage& stage, int body, const StepRecord& record, TileSize tile, Rect visible,
               OverlayDrawing& drawing);

// Tints the cells and boxes that the stages tested, each once. tile: px, of a cell. visible: level px; boxes
// that lie wholly outside are left out, and so are those beyond the first 10,000.
void add_visited(std::span<const Stage> stages, TileSize tile, Rect visible, OverlayDrawing& drawing);

}  // namespace talus
