// Makes and keeps the textures of the map.
#include "map_texture_cache.h"

#include <SDL_opengl.h>

#include <algorithm>

namespace talus {
namespace {

unsigned make_texture() {
  unsigned name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);  // for blocks smaller than a pixel
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return name;
}

}  // namespace

MapTextureCache::~MapTextureCache() {
  for (const auto& [key, texture] : textures_) glDeleteTextures(1, &texture.name);
}

void MapTextureCache::update(const Level& level, std::uint64_t revision, Ui& ui) {
  ui.map_textures = this;
  ++frame_;
  level_ = &level;
  revision_ = revision;
}

std::vector<MapTextures::Piece> MapTextureCache::pieces(const CellRect& cells, int block,
                                                        const LayerLook& look, const OtherLevel* other) {
  std::vector<Piece> found;
  const OtherLevel shown = other != nullptr ? *other : OtherLevel{level_, revision_, 0};
  const TileMap& map = shown.level->map;
  const auto part = shared(cells, {0, 0, map.width(), map.height()});
  if (!part) return found;
  const std::int64_t side = std::int64_t{kSide} * block;  // cells
  const auto index = [&](int cell) { return static_cast<int>(cell / side); };
  for (int row = index(part->y); row <= index(part->y + part->h - 1); ++row) {
    for (int column = index(part->x); column <= index(part->x + part->w - 1); ++column) {
      const Key key{shown.place, look.layer, block, look.look.hide_balls, column, row};
      Texture& texture = textures_[key];
      if (is_stale(texture, block, look, shown.number)) draw(texture, key, look, shown);
      texture.used = frame_;
      const Cell from{static_cast<int>(column * side), static_cast<int>(row * side)};
      const int w = static_cast<int>(std::min<std::int64_t>(side, map.width() - from.x));
      const int h = static_cast<int>(std::min<std::int64_t>(side, map.height() - from.y));
      const auto share = [&](int length) {
        return static_cast<float>(static_cast<double>(length) / static_cast<double>(side));
      };
      found.push_back({reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.name)),
                       {from.x, from.y, w, h},
                       {share(w), share(h)}});
    }
  }
  forget_oldest();
  return found;
}

bool MapTextureCache::is_stale(const Texture& texture, int block, const LayerLook& look,
                               std::uint64_t revision) const {
  if (texture.name == 0 || texture.look != look) return true;
  return texture.revision != revision && (block == 1 || frame_ - texture.drawn >= kFramesBetween);
}

void MapTextureCache::draw(Texture& texture, const Key& key, const LayerLook& look,
                           const OtherLevel& shown) const {
  const auto [place, layer, block, hides_balls, column, row] = key;
  const Cell from{column * kSide * block, row * kSide * block};
  auto rgba = layer_picture(*shown.level, layer, layer_paint(*shown.level, look), from, block, kSide, kSide);
  texture.revision = shown.number;
  texture.look = look;
  texture.drawn = frame_;
  if (texture.name != 0 && rgba == texture.rgba) return;
  if (texture.name == 0) texture.name = make_texture();
  glBindTexture(GL_TEXTURE_2D, texture.name);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kSide, kSide, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  texture.rgba = std::move(rgba);
}

// Textures of this frame stay, since they are still to be drawn.
void MapTextureCache::forget_oldest() {
  while (textures_.size() > kMax) {
    const auto oldest =
        std::min_element(textures_.begin(), textures_.end(),
                         [](const auto& a, const auto& b) { return a.second.used < b.second.used; });
    if (oldest->second.used == frame_) return;
    glDeleteTextures(1, &oldest->second.name);
    textures_.erase(oldest);
  }
}

}  // namespace talus
