// PictureTextures: pictures of large tiles, objects and layers as textures, which the platform makes
// (platform/picture_texture_cache.h).
#pragma once

#include <imgui.h>

#include <memory>

#include <talus/level/tileset.h>

namespace talus {

class PictureTextures {
 public:
  virtual ~PictureTextures() = default;
  // The texture of a picture, which repeats itself beyond its sides. picture: not null.
  virtual ImTextureID texture_of(const std::shared_ptr<const SheetPicture>& picture) = 0;
};

}  // namespace talus
