// Session: the selected pixels of the sprite canvas.
#include <algorithm>
#include <utility>

#include "edit/sprite_turn.h"
#include "session/session_impl.h"

namespace talus {

void Session::Impl::carry_out(const action::SetSpriteTool& a) {
  if (a.tool != SpriteTool::select) choices.pixels.drop();
  choices.sprite_tool = a.tool;
}

void Session::Impl::carry_out(const action::SetBrush& a) { choices.brush = std::clamp(a.size, 1, kMaxBrush); }

void Session::Impl::carry_out(const action::SelectPixels& a) {
  if (a.rect)
    choices.pixels.select(choices.area, *a.rect);
  else
    choices.pixels.drop();
}

void Session::Impl::carry_out(const action::MovePixels& a) {
  if (!choices.pixels.rect()) return;
  // A new entry each time that they are lifted.
  if (!choices.pixels.floats(level, choices.area)) pixel_stroke = ++last_stroke;
  const auto hole = static_cast<std::uint8_t>(choices.secondary_color);
  carry_out(action::EditLevel{choices.pixels.move(level, choices.area, a.by, hole), pixel_stroke});
}

void Session::Impl::carry_out(const action::TurnPixels& a) {
  const auto hole = static_cast<std::uint8_t>(choices.secondary_color);
  if (choices.pixels.rect()) {
    carry_out(action::EditLevel{choices.pixels.turn(level, choices.area, a.turn, hole)});
    pixel_stroke = ++last_stroke;
  } else if (a.turn != PixelTurn::rotate || choices.area.tiles.w == choices.area.tiles.h) {
    carry_out(action::EditLevel{turn_pixels(level, choices.area, a.turn)});
  }
}

void Session::Impl::carry_out(const action::PastePixels& a) {
  choices.sprite_tool = SpriteTool::select;
  pixel_stroke = ++last_stroke;
  carry_out(action::EditLevel{choices.pixels.paste(level, choices.area, a.block, a.at), pixel_stroke});
}

}  // namespace talus
