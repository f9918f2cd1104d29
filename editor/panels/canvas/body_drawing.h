// How bodies look: as their pictures, as their tiles, or as figures.
#pragma once

#include <talus/sim/body_act.h>
#include "camera.h"
#include "panels/ui/ui.h"
#include "tile_drawing.h"

namespace talus {

// The picture that a level gives the body; null if it gives none.
const BodyPicture* picture_of_body(const Level& level, const Body& body);
// Draws a body whose kind has a look of its own: a box with a face, and its foot, the whole bottom side or
// the middle of it; a wooden box; or a wheel. Returns false for one that looks like its tile. from, to: px of
// the screen. `alpha`: 0 to 255.
bool draw_own_look(ImDrawList& list, const Body& body, ImVec2 from, ImVec2 to, int alpha);

// Where a picture is drawn: its frame stands on the bottom of the box.
Rect place_of_picture(const BodyPicture& picture, const Rect& box, TileSize tile);

// Draws the bodies of a level whose tiles are on the sheet of the window.
class BodyDrawing {
 public:
  // step: of the state, for the frames of pictures and of animated tiles. `level` must outlive it.
  BodyDrawing(const Level& level, std::int64_t step);
  // looks_left: whether its picture is mirrored. `alpha`: 0 to 255.
  void draw(ImDrawList& list, const Body& body, bool looks_left, const CanvasView& view, const Ui& ui,
            int alpha) const;

  // The tile whose image, or animation, a body has that has no picture: its own, of the layer in front, or
  // the first ball tile; -1 if there is none.
  int tile_of(const Body& body) const;

  // The tiles of the sheet that show a body now; nothing if it has no picture, or its frame lies beside the
  // sheet.
  std::optional<CellRect> frame_of(const Body& body) const;

 private:
  const Level& level_;
  std::int64_t step_;
  std::vector<LayerCells> layers_;
  int first_ball_;  // -1: there is none
};

}  // namespace talus
