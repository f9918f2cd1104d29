#include "small_picture_textures.h"

#include <SDL_opengl.h>

namespace talus {

SmallPictureTextures::~SmallPictureTextures() {
  for (const auto& [picture, texture] : textures_) glDeleteTextures(1, &texture.name);
}

void SmallPictureTextures::update(Ui& ui) {
  ui.small_pictures = this;
  ++frame_;
  std::erase_if(textures_, [&](const auto& entry) {
    const bool is_old = frame_ - entry.second.used > kFramesKept;
    if (is_old) glDeleteTextures(1, &entry.second.name);
    return is_old;
  });
}

ImTextureID SmallPictureTextures::texture(const std::shared_ptr<const SheetPicture>& picture) {
  Texture& texture = textures_[picture];
  texture.used = frame_;
  if (texture.name == 0) {
    glGenTextures(1, &texture.name);
    glBindTexture(GL_TEXTURE_2D, texture.name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture->width, picture->height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture->rgba.data());
  }
  return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.name));
}

}  // namespace talus
