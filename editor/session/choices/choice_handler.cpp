// Carries out actions that choose curves, objects, tiles, pixels and bodies.
#include "choice_handler.h"

#include <algorithm>
#include <span>

#include "formats/tilesets/displaced_tile.h"
#include "level/tile_color.h"

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
void ChoiceHandler::carry_out(const action::SelectObject& a) {
  choices_.object = a.object;
}

template <>
void ChoiceHandler::carry_out(const action::SetObjectKind& a) {
  choices_.object_kind = a.kind;
}

template <>
void ChoiceHandler::carry_out(const action::SelectTiles& a) {
  const SpriteArea area = cut_to_sheet(open_.level, a.area);
  if (!(area == choices_.area)) choices_.pixels.drop();
  choices_.area = area;
  if (area.sheet == SheetId::tiles)
    choices_.stamp =
        stamp_of_tiles(open_.level.sheet(SheetId::tiles).layout(), area.tiles, displaced_tile(open_.level));
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
  fit_stamp(choices_.stamp);
}

template <>
void ChoiceHandler::carry_out(const action::SetRandomStamp& a) {
  choices_.random_stamp = a.on;
  choices_.random_seed = a.seed;
}

template <>
void ChoiceHandler::carry_out(const action::SelectCells& a) {
  choices_.selection = a.cells;
  fit_level();
}

template <>
void ChoiceHandler::carry_out(const action::SetPasted& a) {
  choices_.pasted = a.tiles;
  if (choices_.pasted) fit_stamp(*choices_.pasted);
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
void ChoiceHandler::carry_out(const action::SetRgba& a) {
  (a.secondary ? choices_.secondary_rgba : choices_.rgba) = a.color;
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

void ChoiceHandler::fit_level() {
  const TileMap& map = open_.level.map;
  if (choices_.selection) choices_.selection = shared(*choices_.selection, {0, 0, map.width(), map.height()});
  const SpriteArea area = cut_to_sheet(open_.level, choices_.area);
  if (!(area == choices_.area)) choices_.pixels.drop();
  choices_.area = area;
  fit_stamp(choices_.stamp);
  if (choices_.pasted) fit_stamp(*choices_.pasted);
}

// Tiles that the level lacks become tile 0.
void ChoiceHandler::fit_stamp(Stamp& stamp) const {
  const auto is_unknown = [&](MapCell cell) { return cell.tile >= open_.level.tile_count(); };
  std::replace_if(stamp.tiles.begin(), stamp.tiles.end(), is_unknown, MapCell());
}

void ChoiceHandler::choose_first_tile() {
  constexpr int kMaxPixels = 1 << 22;  // that are looked at: a sheet may be large and clear
  const TileSize size = open_.level.map.tile_size();
  int first = displaced_tile(open_.level);
  const int end = std::min(open_.level.tile_count(), first + kMaxPixels / (size.width * size.height));
  while (first < end && is_blank(open_.level, static_cast<TileNumber>(first))) ++first;
  if (first == end) first = 0;
  const Cell place = open_.level.sheet(SheetId::tiles).layout().place_of(first);
  carry_out(action::SelectTiles{{SheetId::tiles, {place.x, place.y, 1, 1}}});
}

void ChoiceHandler::forget_level() {
  show_overlay(overlay::answer, false);
  choices_.body = 0;
  choices_.object = {};
  choices_.selection.reset();
  choices_.pixels.drop();
  fit_level();
  const auto is_unseen = [&](MapCell cell) { return is_blank(open_.level, cell.tile); };
  constexpr std::size_t kMaxTilesSeen = 64;  // that are looked at
  const std::span stamp = choices_.stamp.tiles;
  if (std::ranges::all_of(stamp.first(std::min(kMaxTilesSeen, stamp.size())), is_unseen)) choose_first_tile();
}

}  // namespace talus
