// The commands of the map: its tools, its selection and the clipboard.
#include <string>

#include "command_table.h"
#include "edit/auto_tile.h"
#include "edit/map_mirror.h"
#include "edit/map_rectangle.h"
#include "edit/map_selection.h"
#include "edit/spawn_tools.h"
#include "edit/stamp.h"
#include "edit/tile_search.h"
#include "panels/inspector/chosen_curve.h"
#include "panels/inspector/chosen_spawn.h"
#include "session/map_clipboard.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

template <MapTool tool>
Command map_tool(std::string_view id, KeyChord key, std::string_view label, std::string_view help) {
  return toggle(id, key, label, help, choose_map_tool<tool>, is_map_tool<tool>);
}

bool has_selected_cells(S session, const Ui&) { return session.choices().selection.has_value(); }
// In a drag the key cancels that alone.
bool has_something_to_drop(S session, const Ui&) {
  if (ImGui::IsAnyMouseDown()) return false;
  return session.choices().selection.has_value() || session.choices().pasted.has_value();
}

void select_all(S session, A actions, U) {
  actions.push_back(action::SelectCells{{{0, 0, session.level().map.width(), session.level().map.height()}}});
  actions.push_back(action::SetMapTool{MapTool::select});
}

// What was pasted last goes first.
void select_none(S session, A actions, U) {
  if (session.choices().pasted)
    actions.push_back(action::SetPasted{});
  else
    actions.push_back(action::SelectCells{});
}

void copy_selection(S session, A, U) {
  const std::string text = text_of_cells(stamp_of_map(session.level(), *session.choices().selection));
  ImGui::SetClipboardText(text.c_str());
}

void cut_selection(S session, A actions, U ui) {
  copy_selection(session, actions, ui);
  Edit cut = erase_cells(session.level(), *session.choices().selection);
  cut.label = "Cut tiles";
  emit_edit(actions, std::move(cut));
}

void paste_at_mouse(S, A actions, U) {
  const char* text = ImGui::GetClipboardText();
  auto tiles = cells_of_text(text == nullptr ? "" : text);
  if (!tiles) {
    actions.push_back(action::ShowMessage{"Nothing to paste: " + tiles.error() + ".", true});
    return;
  }
  actions.push_back(action::SetMapTool{MapTool::select});
  actions.push_back(action::SetPasted{*std::move(tiles)});
}

template <MirrorAxis axis>
void mirror_selection(S session, A actions, U) {
  MirroredCells mirrored = mirror_cells(session.level(), *session.choices().selection, axis);
  const std::string missing = text_of_missing(mirrored);
  if (!missing.empty()) actions.push_back(action::ShowMessage{missing, mirrored.without_partner > 0});
  emit_edit(actions, std::move(mirrored.edit));
}

void fill_selection(S session, A actions, U) {
  emit_edit(actions, fill_rect(session.level(), *session.choices().selection, session.choices().stamp));
}

// With the selection tool the arrows move what is selected; else, and without any, the view.
template <int dx, int dy>
void move_or_scroll(S session, A actions, U ui) {
  if (session.choices().selection && session.choices().map_tool == MapTool::select) {
    const MovedCells moved = move_selection(session.level(), session.history(), *session.choices().selection,
                                            {dx, dy}, session.next_stroke());
    actions.push_back(action::EditLevel{moved.edit, moved.stroke});
  } else {
    ui.view.scroll_by = ui.view.scroll_by + Vec2{dx * 64.0, dy * 64.0};
  }
}

void erase_hovered(S session, A actions, U ui) {
  if (session.choices().map_tool == MapTool::body) {
    const int chosen = chosen_spawn(session);
    if (chosen >= 0) emit_edit(actions, remove_spawn(session.level(), chosen));
    return;
  }
  if (draws_curves(session.choices().map_tool)) return delete_curve(session, actions, ui);
  if (session.choices().selection) {
    emit_edit(actions, erase_cells(session.level(), *session.choices().selection));
    return;
  }
  const auto cell = ui.view.hover.cell;
  if (!cell) return;
  if (session.choices().map_tool == MapTool::ground && !session.level().auto_tiles.empty()) {
    emit_edit(actions, paint_ground(session.level(), *cell, *cell, GroundChange::remove));
    return;
  }
  const Stamp& stamp = session.choices().stamp;
  emit_edit(actions, erase_cells(session.level(), {cell->x, cell->y, stamp.w, stamp.h}));
}

