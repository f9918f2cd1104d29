// MapTextures: the map from afar as textures, which the platform makes (platform/map_texture_cache.h).
#pragma once

#include <imgui.h>

#include <vector>

#include "level/cell_rect.h"
#include "overlay/map_picture.h"

namespace talus {

class MapTextures {
 public:
  // A texture of some cells, of which the part from {0,0} to `uv` lies on the map.
  struct Piece {
    ImTextureID texture{};
    CellRect cells;
    ImVec2 uv;
  };
  virtual ~MapTextures() = default;
  // Those that cover what is on the map of `cells`, one texel for a block of cells along each side. For this
  // frame alone. block: a power of 2.
  virtual std::vector<Piece> pieces(const CellRect& cells, int block, const MapLook& look) = 0;
};

}  // namespace talus
