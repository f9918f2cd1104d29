// MapTextures: the map at low zoom as textures, which the platform makes (platform/map_texture_cache.h).
#pragma once

#include <imgui.h>

#include <cstdint>
#include <vector>

#include "level/cell_rect.h"
#include "overlay/map_picture.h"

namespace talus {

// A level other than the one that is edited.
struct OtherLevel {
  const Level* level = nullptr;
  std::uint64_t number = 0;  // grows when the content changes
  int place = 1;             // where it is shown, 1 or more: each place has textures of its own
};

class MapTextures {
 public:
  // A texture of some cells; the part from {0,0} to `uv` lies on the map.
  struct Piece {
    ImTextureID texture{};
    CellRect cells;
    ImVec2 uv;
  };
  virtual ~MapTextures() = default;
  // The textures of a layer that cover the part of `cells` on the map, one texel for each block of cells.
  // Valid in this frame only. block: a power of 2. other: the level to show instead; null: the edited one.
  virtual std::vector<Piece> pieces(const CellRect& cells, int block, const LayerLook& look,
                                    const OtherLevel* other) = 0;
};

}  // namespace talus
