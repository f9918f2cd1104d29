// Tints what the last step tested or visited.
#include <cstdint>
#include <unordered_set>

#include "overlay_pen.h"
#include "stage_drawing.h"

namespace talus {
namespace {

// Packs a body or a tile's cell into one number, as thousands are looked up in a frame.
std::uint64_t key_of(const Obstacle& obstacle) {
  const auto number = [](int n) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(n)); };
  constexpr std::uint64_t kBody = std::uint64_t{1} << 63;  // no cell has this bit, as rows use the upper half
  if (obstacle.body != 0) return kBody | number(obstacle.body);
  return number(obstacle.cell.y) << 32 | number(obstacle.cell.x);
}

void draw_tested(const OverlaySource& source, OverlayPen& pen) {
  if (source.record.tested
          .empty()) {  // the exact solver records none; the stages of a step have what it tested
    if (source.stages) add_visited(source.stages(), source.scene.tile_size, pen.visible(), pen.drawing());
    return;
  }
  std::unordered_set<std::uint64_t> drawn;  // several bodies may have tested the same box
  for (const TestedBox& tested : source.record.tested) {
    if (pen.sees(tested.other.box) && drawn.insert(key_of(tested.other)).second)
      pen.box(tested.other.box, true);
  }
}

}  // namespace

namespace overlay {

const Overlay tested_tiles{
    .key = "tested_tiles",
    .label = "cells visited",
    .help =
        "Tinted boxes that the last step tested: for article and bump the tiles near the bodies' paths, for "
        "exact "
        "the cells that the chosen body's casts tested, and the bodies near its path.",
    .group = OverlayGroup::contact,
    .color = 0xf4f4f4,
    .safe_color = 0xe4ffc8,
    .digit = '7',
    .layer = -4,
    .draw = draw_tested,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.box({0.5, 0.5, 7, 7}, true);
        },
};

}  // namespace overlay
}  // namespace talus
