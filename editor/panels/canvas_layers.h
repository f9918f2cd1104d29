// The layers of a canvas, from the bottom up. The editor's canvases and `talus shot` draw the same ones.
#pragma once

#include "camera.h"
#include "session/session.h"
#include "ui.h"

namespace talus {

// The tiles of the map, and what lies beyond its edge. `hide_balls`: leaves out ball tiles, as play does.
void draw_tiles(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui, bool hide_balls);
// The same from afar, in blocks of one colour; nothing without MapTextures.
void draw_far_tiles(ImDrawList& list, const TileMap& map, const CanvasView& view, const Ui& ui,
                    const MapLook& look);
// Whether a canvas shows the map from afar: a cell has a few pixels of the screen, or less than one.
bool is_far(const CanvasView& view);
// The level's curves; muted where the solver takes no notice of them.
void draw_curves(ImDrawList& list, const Level& level, const CanvasView& view, float scale);
// Tints the cells whose tile matches.
void draw_flag_tint(ImDrawList& list, const Level& level, const CanvasView& view, FlagPattern pattern);
ImU32 flag_color(int flag, int alpha);  // the tint of a flag, the same in the legend and the panels
void draw_grid(ImDrawList& list, const TileMap& map, const CanvasView& view);
void draw_screen_borders(ImDrawList& list, const TileMap& map, const CanvasView& view, float scale);
// Where the bodies placed by hand start.
void draw_spawns(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui);
// The bodies where they are now; the chosen one is framed. `alpha`: 0 to 255.
void draw_bodies(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui, int alpha);
// The bodies of the other side of a comparison, where they are elsewhere.
void draw_ghosts(ImDrawList& list, const Session& session, const CanvasView& view, float scale);
// The other side's bodies alone.
void draw_other_bodies(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui);
// The overlays of the last step. `pointed_at`: id of the body under the mouse; 0: none. `stage`: of the
// chosen body's step, drawn with them; -1: none.
void draw_overlays(ImDrawList& list, const Session& session, OverlaySet overlays, const CanvasView& view,
                   float scale, int pointed_at = 0, int stage = -1);
// The cells filled with the stamp, repeated from their top-left corner. `alpha`: 0 to 255.
void draw_stamp(ImDrawList& list, const Stamp& stamp, CellRect cells, const CanvasView& view, const Ui& ui,
                int alpha);
// The tiles that an edit paints on the map. `alpha`: 0 to 255.
void draw_painted_cells(ImDrawList& list, const Edit& edit, const CanvasView& view, const Ui& ui, int alpha);
// A frame around cells, dark below so that it shows on any art.
void draw_cell_frame(ImDrawList& list, CellRect cells, const CanvasView& view, ImU32 color, float width);

}  // namespace talus
