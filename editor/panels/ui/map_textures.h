// MapTextures: the map from afar as textures, which the platform makes (platform/map_texture_cache.h).
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
  std::uint64_t number = 0;  // of what it holds: it grows when that changes
  int place = 1;             // where it is shown, 1 or more: each keeps textures of its own
};

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
  // frame alone. block: a power of 2. other: the level that is shown instead; null: none.
  virtual std::vector<Piece> pieces(const CellRect& cells, int block, const MapLook& look,
                                    const OtherLevel* other) = 0;
};

}  // namespace talus
