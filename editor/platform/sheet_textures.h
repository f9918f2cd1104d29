// The sheets of a level as textures, uploaded again when the level changes.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <optional>

#include <talus/level/level.h>
#include "panels/ui/ui.h"

namespace talus {

// Needs a current OpenGL context as long as it lives.
class SheetTextures {
 public:
  SheetTextures();
  ~SheetTextures();
  SheetTextures(const SheetTextures&) = delete;
  SheetTextures& operator=(const SheetTextures&) = delete;

  // revision: of the level, as in Session.
  void update(const Level& level, std::uint64_t revision, Ui& ui);

  // A sheet that is not the level's, with a palette of its own.
  void show_preview(const Sheet& sheet, const Palette& palette, Ui& ui);

 private:
  std::array<unsigned, 4> names_{};  // tiles, sprites, the tiles with colour 0 clear, and the preview
  std::optional<std::uint64_t> revision_;
};

}  // namespace talus
