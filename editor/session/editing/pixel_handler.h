// PixelHandler: the selected pixels of the sprite canvas.
#pragma once

#include "level_handler.h"
#include "pixel_actions.h"

namespace talus {

class PixelHandler {
 public:
  PixelHandler(const OpenLevel& open, LevelHandler& level, ChoiceHandler& choices)
      : open_(open), level_(level), choices_(choices) {}

  void apply(const PixelAction& action);

 private:
  // For each action of PixelAction, in pixel_handler.cpp.
  template <class A>
  void carry_out(const A& action) = delete;

  std::uint8_t hole() const;  // the colour that stays behind where pixels are lifted

  const OpenLevel& open_;
  LevelHandler& level_;
  ChoiceHandler& choices_;
  int stroke_ = 0;  // for the moves of the selected pixels, while they float
};

}  // namespace talus
