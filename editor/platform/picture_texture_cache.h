// PictureTextureCache: pictures as OpenGL textures. Each is made when it is first visible, and forgotten when
// no level has its picture any more.
#pragma once

#include <map>
#include <memory>

#include "panels/ui/picture_textures.h"
#include "panels/ui/ui.h"

namespace talus {

// Needs a current OpenGL context as long as it lives.
class PictureTextureCache : public PictureTextures {
 public:
  PictureTextureCache() = default;
  ~PictureTextureCache() override;
  PictureTextureCache(const PictureTextureCache&) = delete;
  PictureTextureCache& operator=(const PictureTextureCache&) = delete;

  // Call it at the start of a frame.
  void update(Ui& ui);
  ImTextureID texture_of(const std::shared_ptr<const SheetPicture>& picture) override;

 private:
  std::map<std::shared_ptr<const SheetPicture>, unsigned> textures_;
};

}  // namespace talus
