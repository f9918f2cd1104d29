// SmallPictureTextures: small pictures as OpenGL textures. Each is made when it is first shown, and goes when
// it has not been shown for a while.
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "panels/ui/small_pictures.h"
#include "panels/ui/ui.h"

namespace talus {

// Needs a current OpenGL context as long as it lives.
class SmallPictureTextures : public SmallPictures {
 public:
  SmallPictureTextures() = default;
  ~SmallPictureTextures() override;
  SmallPictureTextures(const SmallPictureTextures&) = delete;
  SmallPictureTextures& operator=(const SmallPictureTextures&) = delete;

  void update(Ui& ui);  // call it at the start of a frame
  ImTextureID texture(const std::shared_ptr<const SheetPicture>& picture) override;

 private:
  static constexpr std::uint64_t kFramesKept = 120;
  struct Texture {
    unsigned name = 0;
    std::uint64_t used = 0;  // frame
  };
  std::uint64_t frame_ = 0;
  std::map<std::shared_ptr<const SheetPicture>, Texture> textures_;
};

}  // namespace talus
