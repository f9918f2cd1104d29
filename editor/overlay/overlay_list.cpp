// The overlays, in the order of their switches and of the legend. Their colours are those of Okabe and Ito,
// which colour-blind people can tell apart, without black and dark blue; white, lighter shades, and red for
// errors are added.
#include "overlay_table.h"

namespace talus {

std::span<const Overlay* const> all_overlays() {
  static constexpr const Overlay* kAll[] = {
      &overlay::boxes,       &overlay::normals,       &overlay::touch_points, &overlay::velocity,
      &overlay::slope_delta, &overlay::floor_height,  &overlay::tested_tiles, &overlay::answer,
      &overlay::outline,     &overlay::removed_edges, &overlay::one_way,      &overlay::swept_path,
      &overlay::trails,      &overlay::penetration,   &overlay::shapes,       &overlay::reach,
      &overlay::findings,
  };
  return kAll;
}

}  // namespace talus
