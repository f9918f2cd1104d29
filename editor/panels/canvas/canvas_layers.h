// The layers of a canvas, from the bottom up. The editor's canvases and `talus shot` draw the same ones.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "camera.h"
#include "overlay/overlay.h"
#include "overlay_labels.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// The level's curves; muted if the solver ignores them.
void draw_curves(ImDrawList& list, const Level& level, const CanvasView& view, float scale);
// Tints the cells with a tile that matches in the chosen layer or one that is ground.
void draw_flag_tint(ImDrawList& list, const Level& level, const CanvasView& view, FlagPattern pattern);
ImU32 flag_color(int flag, int alpha);  // the tint of a flag everywhere; flags 8 apart have the same
void draw_grid(ImDrawList& list, const TileMap& map, const CanvasView& view);
void draw_screen_borders(ImDrawList& list, const TileMap& map, const CanvasView& view, float scale);
// Where the bodies placed by hand start.
void draw_spawns(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui);
// The bodies at the shown frame, with the images of a level; the chosen one is framed. `alpha`: 0 to 255.
// looks_left: see draw_state().
void draw_bodies(ImDrawList& list, const Session& session, const Level& level, const CanvasView& view,
                 const Ui& ui, int alpha, const std::unordered_map<int, bool>& looks_left = {});
// The bodies of the other side of a comparison, if they are elsewhere.
void draw_ghosts(ImDrawList& list, const Session& session, const CanvasView& view, float scale);
// The bodies of any state; the one with this id is framed, 0: no body. looks_left: whether the pictures of
// some bodies, by id, look to the left; others look where they go.
void draw_state(ImDrawList& list, const State& state, int chosen_body, const Level& level,
                const CanvasView& view, const Ui& ui, int alpha,
                const std::unordered_map<int, bool>& looks_left = {});
// How the overlays are drawn, besides which.
struct OverlayOptions {
  int pointed_at = 0;  // id of the body under the mouse; 0: no body
  // Whether every body has labels. Else the chosen one and that under the mouse; all, if they are only two.
  bool labels_all = true;
  int stage = -1;                           // of the chosen body's step, to draw with them; -1: no stage
  std::span<const ScreenBox> covered = {};  // px of the screen that no label may cover
};
// The overlays of the last step.
void draw_overlays(ImDrawList& list, const Session& session, OverlaySet overlays, const CanvasView& view,
                   float scale, const OverlayOptions& options = {});
// The sources of the overlays of any branch; see draw_overlays(). Only those that can be seen at this zoom:
OverlaySet drawable_overlays(OverlaySet overlays, const CanvasView& view);
// px of the level that labels avoid: the bodies, the ramps that they are on, and covered parts.
std::vector<Rect> label_obstacles(const Scene& scene, const State& state, const CanvasView& view,
                                  std::span<const ScreenBox> covered);
// The source with what depends only on the level.
OverlaySource with_level(OverlaySource source, const Session& session);
inline constexpr std::int64_t kTrailFrames = 120;  // of a trail: two seconds
inline constexpr std::size_t kMaxTrails = 4;       // as many as the session keeps
// The cells filled with the stamp, repeated from their top-left corner. `alpha`: 0 to 255.
void draw_stamp(ImDrawList& list, const Stamp& stamp, CellRect cells, const CanvasView& view, const Ui& ui,
                int alpha);
// The tiles that an edit paints on the map. `alpha`: 0 to 255.
void draw_painted_cells(ImDrawList& list, const Edit& edit, const CanvasView& view, const Ui& ui, int alpha);
// Marks cells whose tiles differ from those of the edited level.
void draw_marked_cells(ImDrawList& list, std::span<const Cell> cells, const CanvasView& view);
// A frame around cells, dark below so that it shows on any art.
void draw_cell_frame(ImDrawList& list, CellRect cells, const CanvasView& view, ImU32 color, float width);

}  // namespace talus
