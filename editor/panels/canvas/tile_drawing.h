// The layers of a map on a canvas, from the back to the front.
#pragma once

#include <optional>
#include <vector>

#include "camera.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

inline constexpr double kMsPerFrame = 1000.0 / 60;  // ms, that a frame of the simulation lasts

// How the tiles of a map are drawn.
struct TileLooks {
  bool hide_balls = false;  // leaves out ball tiles, as in play
  bool parallax = false;    // layers move with the view by their parallax and end with the map, as in play
  std::optional<double> time =
      {};  // ms since the start of animations, as in play; none: tiles show themselves
};

// The visible layers of the map, and what lies beyond its edge. In the layer at the back, colour 0 is the
// ground of the picture unless the level has a background of its own; in those in front of it, tile 0 is
// empty and colour 0 is clear. Of objects only their pictures are drawn.
void draw_tiles(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui, TileLooks looks);
// The same at low zoom, in blocks of one colour and without what lies beyond the edge; draws nothing without
// MapTextures. parallax: as in TileLooks. other: shows this level instead of the edited one.
void draw_far_tiles(ImDrawList& list, const Level& level, const CanvasView& view, const Ui& ui,
                    const MapLook& look, bool parallax = false, const OtherLevel* other = nullptr);
// Whether a canvas shows the map at such a low zoom: a cell has few pixels of the screen, or less than one.
bool is_far(const CanvasView& view);

// The cells of a map that a canvas shows.
struct CellSpan {
  int x0, y0, x1, y1;  // half open
  bool empty() const { return x0 >= x1 || y0 >= y1; }
};
CellSpan visible_cells(const TileMap& map, const CanvasView& view);

// Of a layer; never null.
using LayerCells = const MapCells*;
// The layers that are ground, from the back to the front. Valid as long as the level is not changed.
std::vector<LayerCells> ground_layers(const Level& level);

}  // namespace talus
