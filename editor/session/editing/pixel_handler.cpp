// Moves, turns and pastes the selected pixels.
#include "pixel_handler.h"

#include <variant>

#include "edit/sprite_turn.h"

namespace talus {

template <>
void PixelHandler::carry_out(const action::MovePixels& a) {
  PixelSelection& pixels = choices_.pixels();
  const SpriteArea& area = choices_.choices().area;
  if (!pixels.rect()) return;
  // A new entry each time that they are lifted.
  if (!pixels.floats(open_.level, area)) stroke_ = level_.begin_stroke();
  level_.edit_by_user(pixels.move(open_.level, area, a.by, hole()), stroke_);
}

template <>
void PixelHandler::carry_out(const action::TurnPixels& a) {
  PixelSelection& pixels = choices_.pixels();
  const SpriteArea& area = choices_.choices().area;
  if (pixels.rect()) {
    level_.edit_by_user(pixels.turn(open_.level, area, a.turn, hole()));
    stroke_ = level_.begin_stroke();
  } else if (a.turn != PixelTurn::rotate || area.tiles.w == area.tiles.h) {
    level_.edit_by_user(turn_pixels(open_.level, area, a.turn));
  }
}

template <>
void PixelHandler::carry_out(const action::PastePixels& a) {
  choices_.choose_sprite_tool(SpriteTool::select);
  stroke_ = level_.begin_stroke();
  level_.edit_by_user(choices_.pixels().paste(open_.level, choices_.choices().area, a.block, a.at), stroke_);
}

void PixelHandler::apply(const PixelAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

std::uint8_t PixelHandler::hole() const {
  return static_cast<std::uint8_t>(choices_.choices().secondary_color);
}

}  // namespace talus
