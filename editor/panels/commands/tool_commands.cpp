// The commands of the sprites: the pixel canvas, the palette and the sheet.
#include <algorithm>
#include <optional>
#include <vector>

#include "command_table.h"
#include "edit/picture_palette.h"
#include "edit/sprite_clear.h"
#include "edit/sprite_clipboard.h"
#include "edit/sprite_turn.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool paints_in_rgba(S session, const Ui&) {
  return is_in_rgba(session.level(), session.choices().area.sheet);
}

// A tool needs its canvas: below a sheet in true colour that is folded away until somebody asks for it.
CommandRun choose_sprite_tool(SpriteTool tool) {
  return [tool](S session, A actions, U ui) {
    actions.push_back(action::SetSpriteTool{tool});
    if (paints_in_rgba(session, ui)) ui.view.sprites.pixels.unfolded = true;
  };
}

CommandTest is_sprite_tool(SpriteTool tool) {
  return [tool](S session, const Ui&) { return session.choices().sprite_tool == tool; };
}

CommandRun change_brush(int step) {
  return [step](S session, A actions, U) {
    actions.push_back(action::SetBrush{session.choices().brush + step});
  };
}

bool has_selected_pixels(S session, const Ui&) { return session.choices().pixels.rect().has_value(); }

void select_all_pixels(S session, A actions, U) {
  const SpriteArea& area = session.choices().area;
  actions.push_back(action::SetSpriteTool{SpriteTool::select});
  actions.push_back(action::SelectPixels{CellRect{0, 0, area.width(), area.height()}});
}

CommandRun turn_pixels(PixelTurn turn) {
  return [turn](S, A actions, U) { actions.push_back(action::TurnPixels{turn}); };
}

bool can_rotate(S session, const Ui& ui) {
  const SpriteArea& area = session.choices().area;
  return has_selected_pixels(session, ui) || area.width() == area.height();
}

// Clears the selected pixels, or the tiles and their flags if no pixels are selected.
void clear_sprite(S session, A actions, U) {
  const Choices& choices = session.choices();
  const PixelColor color = choices.paint(session.level(), true);
  const auto& rect = choices.pixels.rect();
  actions.push_back(action::EditLevel{rect ? clear_pixels(session.level(), choices.area, *rect, color)
                                           : clear_area(session.level(), choices.area, color)});
}

