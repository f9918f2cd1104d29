// The table of overlays.
#include "overlay_id.h"

#include <algorithm>

namespace talus {

const std::array<OverlayInfo, kOverlayCount>& overlay_infos() {
  // Colours of Okabe and Ito, which stay apart for colour-blind eyes, less their black and dark blue, plus
  // white, lighter ones of their hues, and red for what is wrong.
  static constexpr std::array<OverlayInfo, kOverlayCount> kInfos = {{
      {OverlayId::boxes, "boxes", "boxes",
       "Outlines of the bodies, and of the solids and slopes that article and bump test: exact has the "
       "outline "
       "instead.",
       0x56b4e9, 0x50aac8},
      {OverlayId::normals, "normals", "contact normals",
       "Arrows out of the touched sides, and out of the slopes that a body was put on.", 0xe69f00, 0x8c8c00},
      {OverlayId::touch_points, "touch_points", "touch points",
       "Crosses where bodies met something, with the fraction of the move done by then.", 0xf0e442, 0xc8c828},
      {OverlayId::velocity, "velocity", "velocity",
       "Arrows from the bodies' centres, 4 px long for each px/frame.", 0x009e73, 0x6ec88c},
      {OverlayId::slope_delta, "slope_delta", "slope delta",
       "How far along a slope a body's centre is, from 0 at the left end to 1 at the right.", 0xcc79a7,
       0x8c6ec8},
      {OverlayId::floor_height, "floor_height", "floor height",
       "The floor straight below each body, as the exact solver's ground has it; of the others, the floor "
       "computed "
       "on a slope, before and after rounding, and the slope's surface.",
       0xd55e00, 0xaa8c50},
      {OverlayId::tested_tiles, "tested_tiles", "cells visited",
       "Tinted boxes that the last step tested: for article and bump the tiles in the bodies' ways, for "
       "exact the cells that the chosen body's casts looked at, and the bodies near its way.",
       0xf4f4f4, 0xe4ffc8},
      {OverlayId::answer, "answer", "right answer",
       "For a hard case: where bodies start, where they should be, and the floor that they should stay on.",
       0xa7f070, 0x8cc850},
      {OverlayId::outline, "outline", "outline",
       "The outline of the ground as the exact solver sees it, with short normals where it stops bodies.",
       0xb39dff, 0xaaaaff},
      {OverlayId::removed_edges, "removed_edges", "removed edges",
       "Sides of tiles and slopes that the merged outline has left out, since others cover them.", 0x9aa5b1,
       0x6e8c6e},
      {OverlayId::one_way, "one_way", "one-way sides",
       "Arrows through one-way floors, ceilings and lines, in the direction in which bodies may pass.",
       0x66d9c0, 0x288c8c},
      {OverlayId::swept_path, "swept_path", "swept path",
       "The way of each body in the last step, with its box at every contact.", 0x8fd3ff, 0x6ee4ff},
      {OverlayId::trails, "trails", "trails",
       "Where the chosen body's centre was in the last frames; without a chosen body, those of the first "
       "four.",
       0xffb7e0, 0xffe48c},
      {OverlayId::penetration, "penetration", "penetration",
       "In red, how deep a body is inside of the ground, and the shortest way out.", 0xff6b6b, 0xc850ff},
      {OverlayId::shapes, "shapes", "shapes",
       "The shapes of the tiles that make the ground, on the map, in the play view and on the sheet.",
       0xff5cf0, 0xffff6e},
      {OverlayId::reach, "reach", "reach",
       "Cells that a player was found to get to from its start, and the floors that it stood on there.",
       0x8bd450, 0xc8ff00},
  }};
  return kInfos;
}

std::uint32_t overlay_color(OverlayId id, OverlayPalette palette) {
  const OverlayInfo& info = overlay_infos()[static_cast<std::size_t>(id)];
  return palette == OverlayPalette::standard ? info.color : info.safe_color;
}

std::optional<OverlayId> find_overlay(std::string_view key) {
  const auto& infos = overlay_infos();
  const auto found =
      std::find_if(infos.begin(), infos.end(), [&](const OverlayInfo& i) { return i.key == key; });
  if (found == infos.end()) return std::nullopt;
  return found->id;
}

}  // namespace talus
