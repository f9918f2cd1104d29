// The commands of the sprites: the pixel canvas, the palette and the sheet.
#include <algorithm>

#include "command_table.h"
#include "edit/sprite_clear.h"
#include "edit/sprite_clipboard.h"
#include "edit/sprite_turn.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

template <SpriteTool tool>
void choose_sprite_tool(S, A actions, U) {
  actions.push_back(action::SetSpriteTool{tool});
}

template <SpriteTool tool>
bool is_sprite_tool(S session, const Ui&) {
  return session.choices().sprite_tool == tool;
}

template <SpriteTool tool>
Command sprite_tool(std::string_view id, KeyChord key, std::string_view label, std::string_view help) {
  return toggle(id, key, label, help, choose_sprite_tool<tool>, is_sprite_tool<tool>);
}

template <int step>
void change_brush(S session, A actions, U) {
  actions.push_back(action::SetBrush{session.choices().brush + step});
}

bool has_selected_pixels(S session, const Ui&) { return session.choices().pixels.rect().has_value(); }

void select_all_pixels(S session, A actions, U) {
  const SpriteArea& area = session.choices().area;
  actions.push_back(action::SetSpriteTool{SpriteTool::select});
  actions.push_back(action::SelectPixels{CellRect{0, 0, area.width(), area.height()}});
}

template <PixelTurn turn>
void turn_pixels(S, A actions, U) {
  actions.push_back(action::TurnPixels{turn});
}

bool can_rotate(S session, const Ui& ui) {
  const CellRect& tiles = session.choices().area.tiles;
  return has_selected_pixels(session, ui) || tiles.w == tiles.h;
}

// The selected pixels, else the tiles with their flags.
void clear_sprite(S session, A actions, U) {
  const Choices& choices = session.choices();
  const auto color = static_cast<std::uint8_t>(choices.secondary_color);
  const auto& rect = choices.pixels.rect();
  actions.push_back(action::EditLevel{rect ? clear_pixels(session.level(), choices.area, *rect, color)
                                           : clear_area(session.level(), choices.area, color)});
}

void copy_sprite(S session, A, U) {
  const Choices& choices = session.choices();
  const std::string text = choices.pixels.rect()
                               ? pixels_to_text(choices.pixels.pixels(session.level(), choices.area))
                               : tiles_to_text(session.level(), choices.area);
  ImGui::SetClipboardText(text.c_str());
}

void cut_sprite(S session, A actions, U ui) {
  copy_sprite(session, actions, ui);
  clear_sprite(session, actions, ui);
}

std::string clipboard_text() {
  const char* text = ImGui::GetClipboardText();
  return text == nullptr ? "" : text;
}

void emit_paste(A actions, tl::expected<Edit, std::string> edit) {
  if (edit)
    actions.push_back(action::EditLevel{std::move(*edit)});
  else
    actions.push_back(action::ShowMessage{edit.error(), true});
}

void paste_sprite(S session, A actions, U) {
  const Choices& choices = session.choices();
  const std::string text = clipboard_text();
  if (auto block = pixels_from_text(text)) {
    const CellRect at = choices.pixels.rect().value_or(CellRect{});
    actions.push_back(action::PastePixels{std::move(*block), {at.x, at.y}});
  } else {
    emit_paste(actions, paste_tiles(session.level(), choices.area, text));
  }
}

void copy_palette(S session, A, U) {
  ImGui::SetClipboardText(palette_to_text(session.level().palette).c_str());
}

void paste_colors(S session, A actions, U ui) {
  emit_paste(actions, paste_palette(session.level(), ui.view.palette_color, clipboard_text()));
}

template <int step, bool secondary>
void cycle_color(S session, A actions, U ui) {
  const int now = secondary ? session.choices().secondary_color : session.choices().color;
  ui.view.palette_color = (now + step + kColorCount) % kColorCount;
  actions.push_back(action::SetColor{ui.view.palette_color, secondary});
}

