// The sheets of a level as textures, uploaded again when the level changes.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <talus/level/level.h>
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// Needs a current OpenGL context as long as it lives.
class SheetTextures {
 public:
  SheetTextures();
  ~SheetTextures();
  SheetTextures(const SheetTextures&) = delete;
  SheetTextures& operator=(const SheetTextures&) = delete;

  // Shows the session's level. Of a picture in true colour only the tiles that were painted are uploaded
  // again.
  void update(const Session& session, Ui& ui);

  // A sheet that is not the level's, with a palette of its own.
  void show_preview(const Sheet& sheet, const Palette& palette, Ui& ui);

 private:
  void upload_painted(const Level& level, const std::vector<int>& tiles) const;

  std::array<unsigned, 5> names_{};  // tiles, sprites, both with colour 0 clear, and the preview
  std::optional<std::uint64_t> revision_;
};

}  // namespace talus
