// MapTextureCache: the map at low zoom as OpenGL textures. Each texture is made when it is first visible, and
// again when the level has changed.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>

#include <talus/level/level.h>
#include "overlay/map_picture.h"
#include "panels/ui/map_textures.h"
#include "panels/ui/ui.h"

namespace talus {

// Needs a current OpenGL context as long as it lives.
class MapTextureCache : public MapTextures {
 public:
  MapTextureCache() = default;
  ~MapTextureCache() override;
  MapTextureCache(const MapTextureCache&) = delete;
  MapTextureCache& operator=(const MapTextureCache&) = delete;

  // Call it at the start of a frame. level: valid until the next call. revision: of the level, as in Session.
  void update(const Level& level, std::uint64_t revision, Ui& ui);
  std::vector<Piece> pieces(const CellRect& cells, int block, const LayerLook& look,
                            const OtherLevel* other) override;

 private:
  static constexpr int kSide = 256;         // texels of a texture
  static constexpr std::size_t kMax = 128;  // textures kept, each 256 KB in memory and on the graphics card
  // A texture of many cells, which takes some ms, is drawn again at most once in so many frames.
  static constexpr std::uint64_t kFramesBetween = 20;

  struct Texture {
    unsigned name = 0;
    std::vector<std::uint8_t> rgba;     // content of the texture
    LayerLook look;                     // the look that it has
    std::uint64_t revision = 0;         // of the level that it shows
    std::uint64_t drawn = 0, used = 0;  // frames
  };
  // Key of a texture: place of the other level (0: the edited one), layer, block, whether balls are hidden,
  // column and row among those of the same kind.
  using Key = std::tuple<int, int, int, bool, int, int>;

  bool is_stale(const Texture& texture, int block, const LayerLook& look, std::uint64_t revision) const;
  void draw(Texture& texture, const Key& key, const LayerLook& look, const OtherLevel& shown) const;
  void forget_oldest();

  const Level* level_ = nullptr;
  std::uint64_t revision_ = 0;
  std::uint64_t frame_ = 0;
  std::map<Key, Texture> textures_;
};

}  // namespace talus