void copy_sprite(S session, A, U) {
  const Level& level = session.level();
  const Choices& choices = session.choices();
  const SpriteArea& area = choices.area;
  const std::string text =
      choices.pixels.rect() ? pixels_to_text(choices.pixels.pixels(level, area)) : tiles_to_text(level, area);
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
  const bool is_whole = !choices.pixels.rect() && has_tiles_for(session.level(), choices.area, text);
  const bool in_rgba = is_in_rgba(session.level(), choices.area.sheet);
  auto block = pixels_from_text(text);
  if (auto tiles = block ? std::nullopt : tile_pixels_from_text(text); tiles && (in_rgba || tiles->in_rgba))
    block = std::move(tiles);
  if (block && !is_whole) {
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
  emit_paste(actions, paste_palette(session.level(), ui.view.sprites.palette_color, clipboard_text()));
}

// The colour of the picture beside that of a button, in the order of the palette panel.
std::optional<Rgba> color_beside(S session, int step, bool secondary) {
  const Choices& choices = session.choices();
  const std::vector<Rgba> colors = picture_palette(session.level(), choices.area);
  if (colors.empty()) return std::nullopt;
  const auto count = static_cast<int>(colors.size());
  const auto now = std::find(colors.begin(), colors.end(), secondary ? choices.secondary_rgba : choices.rgba);
  const int at = now == colors.end() ? (step > 0 ? -1 : 0) : static_cast<int>(now - colors.begin());
  return colors[static_cast<std::size_t>((at + step + count) % count)];
}

CommandRun cycle_color(int step, bool secondary) {
  return [step, secondary](S session, A actions, U ui) {
    if (is_in_rgba(session.level(), session.choices().area.sheet)) {
      if (const auto color = color_beside(session, step, secondary))
        actions.push_back(action::SetRgba{*color, secondary});
      return;
    }
    const int now = secondary ? session.choices().secondary_color : session.choices().color;
    ui.view.sprites.palette_color = (now + step + kColorCount) % kColorCount;
    actions.push_back(action::SetColor{ui.view.sprites.palette_color, secondary});
  };
}

// Moves the selected pixels, or the selection on the sheet if no pixels are selected.
CommandRun move_selection(int dx, int dy) {
  return [dx, dy](S session, A actions, U ui) {
    if (has_selected_pixels(session, ui)) {
      actions.push_back(action::MovePixels{{dx, dy}});
      return;
    }
    SpriteArea area = session.choices().area;
    area.tiles.x += dx;
    area.tiles.y += dy;
    if (area.lies_in_sheet(session.level())) actions.push_back(action::SelectTiles{area});
  };
}

void switch_sheet(S session, A actions, U) {
  SpriteArea area = session.choices().area;
  area.sheet = area.sheet == SheetId::tiles ? SheetId::sprites : SheetId::tiles;
  actions.push_back(action::SelectTiles{area});
}

std::vector<Command> pixel_tools() {
  return {
      {.id = "pixels/pencil",
       .label = "Pencil",
       .help = "Draws pixels; the right button draws the other colour.",
       .key = KeyChord{'1'},
       .menu = menus::kSpritesTools,
       .icon = Icon::pencil,
       .run = choose_sprite_tool(SpriteTool::pencil),
       .checked = is_sprite_tool(SpriteTool::pencil)},
      {.id = "pixels/pick",
       .label = "Pick colour",
       .help = "Takes the colour under the mouse; so does a click of the middle button.",
       .key = KeyChord{'2'},
       .menu = menus::kSpritesTools,
       .icon = Icon::pick,
       .run = choose_sprite_tool(SpriteTool::pick),
       .checked = is_sprite_tool(SpriteTool::pick),
       .words = "eyedropper sample"},
      {.id = "pixels/select",
       .label = "Select pixels",
       .help = "Drag a rectangle, then drag it elsewhere or move it by the arrows: it floats over the other "
               "pixels. "
               "Flips, rotation, shifts, clearing and the clipboard act on it; Escape drops it.",
       .key = KeyChord{'3'},
       .menu = menus::kSpritesTools,
       .icon = Icon::select,
       .run = choose_sprite_tool(SpriteTool::select),
       .checked = is_sprite_tool(SpriteTool::select)},
      {.id = "pixels/fill",
       .label = "Fill",
       .help = "Fills an area of one colour; with Ctrl, that colour everywhere.",
       .key = KeyChord{'4'},
       .menu = menus::kSpritesTools,
       .icon = Icon::fill,
       .run = choose_sprite_tool(SpriteTool::fill),
       .checked = is_sprite_tool(SpriteTool::fill),
       .words = "bucket flood"},
      {.id = "pixels/line",
       .label = "Line",
       .help = "Drag a line; with Shift, level, upright or diagonal.",
       .key = KeyChord{'l'},
       .menu = menus::kSpritesTools,
       .icon = Icon::line,
       .run = choose_sprite_tool(SpriteTool::line),
       .checked = is_sprite_tool(SpriteTool::line)},
      {.id = "pixels/rectangle",
       .label = "Rectangle",
       .help = "Drag a rectangle; with Shift a square, with Ctrl filled.",
       .key = KeyChord{'r'},
       .menu = menus::kSpritesTools,
       .icon = Icon::frame,
       .run = choose_sprite_tool(SpriteTool::rectangle),
       .checked = is_sprite_tool(SpriteTool::rectangle)},
      {.id = "pixels/ellipse",
       .label = "Ellipse",
       .help = "Drag an ellipse; with Shift a circle, with Ctrl filled.",
       .key = KeyChord{'e'},
       .menu = menus::kSpritesTools,
       .icon = Icon::ellipse,
       .run = choose_sprite_tool(SpriteTool::ellipse),
       .checked = is_sprite_tool(SpriteTool::ellipse)},
      {.id = "pixels/smaller_brush",
       .label = "Smaller brush",
       .help = "Makes the brush one px smaller, down to 1.",
       .key = KeyChord{'-'},
       .menu = menus::kSpritesTools,
       .run = change_brush(-1),
       .enabled = [](S s, const Ui&) { return s.choices().brush > 1; },
       .repeats = true},
      {.id = "pixels/larger_brush",
       .label = "Larger brush",
       .help = "Makes the brush one px larger, up to 4.",
       .key = KeyChord{'='},
       .menu = menus::kSpritesTools,
       .run = change_brush(1),
       .enabled = [](S s, const Ui&) { return s.choices().brush < kMaxBrush; },
       .repeats = true},
      {.id = "pixels/neighbours",
       .label = "Neighbours on the map",
       .help = "Shows the lines of slopes and the tiles around: those at the place on the map where the "
               "mouse was last, or else the most common ones.",
       .key = KeyChord{'n'},
       .menu = menus::kSpritesView,
       .icon = Icon::neighbours,
       .run = toggle<&View::sprites, &SpritesView::pixels, &PixelView::neighbours>,
       .checked = is_on<&View::sprites, &SpritesView::pixels, &PixelView::neighbours>},
      {.id = "pixels/zoom_in",
       .label = "Zoom in on the pixels",
       .help = "Shows the pixels larger. What has no room is scrolled by bars and the wheel. Ctrl and the "
               "wheel zoom "
               "at the mouse.",
       .menu = menus::kSpritesView,
       .run = [](S, A, U ui) { ++ui.view.sprites.pixel_zoom; },
       .enabled = [](S, const Ui& ui) { return ui.view.sprites.pixel_zoom < kMaxPixelZoom; },
       .words = "magnify"},
      {.id = "pixels/zoom_out",
       .label = "Zoom out of the pixels",
       .help = "Shows the pixels smaller, until all of them have room.",
       .menu = menus::kSpritesView,
       .run = [](S, A, U ui) { --ui.view.sprites.pixel_zoom; },
       .enabled = [](S, const Ui& ui) { return ui.view.sprites.pixel_zoom > 0; }},
      {.id = "pixels/show",
       .label = "Pixel editor",
       .help = "Shows the pixels, tools and colours below a sheet in true colour, or folds them away for a "
               "larger "
               "sheet.",
       .menu = menus::kSpritesView,
       .icon = Icon::pencil,
       .run = toggle<&View::sprites, &SpritesView::pixels, &PixelView::unfolded>,
       .enabled = paints_in_rgba,
       .checked = [](S s, const Ui& ui) { return !paints_in_rgba(s, ui) || ui.view.sprites.pixels.unfolded; },
       .words = "fold hide paint draw canvas tools palette"},
      {.id = "pixels/enlarge",
       .label = "Enlarge the pixels",
       .help = "Shows the pixel canvas above the map and the play view, instead of below the sheet.",
       .key = KeyChord{'z'},
       .menu = menus::kSpritesView,
       .icon = Icon::enlarge,
       .run = toggle<&View::sprites, &SpritesView::pixels, &PixelView::enlarged>,
       .checked = is_on<&View::sprites, &SpritesView::pixels, &PixelView::enlarged>},
  };
}

std::vector<Command> pixel_changes() {
  return {
      {.id = "pixels/flip_h",
       .label = "Flip left and right",
       .help = "Mirrors the selected pixels, or all of the canvas, left to right.",
       .key = KeyChord{'5'},
       .menu = menus::kSpritesChanges,
       .icon = Icon::flip_horizontal,
       .run = turn_pixels(PixelTurn::flip_horizontal)},
      {.id = "pixels/flip_v",
       .label = "Flip up and down",
       .help = "Mirrors the selected pixels, or all of the canvas, top to bottom.",
       .key = KeyChord{'6'},
       .menu = menus::kSpritesChanges,
       .icon = Icon::flip_vertical,
       .run = turn_pixels(PixelTurn::flip_vertical)},
      {.id = "pixels/rotate",
       .label = "Rotate",
       .help = "Turns the selected pixels, or all of a square canvas, by a quarter, clockwise.",
       .key = KeyChord{'7'},
       .menu = menus::kSpritesChanges,
       .icon = Icon::rotate,
       .run = turn_pixels(PixelTurn::rotate),
       .enabled = can_rotate},
      {.id = "pixels/clear",
       .label = "Clear",
       .help = "Fills the selected pixels, or the whole canvas, with the right button's colour. Without a "
               "selection it clears the flags, too.",
       .key = KeyChord{'8'},
       .other_key = KeyChord{kKeyDelete},
       .menu = menus::kSpritesChanges,
       .icon = Icon::clear,
       .run = clear_sprite},
      {.id = "pixels/shift_left",
       .label = "Shift pixels left",
       .help = "Shifts the selected pixels, or all of the canvas, by one px; they come in again at the "
               "other side.",
       .key = shift(kKeyLeft),
       .menu = menus::kSpritesChanges,
       .run = turn_pixels(PixelTurn::shift_left),
       .repeats = true},
      {.id = "pixels/shift_right",
       .label = "Shift pixels right",
       .help = "Shifts the selected pixels, or all of the canvas, by one px; they come in again at the "
               "other side.",
       .key = shift(kKeyRight),
       .menu = menus::kSpritesChanges,
       .run = turn_pixels(PixelTurn::shift_right),
       .repeats = true},
      {.id = "pixels/shift_up",
       .label = "Shift pixels up",
       .help = "Shifts the selected pixels, or all of the canvas, by one px; they come in again at the "
               "other side.",
       .key = shift(kKeyUp),
       .menu = menus::kSpritesChanges,
       .run = turn_pixels(PixelTurn::shift_up),
       .repeats = true},
      {.id = "pixels/shift_down",
       .label = "Shift pixels down",
       .help = "Shifts the selected pixels, or all of the canvas, by one px; they come in again at the "
               "other side.",
       .key = shift(kKeyDown),
       .menu = menus::kSpritesChanges,
       .run = turn_pixels(PixelTurn::shift_down),
       .repeats = true},
      {.id = "pixels/cut",
       .label = "Cut",
       .help = "Copies, then clears.",
       .key = ctrl('x'),
       .menu = menus::kSpritesSelection,
       .run = cut_sprite},
      {.id = "pixels/copy",
       .label = "Copy",
       .help = "Copies the selected pixels, or the tiles with their flags, as TIC-80 does.",
       .key = ctrl('c'),
       .menu = menus::kSpritesSelection,
       .run = copy_sprite},
      {.id = "pixels/paste",
       .label = "Paste",
       .help = "Pastes pixels, which float, or as many tiles as are selected, with their flags; also from "
               "TIC-80. "
               "Each gets the nearest colour where there are 16.",
       .key = ctrl('v'),
       .menu = menus::kSpritesSelection,
       .run = paste_sprite},
      {.id = "pixels/select_all",
       .label = "Select all pixels",
       .help = "Selects all of the canvas.",
       .key = ctrl('a'),
       .menu = menus::kSpritesSelection,
       .run = select_all_pixels},
      {.id = "pixels/deselect",
       .label = "Select no pixels",
       .help = "Drops floating pixels on the canvas.",
       .key = KeyChord{kKeyEscape},
       .menu = menus::kSpritesSelection,
       .run = [](S, A actions, U) { actions.push_back(action::SelectPixels{}); },
       .enabled = has_selected_pixels},
  };
}

std::vector<Command> palette_commands() {
  return {
      {.id = "palette/previous",
       .label = "Previous colour",
       .help = "Chooses the previous colour for the left button.",
       .key = KeyChord{'['},
       .run = cycle_color(-1, false),
       .repeats = true},
      {.id = "palette/next",
       .label = "Next colour",
       .help = "Chooses the next colour for the left button.",
       .key = KeyChord{']'},
       .run = cycle_color(1, false),
       .repeats = true},
      {.id = "palette/previous_right",
       .label = "Previous right colour",
       .help = "Chooses the previous colour for the right button.",
       .key = shift('['),
       .run = cycle_color(-1, true),
       .repeats = true},
      {.id = "palette/next_right",
       .label = "Next right colour",
       .help = "Chooses the next colour for the right button.",
       .key = shift(']'),
       .run = cycle_color(1, true),
       .repeats = true},
      {.id = "palette/copy",
       .label = "Copy the palette",
       .help = "Copies all sixteen colours as 96 hex digits, as TIC-80 does.",
       .key = ctrl_shift('c'),
       .menu = menus::kSpritesPalette,
       .run = copy_palette},
      {.id = "palette/paste",
       .label = "Paste the palette",
       .help = "Pastes sixteen colours, also from TIC-80, or RRGGBB for the chosen colour.",
       .key = ctrl_shift('v'),
       .menu = menus::kSpritesPalette,
       .run = paste_colors},
  };
}

std::vector<Command> sheet_commands() {
  return {
      {.id = "sheet/switch",
       .label = "Tiles or sprites",
       .help = "Switches between the two sheets.",
       .key = KeyChord{kKeyTab},
       .menu = menus::kSpritesView,
       .run = switch_sheet,
       .words = "spritesheet bank"},
      {.id = "sheet/zoom_in",
       .label = "Zoom in on the sheet",
       .help = "Shows the tiles larger; the wheel zooms at the mouse, and the middle button moves the sheet.",
       .menu = menus::kSpritesView,
       .icon = Icon::zoom_in,
       .run = [](S, A, U ui) { ++ui.view.sprites.sheet_zoom; },
       .words = "magnify wheel tiles"},
      {.id = "sheet/zoom_out",
       .label = "Zoom out of the sheet",
       .help = "Shows more tiles, smaller; the wheel zooms at the mouse.",
       .menu = menus::kSpritesView,
       .icon = Icon::zoom_out,
       .run = [](S, A, U ui) { --ui.view.sprites.sheet_zoom; },
       .words = "wheel tiles"},
      {.id = "sheet/find",
       .label = "Find on the sheet",
       .help = "Finds tiles by number, tileset, flag or shape, and dims the others.",
       .menu = menus::kSpritesView,
       .run =
           [](const Session& session, Actions& actions, Ui& ui) {
             ui.view.sprites.finds = true;
             actions.push_back(action::SelectTiles{{SheetId::tiles, session.choices().area.tiles}});
             ui.ask(request::ShowTab(panel_id::kSheet));
             ui.ask(request::FocusField("sheet/find"));
           },
       .words = "search tile flag shape"},
      {.id = "sheet/add_tileset",
       .label = "Add a tileset...",
       .help = "Cuts a PNG into tiles, and adds them to the level, below its others.",
       .menu = menus::kSpritesView,
       .run = [](const Session&, Actions&,
                 Ui& ui) { ui.ask(request::ShowFileDialog{FileDialog::add_tileset}); },
       .enabled = [](const Session& session, const Ui&) { return session.level().tiled == nullptr; },
       .words = "png picture tiles"},
      {.id = "sheet/mark_used",
       .label = "Mark used tiles",
       .help = "Marks the tiles of the sheet that the map uses, and dims the others.",
       .menu = menus::kSpritesView,
       .run = [](const Session&, Actions&,
                 Ui& ui) { ui.view.sprites.marks_used = !ui.view.sprites.marks_used; },
       .checked = [](const Session&, const Ui& ui) { return ui.view.sprites.marks_used; },
       .words = "unused count"},
      {.id = "sheet/left",
       .label = "To the left",
       .help = "Moves the selection on the sheet, or the selected pixels.",
       .key = KeyChord{kKeyLeft},
       .run = move_selection(-1, 0),
       .repeats = true},
      {.id = "sheet/right",
       .label = "To the right",
       .help = "Moves the selection on the sheet, or the selected pixels.",
       .key = KeyChord{kKeyRight},
       .run = move_selection(1, 0),
       .repeats = true},
      {.id = "sheet/up",
       .label = "Up",
       .help = "Moves the selection on the sheet, or the selected pixels.",
       .key = KeyChord{kKeyUp},
       .run = move_selection(0, -1),
       .repeats = true},
      {.id = "sheet/down",
       .label = "Down",
       .help = "Moves the selection on the sheet, or the selected pixels.",
       .key = KeyChord{kKeyDown},
       .run = move_selection(0, 1),
       .repeats = true},
  };
}

}  // namespace

std::vector<Command> tool_commands() {
  return in_scope(Scope::sprites,
                  joined({pixel_tools(), pixel_changes(), palette_commands(), sheet_commands()}));
}

}  // namespace talus
