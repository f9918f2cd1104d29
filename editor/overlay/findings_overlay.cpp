// Overlay of a proof: a heat map of the cells in which something was found.
#include <algorithm>
#include <cmath>
#include <vector>

#include "overlay_pen.h"
#include "prove/proof.h"

namespace talus {
namespace {

constexpr double kLeastHeat = 1.5, kMaxHeat = 3;  // of the tint

// More trials with a finding make a cell hotter, by their logarithm.
double heat_of(int count) { return std::min(kLeastHeat + 0.25 * std::log2(count), kMaxHeat); }

void draw_findings(const OverlaySource& source, OverlayPen& pen) {
  if (source.proof == nullptr) return;
  const TileMap& map = source.level->map;
  const auto [width, height] = map.tile_size();
  const std::vector<Finding>& findings = source.proof->findings;  // those of one cell follow one another
  for (auto first = findings.begin(); first != findings.end();) {
    const Cell cell = first->cell;
    int count = 0;
    for (; first != findings.end() && first->cell == cell; ++first) count += first->count;
    pen.box({map.x_of(cell.x), map.y_of(cell.y), 1.0 * width, 1.0 * height}, true, heat_of(count));
  }
}

}  // namespace

namespace overlay {

const Overlay findings{
    .key = "findings",
    .label = "findings",
    .help =
        "Cells in which the proof found that a body does what the ground does not explain: the more "
        "trials, the hotter.",
    .group = OverlayGroup::ground,
    .color = 0xff5a3c,
    .safe_color = 0xb02020,
    .digit = '8',
    .shift = true,
    .needs_proof = true,
    .layer = 2,
    .draw = draw_findings,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.box({0, 0, 8, 8}, true, kMaxHeat);
        },
};

}  // namespace overlay
}  // namespace talus
