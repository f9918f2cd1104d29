// Edits the level, also by its selected pixels, with undo and redo.
#include "level_handler.h"

#include <algorithm>
#include <string>
#include <utility>
#include <variant>

#include "edit/layer_tools.h"
#include "edit/picture_painting.h"
#include "formats/files/atomic_file.h"
#include "formats/files/real_path.h"
#include "formats/pictures/png_patch.h"

namespace talus {

template <>
void LevelHandler::carry_out(const action::EditLevel& a) {
  edit_by_user(a.edit, a.stroke);
}

template <>
void LevelHandler::carry_out(const action::ChooseLayer& a) {
  const int before = open_.level.layers.chosen;
  if (a.layer < 0 || a.layer >= open_.level.layers.count() || a.layer == before) return;
  open_.level.choose_layer(a.layer);
  ++open_.revision;
  note_layer(before);
}

template <>
void LevelHandler::carry_out(const action::Undo&) {
  if (!open_.history.can_undo() || reader_.is_busy()) return;
  run_.begin_series();
  const int layer = open_.level.layers.chosen;
  open_.history.undo(open_.level);
  const Edit& edit = open_.history.edits()[open_.history.position()];
  if (edit.selection) choices_.choose_cells(edit.selection->before);
  note_edit(edit);
  note_layer(layer);
  note_step_of_history();
}

template <>
void LevelHandler::carry_out(const action::Redo&) {
  if (!open_.history.can_redo() || reader_.is_busy()) return;
  run_.begin_series();
  const int layer = open_.level.layers.chosen;
  open_.history.redo(open_.level);
  const Edit& edit = open_.history.edits()[open_.history.position() - 1];
  if (edit.selection) choices_.choose_cells(edit.selection->after);
  note_edit(edit);
  note_layer(layer);
  note_step_of_history();
}

template <>
void LevelHandler::carry_out(const action::MovePixels& a) {
  PixelSelection& pixels = choices_.pixels();
  const SpriteArea& area = choices_.choices().area;
  if (!pixels.rect()) return;
  // A new entry each time that they are lifted.
  if (!pixels.floats(open_.level, area)) pixel_stroke_ = begin_stroke();
  edit_by_user(pixels.move(open_.level, area, a.by, hole()), pixel_stroke_);
}

template <>
void LevelHandler::carry_out(const action::TurnPixels& a) {
  PixelSelection& pixels = choices_.pixels();
  const SpriteArea& area = choices_.choices().area;
  if (pixels.rect()) {
    edit_by_user(pixels.turn(open_.level, area, a.turn, hole()));
    pixel_stroke_ = begin_stroke();
  } else if (a.turn != PixelTurn::rotate || area.width() == area.height()) {
    edit_by_user(turn_pixels(open_.level, area, a.turn));
  }
}

template <>
void LevelHandler::carry_out(const action::PastePixels& a) {
  choices_.choose_sprite_tool(SpriteTool::select);
  pixel_stroke_ = begin_stroke();
  const SpriteArea& area = choices_.choices().area;
  edit_by_user(
      choices_.pixels().paste(open_.level, area, in_colors_of(open_.level, area.sheet, a.block), a.at),
      pixel_stroke_);
}

PixelColor LevelHandler::hole() const { return choices_.choices().paint(open_.level, true); }

void LevelHandler::apply(const LevelAction& action) {
  std::visit([this](const auto& a) { carry_out(a); }, action);
}

void LevelHandler::edit_by_user(const Edit& wanted, int stroke) {
  if (reader_.is_busy()) return;
  for (const Change& change : wanted.changes) {
    if (const auto* presets = std::get_if<ExportsChange>(&change))
      open_.permissions.note_edit(presets->before, presets->after);
  }
  if (const auto problem = problem_of_painting(open_.level, wanted)) return messages_.tell_error(*problem);
  if (asks_about_file(wanted, stroke)) return;
  if (!paints_tiles(wanted)) return edit(wanted, stroke);
  edit_pictures(*picture_tiles_of(open_.level), wanted, stroke);
}

bool LevelHandler::asks_about_file(const Edit& wanted, int stroke) {
  if (open_.format == nullptr || !open_.format->writes_back) return false;
  const std::vector<BeyondTiled> all = beyond_tiled_after(open_.level, wanted);
  const auto beyond = std::find_if(
      all.begin(), all.end(), [this](const BeyondTiled& each) { return !exceeded_.contains(each.limit); });
  if (beyond == all.end()) return false;
  if (messages_.question()) return true;  // the stroke goes on while it is asked
  const std::string text = wanted.label + ": the level then " + beyond->error.message +
                           ", and cannot be saved into " + last_name(open_.path) +
                           ".\nA level of Talus, .talus.json, holds it. Make the edit?";
  messages_.ask(Question{text, Question::Kind::beyond_file},
                [this, limit = beyond->limit, wanted, stroke](action::Answer answer) {
                  const bool saves = answer == action::Answer::save;
                  if (!saves && answer != action::Answer::allow) return;
                  exceeded_.insert(limit);
                  edit_by_user(wanted, stroke);
                  open_.wants_save_as = open_.wants_save_as || saves;
                });
  return true;
}

void LevelHandler::edit_pictures(const PictureTiles& pictures, const Edit& wanted, int stroke) {
  const auto files = files_painted(pictures, wanted);
  if (!files) return messages_.tell_error(files.error());
  for (const std::string& file : *files) {
    if (!painted_files_.contains(file)) return ask_to_paint(file, wanted, stroke);
  }
  edit(files->empty() ? wanted : fitted_to_pictures(open_.level, pictures, wanted), stroke);
}

void LevelHandler::ask_to_paint(const std::string& file, const Edit& wanted, int stroke) {
  if (messages_.question()) return;  // the stroke goes on while it is asked
  const std::string name = last_name(file);
  const PngKind kind = kind_of_png(read_start_of_file(file, kPngKindBytes).value_or(""));
  if (kind == PngKind::other)
    return messages_.tell_error("The tile cannot be painted: its picture " + name +
                                " is no PNG, and Talus writes no other pictures.");
  if (kind == PngKind::deep)
    return messages_.tell_error("The tile cannot be painted: its picture " + name +
                                " has 16 bits a channel, and Talus writes pictures with 8.");
  const std::string text =
      kind == PngKind::palette
          ? name +
                " is a file of its own, with a palette. Paint it, and save it with the level, in true colour?"
          : name + " is a file of its own. Paint it, and save it with the level?";
  messages_.ask(Question{text, Question::Kind::paint_file},
                [this, file, wanted, stroke](action::Answer answer) {
                  if (answer != action::Answer::allow) return;
                  painted_files_.insert(file);
                  edit_by_user(wanted, stroke);
                });
}

void LevelHandler::edit(const Edit& wanted, int stroke) {
  if (stroke == 0 || stroke > open_.last_stroke) run_.begin_series();
  open_.last_stroke = std::max(open_.last_stroke, stroke);
  Edit edit = wanted;
  rebase_edit(open_.level, edit);
  if (const auto problem = problem_after(open_.level, edit))
    return messages_.tell_error(edit.label + ": not done, because the level then " + *problem + ".");
  if (edit.selection) choices_.choose_cells(edit.selection->after);
  if (edit.empty() && wants_hidden_pixels(wanted))
    messages_.tell_error(wanted.label +
                         ": not done, because the tiles are in true colour: the pixel tools paint them.");
  if (edit.empty()) return;
  note_edit(edit);
  open_.history.push(open_.level, std::move(edit), stroke);
  choices_.fit_level();
}

// Whether an edit paints pixels that a picture in true colour hides.
bool LevelHandler::wants_hidden_pixels(const Edit& edit) const {
  return std::any_of(edit.changes.begin(), edit.changes.end(), [&](const Change& change) {
    const auto* pixel = std::get_if<PixelChange>(&change);
    return pixel != nullptr && open_.level.sheet(pixel->sheet).picture != nullptr;
  });
}

void LevelHandler::note_edit(const Edit& edit) {
  open_.sheet_changes.note(edit, ++open_.revision);
  run_.note_edit(edit);
  checks_.note_edit(edit);
}

// The map has the cells of another layer if another one is chosen.
void LevelHandler::note_layer(int before) {
  if (open_.level.layers.chosen != before) checks_.note_other_layer();
}

void LevelHandler::note_step_of_history() {
  choices_.fit_level();
  choices_.pixels().check(open_.level, choices_.choices().area);
}

void LevelHandler::replace(Level opened) {
  open_.level = std::move(opened);
  painted_files_.clear();
  exceeded_.clear();
  open_.history.clear();
  open_.sheet_changes.note_all(++open_.revision);
  choices_.forget_level();
  run_.load_level();
  checks_.forget_level();
}

}  // namespace talus
