// SmallPictures: pictures of levels in lists, as textures, which the platform makes
// (platform/small_picture_textures.h).
#pragma once

#include <imgui.h>

#include <memory>

#include <talus/level/tileset.h>

namespace talus {

class SmallPictures {
 public:
  virtual ~SmallPictures() = default;
  // Valid in this frame only. picture: not null.
  virtual ImTextureID texture(const std::shared_ptr<const SheetPicture>& picture) = 0;
};

}  // namespace talus
