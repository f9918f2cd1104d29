#include "picture_texture_cache.h"

#include <SDL_opengl.h>

#include <algorithm>
#include <cstdint>

namespace talus {
namespace {

// The pixels of a picture that one texture can hold: of a longer side, every second, third ... pixel.
SheetPicture thinned(const SheetPicture& picture, int most_side) {
  const int longest = std::max(picture.width, picture.height), step = (longest + most_side - 1) / most_side;
  SheetPicture small{(picture.width + step - 1) / step, (picture.height + step - 1) / step, {}};
  small.rgba.reserve(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
  for (int y = 0; y < picture.height; y += step)
    for (int x = 0; x < picture.width; x += step)
      small.rgba.insert(small.rgba.end(), picture.at(x, y), picture.at(x, y) + 4);
  return small;
}

void upload(const SheetPicture& picture) {
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               picture.rgba.data());
}

}  // namespace

PictureTextureCache::~PictureTextureCache() {
  for (const auto& [picture, name] : textures_) glDeleteTextures(1, &name);
}

void PictureTextureCache::update(Ui& ui) {
  ui.picture_textures = this;
  std::erase_if(textures_, [](const auto& texture) {
    const bool is_unused = texture.first.use_count() == 1;
    if (is_unused) glDeleteTextures(1, &texture.second);
    return is_unused;
  });
}

ImTextureID PictureTextureCache::texture_of(const std::shared_ptr<const SheetPicture>& picture) {
  unsigned& name = textures_[picture];
  if (name == 0) {
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_REPEAT);
    int most_side = 0;  // that this machine has
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most_side);
    const bool fits = picture->width <= most_side && picture->height <= most_side;
    if (fits)
      upload(*picture);
    else
      upload(thinned(*picture, most_side));
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
}

}  // namespace talus
