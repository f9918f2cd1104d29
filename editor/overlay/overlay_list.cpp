// The overlays, in the order of their switches and of the legend. Their colours are those of Okabe and Ito,
// which stay apart for colour-blind eyes, less their black and dark blue, plus white, lighter ones of their
// hues, and red for what is wrong.
#include "overlay_table.h"

namespace talus {

std::span<const Overlay* const> all_overlays() {
  static constexpr const Overlay* kAll[] = {
      &overlay::boxes,       &overlay::normals,       &overlay::touch_points, &overlay::velocity,
      &overlay::slope_delta, &overlay::floor_height,  &overlay::tested_tiles, &overlay::answer,
      &overlay::outline,     &overlay::removed_edges, &overlay::one_way,      &overlay::swept_path,
      &overlay::trails,      &overlay::penetration,   &overlay::shapes,       &overlay::reach,
  };
  return kAll;
}

}  // namespace talus
