// SpriteSurroundings: the tiles around the edited ones on the map, dimmed around the pixel canvas, with the
// lines of their slopes.
#pragma once

#include <cstdint>
#include <optional>

#include "edit/tile_neighbours.h"
#include "panels/canvas/camera.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

inline constexpr int kSurroundings = 4;  // px of the neighbours shown on each side

class SpriteSurroundings {
 public:
  // `view`: the canvas, in px of its tiles.
  void draw(ImDrawList& list, const Session& session, const CanvasView& view, const Ui& ui);

 private:
  const TileNeighbours& neighbours(const Session& session, const Ui& ui);

  // The last count, and what it was for: counting on a huge map takes longer than a frame.
  std::optional<TileNeighbours> counted_;
  CellRect counted_tiles_;
  std::uint64_t counted_revision_ = 0;
  TileNeighbours placed_;
};

}  // namespace talus