std::vector<Command> map_tool_commands() {
  return {
      map_tool<MapTool::stamp>("map/stamp", KeyChord{'1'}, "Stamp", "Paints the selected tiles."),
      map_tool<MapTool::pan>("map/pan", KeyChord{'2'}, "Move the view",
                             "Drags the view; so do the right button, and Space where it is no player's."),
      map_tool<MapTool::select>("map/select", KeyChord{'3'}, "Select",
                                "Selects a dragged rectangle of cells. Drag inside it, or press the arrows, "
                                "to move its tiles; with "
                                "Ctrl, a drag leaves a copy behind. A click elsewhere selects nothing."),
      also_called("bucket flood",
                  map_tool<MapTool::fill>(
                      "map/fill", KeyChord{'4'}, "Fill",
                      "Fills an area of equal tiles with the stamp; with Ctrl, that tile everywhere. "
                      "Stays inside the selection.")),
      map_tool<MapTool::line>("map/line", KeyChord{'5'}, "Line", "Paints the stamp along a dragged line."),
      map_tool<MapTool::rectangle>("map/rectangle", KeyChord{'6'}, "Rectangle",
                                   "Fills a dragged rectangle with the stamp; with Shift, only its outline."),
      map_tool<MapTool::ellipse>("map/ellipse", KeyChord{'7'}, "Ellipse",
                                 "Fills the ellipse in a dragged rectangle with the stamp; with Shift, only "
                                 "its outline."),
      map_tool<MapTool::slope>(
          "map/slope", KeyChord{'8'}, "Lay a slope",
          "Drag a line: the selected slope tiles are laid along it, or, without any, new ones drawn."),
      also_called(
          "line edge collision",
          map_tool<MapTool::segment>(
              "map/segment", KeyChord{'9'}, "Add a segment",
              "Drag a line: it stops bodies on its left, so to the right it is a floor, to the left a "
              "ceiling. For the exact solver. Drag one that is there to move it, a chosen one's ends to turn "
              "it; "
              "with Shift, a drag always draws. Ends snap; Ctrl: to half pixels, Alt: not at all.")),
      also_called("spawn object entity player start",
                  map_tool<MapTool::body>(
                      "map/body", KeyChord{'0'}, "Place bodies",
                      "Places a ball or a player, as the inspector says, or moves one that is there; the "
                      "chosen one's arrow is its velocity at the start.")),
      map_tool<MapTool::erase>("map/erase", KeyChord{'e'}, "Erase", "Paints tile 0."),
      also_called(
          "eyedropper sample",
          map_tool<MapTool::pick>("map/pick", KeyChord{'i'}, "Pick tiles",
                                  "Takes the tiles of a dragged rectangle as the stamp; so does the middle "
                                  "button with any tool.")),
      repeating(command("map/delete", KeyChord{kKeyDelete}, "Delete",
                        "Paints tile 0 over the selection, or else under the mouse, as large as the stamp; "
                        "with the body tool, removes the chosen body, and with those that draw curves, the "
                        "one under the mouse, or the chosen one.",
                        erase_hovered)),
  };
}

