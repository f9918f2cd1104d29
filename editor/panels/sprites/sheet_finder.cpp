// Searches when the text or the level changes, and counts when the counts are shown.
#include "sheet_finder.h"

#include <algorithm>

#include "level/tile_words.h"
#include "panels/tiles/flag_label.h"
#include "panels/ui/shown_text.h"
#include "tile_note_text.h"

namespace talus {

void SheetFinder::draw(const Session& session, Actions& actions, Ui& ui) {
  const bool marks = ui.view.sprites.marks_used;
  ui.begin_row();
  find(session);
  const auto count = std::count(found_.begin(), found_.end(), true);
  const std::string note = found_.empty() ? "" : std::to_string(count) + " found";
  const float gap = ImGui::GetStyle().ItemSpacing.x, button = ui.px(48);
  const float note_width = note.empty() ? 0 : size_of_text(note).x + gap;
  ImGui::SetNextItemWidth(std::max(ui.px(60), ImGui::GetContentRegionAvail().x - button - gap - note_width));
  const bool entered = input_text("find", "find: 12, flag:solid, slope", text_,
                                  ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui.item(
      "sheet/find",
      "Dims all tiles but those with these words: a number, the name of a tileset, of a flag or of a value "
      "of a field, a class, or a shape: none, solid, slope, profile, polygon, one-way, ceiling. Words with "
      "blanks "
      "stand in quotes; flag:\"win zone\" finds only flags, set:desert only tilesets, class:door only "
      "classes.",
      "Enter, Shift+Enter");
  if (entered) {
    ImGui::SetKeyboardFocusHere(-1);
    go_to_found(session, actions, ui, !ImGui::GetIO().KeyShift);
  }
  if (!note.empty()) {
    ImGui::SameLine();
    draw_text(note, theme::tone(count == 0 ? theme::kError : theme::kMuted));
  }
  ui.end_row();
  ImGui::SameLine();
  if (ui.text_button("sheet/used", "used", marks, "Marks the tiles that the map uses, and dims the others.",
                     {}, true, button))
    ui.view.sprites.marks_used = !marks;
}

void SheetFinder::find(const Session& session) {
  if (searched_ == text_ && found_revision_ == session.revision()) return;
  if (found_revision_ && searched_ == text_ && ImGui::IsMouseDown(0) &&
      static_cast<int>(found_.size()) == session.level().tile_count())
    return;  // not for each cell of a stroke
  found_ = find_tiles(session.level(), text_);
  searched_ = text_;
  found_revision_ = session.revision();
}

void SheetFinder::go_to_found(const Session& session, Actions& actions, Ui& ui, bool forwards) {
  find(session);
  const int count = static_cast<int>(found_.size());
  const int from = session.choices().area.tile_at(session.level(), 0, 0);
  for (int step = 1; step <= count; ++step) {
    const int tile = (from + (forwards ? step : count - step)) % count;
    if (!found_[static_cast<std::size_t>(tile)]) continue;
    actions.push_back(action::SelectTiles{{SheetId::tiles, ui.place_on_sheet(tile)}});
    ui.view.sprites.shown_tile = tile;
    const int set = tileset_with(session.level().tilesets, ui.layout(SheetId::tiles), tile);
    if (set != ui.view.sprites.tileset) ui.view.sprites.tileset = -1;
    return;
  }
}

std::size_t SheetFinder::uses_of(const Session& session, int tile) {
  const bool is_stroke =
      ImGui::IsMouseDown(0) && static_cast<int>(uses_.size()) == session.level().tile_count();
  if (counted_revision_ != session.revision() && !is_stroke) {
    uses_ = count_tiles(session.level());
    counted_revision_ = session.revision();
  }
  return uses_[static_cast<std::size_t>(tile)];
}

std::string SheetFinder::text_of(const Session& session, int tile) {
  const Level& level = session.level();
  std::string text = "Tile " + std::to_string(tile);
  const int set = tileset_with(level.tilesets, level.sheet(SheetId::tiles).layout(), tile);
  if (set >= 0 && !level.tilesets[static_cast<std::size_t>(set)].name.empty())
    text += " of " + shown_text(level.tilesets[static_cast<std::size_t>(set)].name);
  const auto number = static_cast<TileNumber>(tile);
  std::string shape, flags;
  const TileShape its = shape_of_tile(level, number);
  if (its.kind == TileShape::Kind::none)
    shape = ", no shape";
  else
    for (const std::string& word : words_of_shape(its)) shape += (shape.empty() ? ": " : ", ") + word;
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    if (!has_flag(level.tile_flags(number), flag)) continue;
    const std::string name = flag_name(level, flag);
    flags += (flags.empty() ? " Flags: " : ", ") + std::to_string(flag) + (name.empty() ? "" : " " + name);
  }
  if (!flags.empty()) flags += ".";
  const std::size_t uses = uses_of(session, tile);
  constexpr std::size_t kMaxNote = 300;  // bytes
  std::string note = shown_line(text_of_note(note_of(level.tile_notes, number)), kMaxNote);
  if (!note.empty()) note = " " + note + ".";
  return text + shape + "." + flags + note + " " +
         (uses == 0 ? "The map does not use it."
                    : "Used " + std::to_string(uses) + (uses == 1 ? " time." : " times."));
}

}  // namespace talus