// The selected pixels, else the selection on the sheet.
template <int dx, int dy>
void move_selection(S session, A actions, U ui) {
  if (has_selected_pixels(session, ui)) {
    actions.push_back(action::MovePixels{{dx, dy}});
    return;
  }
  SpriteArea area = session.choices().area;
  area.tiles.x = std::clamp(area.tiles.x + dx, 0, kSheetColumns - area.tiles.w);
  area.tiles.y = std::clamp(area.tiles.y + dy, 0, kSheetColumns - area.tiles.h);
  actions.push_back(action::SelectTiles{area});
}

template <int dx, int dy>
Command arrow(std::string_view id, int key, std::string_view label) {
  return repeating(command(id, KeyChord{key}, label,
                           "Moves the selection on the sheet, or the selected pixels.",
                           move_selection<dx, dy>));
}

void switch_sheet(S session, A actions, U) {
  SpriteArea area = session.choices().area;
  area.sheet = area.sheet == SheetId::tiles ? SheetId::sprites : SheetId::tiles;
  actions.push_back(action::SelectTiles{area});
}

std::vector<Command> pixel_tools() {
  return {
      sprite_tool<SpriteTool::pencil>("pixels/pencil", KeyChord{'1'}, "Pencil",
                                      "Draws pixels; the right button draws the other colour."),
      also_called("eyedropper sample", sprite_tool<SpriteTool::pick>(
                                           "pixels/pick", KeyChord{'2'}, "Pick colour",
                                           "Takes the colour under the mouse; so does the middle button.")),
      sprite_tool<SpriteTool::select>(
          "pixels/select", KeyChord{'3'}, "Select pixels",
          "Drag a rectangle, then drag it elsewhere or move it by the arrows: it floats over what is there. "
          "Flips, rotation, shifts, Delete and the clipboard act on it; Escape drops it."),
      also_called("bucket flood", sprite_tool<SpriteTool::fill>(
                                      "pixels/fill", KeyChord{'4'}, "Fill",
                                      "Fills an area of one colour; with Ctrl, that colour everywhere.")),
      sprite_tool<SpriteTool::line>("pixels/line", KeyChord{'l'}, "Line",
                                    "Drag a line; with Shift, level, upright or diagonal."),
      sprite_tool<SpriteTool::rectangle>("pixels/rectangle", KeyChord{'r'}, "Rectangle",
                                         "Drag a rectangle; with Shift a square, with Ctrl filled."),
      sprite_tool<SpriteTool::ellipse>("pixels/ellipse", KeyChord{'e'}, "Ellipse",
                                       "Drag an ellipse; with Shift a circle, with Ctrl filled."),
      repeating(command("pixels/smaller_brush", KeyChord{'-'}, "Smaller brush", "One px less, down to 1.",
                        change_brush<-1>, [](S s, const Ui&) { return s.choices().brush > 1; })),
      repeating(command("pixels/larger_brush", KeyChord{'='}, "Larger brush", "One px more, up to 4.",
                        change_brush<1>, [](S s, const Ui&) { return s.choices().brush < kMaxBrush; })),
      toggle(
          "pixels/neighbours", KeyChord{'n'}, "Neighbours on the map",
          "Shows the tiles around, as at the place on the map where the mouse was last, else the commonest, "
          "and the lines of slopes.",
          [](S, A, U ui) { ui.view.pixels.neighbours = !ui.view.pixels.neighbours; },
          [](S, const Ui& ui) { return ui.view.pixels.neighbours; }),
      toggle(
          "pixels/enlarge", KeyChord{'z'}, "Enlarge the pixels",
          "Shows the pixel canvas above the map and the play view, instead of below the sheet.",
          [](S, A, U ui) { ui.view.pixels.enlarged = !ui.view.pixels.enlarged; },
          [](S, const Ui& ui) { return ui.view.pixels.enlarged; }),
  };
}

template <PixelTurn how>
Command shift_command(std::string_view id, int key, std::string_view label) {
  return repeating(
      command(id, shift(key), label,
              "Shifts the selected pixels, or all of the canvas, by one px; what leaves comes in "
              "at the other side.",
              turn_pixels<how>));
}