std::vector<Command> selection_commands() {
  return {
      command("map/select_all", ctrl('a'), "Select all", "Selects the whole map.", select_all),
      command("map/select_none", KeyChord{kKeyEscape}, "Select nothing",
              "Lets go what was pasted; then removes the selection.", select_none, has_something_to_drop),
      command("map/cut", ctrl('x'), "Cut", "Copies the selected tiles, and paints tile 0 over them.",
              cut_selection, has_selected_cells),
      command("map/copy", ctrl('c'), "Copy",
              "Copies the selected tiles to the clipboard, in the form that TIC-80's map editor reads.",
              copy_selection, has_selected_cells),
      command("map/paste", ctrl('v'), "Paste",
              "Takes tiles from the clipboard, of TIC-80's map editor too: they hang at the mouse until a "
              "click puts them down.",
              paste_at_mouse),
      command("map/mirror_h", KeyChord{'h'}, "Mirror left and right",
              "Mirrors the selected tiles; slopes become the tiles that slope the other way.",
              mirror_selection<MirrorAxis::horizontal>, has_selected_cells),
      command("map/mirror_v", KeyChord{'v'}, "Mirror up and down",
              "Mirrors the selected tiles; floors become the tiles that are such ceilings.",
              mirror_selection<MirrorAxis::vertical>, has_selected_cells),
      command("map/fill_selection", shift('f'), "Fill the selection",
              "Fills the selection with the stamp, repeated from its top-left corner.", fill_selection,
              has_selected_cells),
  };
}

void open_find_tiles(S session, A, U ui) {
  ui.view.find_tiles_open = true;
  ui.view.wants_text = "find_tiles/find";
  ui.view.find_tile = session.choices().stamp.tiles.front();
}

template <FindDirection direction>
void find_next_tile(S session, A actions, U ui) {
  if (!ui.view.find_tiles_open) ui.view.find_tile = session.choices().stamp.tiles.front();
  const auto tile = static_cast<std::uint8_t>(ui.view.find_tile);
  const auto cell =
      find_tile(session.level().map, tile, ui.view.search_start(), direction, session.choices().selection);
  if (!cell) {
    const std::string place = session.choices().selection ? "selection" : "map";
    actions.push_back(action::ShowMessage{"The " + place + " has no tile " + std::to_string(tile) + "."});
    return;
  }
  ui.view.centre_on = ui.view.marked_cell = cell;
  if (ui.view.canvas == CanvasMode::play) ui.view.canvas = CanvasMode::both;
}

std::vector<Command> whole_map_commands() {
  return {
      also_called("search swap count",
                  command("map/find", ctrl('h'), "Find and replace tiles...",
                          "Finds the chosen tile on the map, counts it and replaces it.", open_find_tiles)),
      repeating(command("map/find_next", KeyChord{'n'}, "Next such tile",
                        "Shows the next cell with the tile that is looked for, or else with the chosen one.",
                        find_next_tile<FindDirection::next>)),
      repeating(
          command("map/find_previous", shift('n'), "Previous such tile",
                  "Shows the cell before with the tile that is looked for, or else with the chosen one.",
                  find_next_tile<FindDirection::previous>)),
      also_called("resize map dimensions width height crop extend shift larger smaller",
                  command("map/resize", ctrl('e'), "Size of the map...",
                          "Makes the map larger or smaller, or shifts everything on it.",
                          [](S, A, U ui) { ui.view.resize_open = true; })),
  };
}

std::vector<Command> map_view_commands() {
  return {
      command("map/fit", KeyChord{kKeyTab}, "World view",
              "Shows the whole map, or goes back to where you were.",
              [](S, A, U ui) { ui.view.fit_map = true; }),
      repeating(command("map/left", KeyChord{kKeyLeft}, "Left",
                        "Moves the selected tiles by a cell, with the selection tool; else the view.",
                        move_or_scroll<-1, 0>)),
      repeating(command("map/right", KeyChord{kKeyRight}, "Right",
                        "Moves the selected tiles by a cell, with the selection tool; else the view.",
                        move_or_scroll<1, 0>)),
      repeating(command("map/up", KeyChord{kKeyUp}, "Up",
                        "Moves the selected tiles by a cell, with the selection tool; else the view.",
                        move_or_scroll<0, -1>)),
      repeating(command("map/down", KeyChord{kKeyDown}, "Down",
                        "Moves the selected tiles by a cell, with the selection tool; else the view.",
                        move_or_scroll<0, 1>)),
  };
}

}  // namespace

std::vector<Command> map_commands() {
  return in_scope(Scope::map, joined({map_tool_commands(), selection_commands(), whole_map_commands(),
                                      map_view_commands()}));
}

}  // namespace talus
