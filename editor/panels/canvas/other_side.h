// The other side of a comparison in a view of its own: its bodies and their overlays, as on the first side.
#pragma once

#include <span>
#include <string>

#include "overlay_labels.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// The names of the two sides: "article" and "exact", or "branch 1" and "branch 2".
std::string shown_side_name(const Session& session);
std::string other_side_name(const Session& session);
// Id of the chosen body on the other side; 0 if no body is chosen, or it is not there.
int chosen_on_other_side(const Session& session);
// The bodies of the other side, with the images of a level; the chosen one is framed.
void draw_other_bodies(ImDrawList& list, const Session& session, const Level& level, const CanvasView& view,
                       const Ui& ui);
// The overlays of its last step. covered: px of the screen that no label may cover.
void draw_other_overlays(ImDrawList& list, const Session& session, const CanvasView& view, float scale,
                         std::span<const ScreenBox> covered);

}  // namespace talus
