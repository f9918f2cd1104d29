#include "picture_texture_cache.h"

#include <SDL_opengl.h>

#include <cstdint>

namespace talus {

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
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->width, picture->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture->rgba.data());
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(name));
}

}  // namespace talus
