// Chooses.
#include "choice_handler.h"

#include <algorithm>

namespace talus {

template <>
void ChoiceHandler::carry_out(const action::SelectCurve& a) {
  choices_.curve = a.curve;
}

template <>
void ChoiceHandler::carry_out(const action::SetCurveKind& a) {
  choices_.curve_kind = a.kind;
}

template <>
void ChoiceHandler::carry_out(const action::SelectTiles& a) {
  if (!(a.area == choices_.area)) choices_.pixels.drop();
  choices_.area = a.area;
  if (a.area.sheet == SheetId::tiles) choices_.stamp = stamp_of_sheet(a.area.tiles);
}

template <>
void ChoiceHandler::carry_out(const action::SelectPixels& a) {
  if (a.rect)
    choices_.pixels.select(choices_.area, *a.rect);
  else
    choices_.pixels.drop();
}

template <>
void ChoiceHandler::carry_out(const action::SetStamp& a) {
  choices_.stamp = a.stamp;
}

template <>
void ChoiceHandler::carry_out(const action::SetRandomStamp& a) {
  choices_.random_stamp = a.on;
  choices_.random_seed = a.seed;
}

template <>
void ChoiceHandler::carry_out(const action::SelectCells& a) {
  choices_.selection = a.cells;
  cut_selection();
}

template <>
void ChoiceHandler::carry_out(const action::SetPasted& a) {
  choices_.pasted = a.tiles;
}

template <>
void ChoiceHandler::carry_out(const action::SetMapTool& a) {
  choices_.map_tool = a.tool;
  choices_.pasted.reset();
}

template <>
void ChoiceHandler::carry_out(const action::SetSpriteTool& a) {
  if (a.tool != SpriteTool::select) choices_.pixels.drop();
  choices_.sprite_tool = a.tool;
}

template <>
void ChoiceHandler::carry_out(const action::SetBrush& a) {
  choices_.brush = std::clamp(a.size, 1, kMaxBrush);
}

template <>
void ChoiceHandler::carry_out(const action::SetColor& a) {
  (a.secondary ? choices_.secondary_color : choices_.color) = a.color;
}

template <>
void ChoiceHandler::carry_out(const action::SetOverlay& a) {
  show_overlay(*a.overlay, a.on);
}

template <>
void ChoiceHandler::carry_out(const action::SetFlagOverlay& a) {
  choices_.flag_overlay = a.pattern;
}

template <>
void ChoiceHandler::carry_out(const action::SetOverlayPalette& a) {
  choices_.overlay_palette = a.palette;
}

template <>
void ChoiceHandler::carry_out(const action::SetGrid& a) {
  choices_.grid = a.on;
}

template <>
void ChoiceHandler::carry_out(const action::SetScreenBorders& a) {
  choices_.screen_borders = a.on;
}

void ChoiceHandler::apply(const ChoiceAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

void ChoiceHandler::cut_selection() {
  const TileMap& map = open_.level.map;
  if (choices_.selection) choices_.selection = shared(*choices_.selection, {0, 0, map.width(), map.height()});
}

void ChoiceHandler::forget_level() {
  show_overlay(overlay::answer, false);
  choices_.body = 0;
  choices_.selection.reset();
  choices_.pixels.drop();
}

}  // namespace talus
