// The stroke of the flag brush.
#include "flag_brush.h"

#include "edit/flag_tools.h"
#include "edit/raster.h"
#include "flag_label.h"
#include "panels/canvas/drag_cancel.h"
#include "panels/sprites/tile_number.h"

namespace talus {

void FlagBrush::update(const Session& session, Actions& actions, SheetId sheet, Cell at, TileAt tile_at,
                       bool pressed, bool down) {
  const auto pattern = session.choices().flag_overlay;
  if (!down || !pattern) return last_.reset();
  const Level& level = session.level();
  if (pressed) {
    const auto tile = tile_at(at);
    if (!tile) return;
    last_ = at;
    sets_ = stroke_sets(*pattern, level.sheet(sheet).flags[static_cast<std::size_t>(*tile)]);
    stroke_ = session.next_stroke();
  }
  if (!last_ || (!pressed && at == *last_)) return;
  std::set<int> tiles;
  for_each_on_line(*last_, at, [&](Cell cell) {
    if (const auto tile = tile_at(cell)) tiles.insert(*tile);
  });
  last_ = at;
  Edit edit = paint_flags(level, sheet, tiles, *pattern, sets_);
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit), stroke_});
}

void FlagBrush::cancel(const Session& session, Actions& actions) {
  take_back(session, actions, stroke_);
  last_.reset();
}

std::string FlagBrush::text(const Session& session, SheetId sheet, std::optional<int> tile) const {
  const auto pattern = session.choices().flag_overlay;
  if (!pattern) return "no flag is chosen to paint";
  const std::string label = pattern_label(session.level(), *pattern);
  const auto verb = [](bool sets) { return sets ? "sets " : "clears "; };
  if (!tile) return (active() ? verb(sets_) : "paints ") + label;
  const FlagSet flags = session.level().sheet(sheet).flags[static_cast<std::size_t>(*tile)];
  return "tile " + std::to_string(number_on_screen(sheet, *tile)) + ": " +
         verb(active() ? sets_ : stroke_sets(*pattern, flags)) + label;
}

}  // namespace talus