std::vector<Command> pixel_changes() {
  return {
      command("pixels/flip_h", KeyChord{'5'}, "Flip left and right",
              "Mirrors the selected pixels, or all of the canvas, left to right.",
              turn_pixels<PixelTurn::flip_horizontal>),
      command("pixels/flip_v", KeyChord{'6'}, "Flip up and down",
              "Mirrors the selected pixels, or all of the canvas, top to bottom.",
              turn_pixels<PixelTurn::flip_vertical>),
      command("pixels/rotate", KeyChord{'7'}, "Rotate",
              "Turns the selected pixels, or all of a square canvas, by a quarter, clockwise.",
              turn_pixels<PixelTurn::rotate>, can_rotate),
      also_on(KeyChord{kKeyDelete},
              command("pixels/clear", KeyChord{'8'}, "Clear",
                      "Fills the selected pixels with the right button's colour, or all of the canvas, whose "
                      "flags go too.",
                      clear_sprite)),
      shift_command<PixelTurn::shift_left>("pixels/shift_left", kKeyLeft, "Shift pixels left"),
      shift_command<PixelTurn::shift_right>("pixels/shift_right", kKeyRight, "Shift pixels right"),
      shift_command<PixelTurn::shift_up>("pixels/shift_up", kKeyUp, "Shift pixels up"),
      shift_command<PixelTurn::shift_down>("pixels/shift_down", kKeyDown, "Shift pixels down"),
      command("pixels/cut", ctrl('x'), "Cut", "Copies, then clears.", cut_sprite),
      command("pixels/copy", ctrl('c'), "Copy",
              "Copies the selected pixels, or the tiles with their flags, as TIC-80 does.", copy_sprite),
      command("pixels/paste", ctrl('v'), "Paste",
              "Puts in pixels, which float, or as many tiles as are selected, also from TIC-80.",
              paste_sprite),
      command("pixels/select_all", ctrl('a'), "Select all pixels", "Selects all of the canvas.",
              select_all_pixels),
      command(
          "pixels/deselect", KeyChord{kKeyEscape}, "Select no pixels", "Puts down what floats.",
          [](S, A actions, U) { actions.push_back(action::SelectPixels{}); }, has_selected_pixels),
  };
}

std::vector<Command> palette_commands() {
  return {
      repeating(command("palette/previous", KeyChord{'['}, "Previous colour",
                        "The left button's colour, one back.", cycle_color<-1, false>)),
      repeating(command("palette/next", KeyChord{']'}, "Next colour", "The left button's colour, one on.",
                        cycle_color<1, false>)),
      repeating(command("palette/previous_right", shift('['), "Previous right colour",
                        "The right button's colour, one back.", cycle_color<-1, true>)),
      repeating(command("palette/next_right", shift(']'), "Next right colour",
                        "The right button's colour, one on.", cycle_color<1, true>)),
      command("palette/copy", ctrl_shift('c'), "Copy the palette",
              "Copies all sixteen colours as 96 hex digits, as TIC-80 does.", copy_palette),
      command("palette/paste", ctrl_shift('v'), "Paste the palette",
              "Puts in sixteen colours, also from TIC-80, or RRGGBB for the chosen one.", paste_colors),
  };
}

std::vector<Command> sheet_commands() {
  return {
      also_called("spritesheet bank", command("sheet/switch", KeyChord{kKeyTab}, "Tiles or sprites",
                                              "Switches between the two sheets.", switch_sheet)),
      arrow<-1, 0>("sheet/left", kKeyLeft, "To the left"),
      arrow<1, 0>("sheet/right", kKeyRight, "To the right"),
      arrow<0, -1>("sheet/up", kKeyUp, "Up"),
      arrow<0, 1>("sheet/down", kKeyDown, "Down"),
  };
}

}  // namespace

std::vector<Command> tool_commands() {
  return in_scope(Scope::sprites,
                  joined({pixel_tools(), pixel_changes(), palette_commands(), sheet_commands()}));
}

}  // namespace talus
