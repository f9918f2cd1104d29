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
      &overlay::findings,    &overlay::impulses,      &overlay::conveyors,
  };
  return kAll;
}

std::span<const OverlayPreset> overlay_presets() {
  static constexpr const Overlay* kArticle[] = {&overlay::boxes, &overlay::normals, &overlay::slope_delta,
                                                &overlay::floor_height};
  static constexpr const Overlay* kStuck[] = {&overlay::boxes,    &overlay::normals, &overlay::touch_points,
                                              &overlay::velocity, &overlay::outline, &overlay::one_way};
  static const OverlayPreset kAll[] = {
      {"article", "What the article draws",
       "Shows boxes, contact normals, slope delta and floor height, and no other overlay.", kArticle},
      {"stuck", "Why does it stick?",
       "Shows boxes, contacts with their normals, velocities, the outline of the ground and one-way sides, "
       "and no other overlay.",
       kStuck},
      {"all", "All overlays", "Shows every overlay.", all_overlays()},
      {"none", "No overlay", "Hides every overlay.", {}},
  };
  return kAll;
}

}  // namespace talus
