// The commands of the map: its tools, its selection and the clipboard.
#include <string>

#include "command_table.h"
#include "edit/auto_tile.h"
#include "edit/map_mirror.h"
#include "edit/map_rectangle.h"
#include "edit/map_selection.h"
#include "edit/map_turn.h"
#include "edit/spawn_tools.h"
#include "edit/stamp.h"
#include "edit/tile_search.h"
#include "panels/inspector/chosen_curve.h"
#include "panels/inspector/chosen_object.h"
#include "panels/inspector/chosen_spawn.h"
#include "session/editing/map_clipboard.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

bool has_selected_cells(S session, const Ui&) { return session.choices().selection.has_value(); }
// During a drag the key cancels only the drag.
bool has_something_to_drop(S session, const Ui&) {
  if (ImGui::IsAnyMouseDown()) return false;
  return session.choices().selection.has_value() || session.choices().pasted.has_value();
}

void select_all(S session, A actions, U) {
  actions.push_back(action::SelectCells{{{0, 0, session.level().map.width(), session.level().map.height()}}});
  actions.push_back(action::SetMapTool{MapTool::select});
}

// Pasted tiles are dropped first.
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

CommandRun mirror_selection(MirrorAxis axis) {
  return [axis](S session, A actions, U) {
    MirroredCells mirrored = mirror_cells(session.level(), *session.choices().selection, axis);
    const std::string missing = text_of_missing(mirrored);
    if (!missing.empty()) actions.push_back(action::ShowMessage{missing, mirrored.without_partner > 0});
    emit_edit(actions, std::move(mirrored.edit));
  };
}

// Turns what the mouse carries, or the selection, or the stamp.
CommandRun turn_tiles(TileTurn turn) {
  return [turn](S session, A actions, U) {
    const Choices& choices = session.choices();
    if (choices.pasted) return actions.push_back(action::SetPasted{turned(*choices.pasted, turn)});
    if (choices.map_tool != MapTool::select || !choices.selection)
      return actions.push_back(action::SetStamp{turned(choices.stamp, turn)});
    Edit edit = turn_cells(session.level(), *choices.selection, turn);
    if (edit.empty() && !edit.selection) return;
    actions.push_back(action::EditLevel{std::move(edit)});
  };
}

void fill_selection(S session, A actions, U) {
  emit_edit(actions, fill_rect(session.level(), *session.choices().selection, session.choices().stamp));
}

// With the selection tool and a selection the arrows move the selection, with the object tool the chosen
// object, otherwise the view.
CommandRun move_or_scroll(int dx, int dy) {
  return [dx, dy](S session, A actions, U ui) {
    if (session.choices().selection && session.choices().map_tool == MapTool::select) {
      const MovedCells moved = move_selection(session.level(), session.history(),
                                              *session.choices().selection, {dx, dy}, session.next_stroke());
      actions.push_back(action::EditLevel{moved.edit, moved.stroke});
    } else if (session.choices().map_tool == MapTool::object && chosen_object(session) != nullptr) {
      move_chosen_object(session, actions, {1.0 * dx, 1.0 * dy});
    } else {
      ui.ask(request::Scroll{{dx * 64.0, dy * 64.0}});
    }
  };
}

void erase_hovered(S session, A actions, U ui) {
  if (session.choices().map_tool == MapTool::body) {
    const int chosen = chosen_spawn(session);
    if (chosen >= 0) emit_edit(actions, remove_spawn(session.level(), chosen));
    return;
  }
  if (draws_curves(session.choices().map_tool)) return delete_curve(session, actions, ui);
  if (session.choices().map_tool == MapTool::object) return delete_object(session, actions);
  if (session.choices().selection) {
    emit_edit(actions, erase_cells(session.level(), *session.choices().selection));
    return;
  }
  const auto cell = ui.view.canvas.hover.cell;
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
      {.id = "map/stamp",
       .label = "Stamp",
       .help = "Paints the selected tiles.",
       .key = KeyChord{'1'},
       .menu = menus::kMapTools,
       .icon = Icon::stamp,
       .run = choose_map_tool(MapTool::stamp),
       .checked = is_map_tool(MapTool::stamp)},
      {.id = "map/pan",
       .label = "Move the view",
       .help = "Drags the view; so do the right button, and Space unless a player uses it.",
       .key = KeyChord{'2'},
       .menu = menus::kMapTools,
       .icon = Icon::pan,
       .run = choose_map_tool(MapTool::pan),
       .checked = is_map_tool(MapTool::pan)},
      {.id = "map/select",
       .label = "Select",
       .help = "Selects a dragged rectangle of cells. Drag inside it, or press the arrows, "
               "to move its tiles; with "
               "Ctrl, a drag leaves a copy behind. A click elsewhere clears the selection.",
       .key = KeyChord{'3'},
       .menu = menus::kMapTools,
       .icon = Icon::select,
       .run = choose_map_tool(MapTool::select),
       .checked = is_map_tool(MapTool::select)},
      {.id = "map/fill",
       .label = "Fill",
       .help = "Fills an area of equal tiles with the stamp; with Ctrl, that tile everywhere. "
               "Stays inside the selection.",
       .key = KeyChord{'4'},
       .menu = menus::kMapTools,
       .icon = Icon::fill,
       .run = choose_map_tool(MapTool::fill),
       .checked = is_map_tool(MapTool::fill),
       .words = "bucket flood"},
      {.id = "map/line",
       .label = "Line",
       .help = "Paints the stamp along a dragged line.",
       .key = KeyChord{'5'},
       .menu = menus::kMapTools,
       .icon = Icon::line,
       .run = choose_map_tool(MapTool::line),
       .checked = is_map_tool(MapTool::line)},
      {.id = "map/rectangle",
       .label = "Rectangle",
       .help = "Fills a dragged rectangle with the stamp; with Shift, only its outline.",
       .key = KeyChord{'6'},
       .menu = menus::kMapTools,
       .icon = Icon::rectangle,
       .run = choose_map_tool(MapTool::rectangle),
       .checked = is_map_tool(MapTool::rectangle)},
      {.id = "map/ellipse",
       .label = "Ellipse",
       .help = "Fills the ellipse in a dragged rectangle with the stamp; with Shift, only "
               "its outline.",
       .key = KeyChord{'7'},
       .menu = menus::kMapTools,
       .icon = Icon::ellipse,
       .run = choose_map_tool(MapTool::ellipse),
       .checked = is_map_tool(MapTool::ellipse)},
      {.id = "map/slope",
       .label = "Lay a slope",
       .help = "Drag a line: the selected slope tiles are laid along it; without any, new ones are drawn.",
       .key = KeyChord{'8'},
       .menu = menus::kMapTools,
       .icon = Icon::slope,
       .run = choose_map_tool(MapTool::slope),
       .checked = is_map_tool(MapTool::slope)},
      {.id = "map/segment",
       .label = "Add a segment",
       .help = "Drag a line: it stops bodies on its left, so to the right it is a floor, to the left a "
               "ceiling. For the exact solver. Drag a segment to move it, or an end of the chosen one to "
               "turn it; "
               "with Shift, a drag always draws. Ends snap; with Ctrl to half pixels, with Alt not at all.",
       .key = KeyChord{'9'},
       .menu = menus::kMapTools,
       .icon = Icon::segment,
       .run = choose_map_tool(MapTool::segment),
       .checked = is_map_tool(MapTool::segment),
       .words = "line edge collision"},
      {.id = "map/body",
       .label = "Place bodies",
       .help = "Places a body, of the kind that the inspector says, or moves one; the arrow of the chosen "
               "body is its velocity at the start.",
       .key = KeyChord{'0'},
       .menu = menus::kMapTools,
       .icon = Icon::body,
       .run = choose_map_tool(MapTool::body),
       .checked = is_map_tool(MapTool::body),
       .words = "spawn object entity player start"},
      {.id = "map/erase",
       .label = "Erase",
       .help = "Makes cells empty: paints tile 0.",
       .key = KeyChord{'e'},
       .menu = menus::kMapTools,
       .icon = Icon::erase,
       .run = choose_map_tool(MapTool::erase),
       .checked = is_map_tool(MapTool::erase)},
      {.id = "map/pick",
       .label = "Pick tiles",
       .help = "Takes the tiles of a dragged rectangle as the stamp; a click of the "
               "middle button takes a tile with any tool.",
       .key = KeyChord{'i'},
       .menu = menus::kMapTools,
       .icon = Icon::pick,
       .run = choose_map_tool(MapTool::pick),
       .checked = is_map_tool(MapTool::pick),
       .words = "eyedropper sample"},
  };
}

std::vector<Command> selection_commands() {
  return {
      {.id = "map/cut",
       .label = "Cut",
       .help = "Copies the selected tiles, and paints tile 0 over them.",
       .key = ctrl('x'),
       .menu = menus::kMapSelection,
       .run = cut_selection,
       .enabled = has_selected_cells},
      {.id = "map/copy",
       .label = "Copy",
       .help = "Copies the selected tiles to the clipboard, in the form that TIC-80's map editor reads.",
       .key = ctrl('c'),
       .menu = menus::kMapSelection,
       .run = copy_selection,
       .enabled = has_selected_cells},
      {.id = "map/paste",
       .label = "Paste",
       .help = "Pastes tiles from the clipboard, also those of TIC-80's map editor: they follow the mouse "
               "until a click puts them down.",
       .key = ctrl('v'),
       .menu = menus::kMapSelection,
       .run = paste_at_mouse},
      {.id = "map/delete",
       .label = "Delete",
       .help = "Paints tile 0 over the selection or, without one, under the mouse, as large as the stamp. "
               "The body tool and the object tool remove the chosen body or object; tools that draw curves "
               "remove the curve under the mouse, or the chosen one.",
       .key = KeyChord{kKeyDelete},
       .menu = menus::kMapSelection,
       .run = erase_hovered,
       .repeats = true},
      {.id = "map/mirror_h",
       .label = "Mirror left and right",
       .help = "Mirrors the selected tiles; slopes become the tiles that slope the other way.",
       .key = KeyChord{'h'},
       .menu = menus::kMapSelection,
       .run = mirror_selection(MirrorAxis::horizontal),
       .enabled = has_selected_cells},
      {.id = "map/mirror_v",
       .label = "Mirror up and down",
       .help = "Mirrors the selected tiles; floors become the tiles that are ceilings of the same form.",
       .key = KeyChord{'v'},
       .menu = menus::kMapSelection,
       .run = mirror_selection(MirrorAxis::vertical),
       .enabled = has_selected_cells},
      {.id = "map/flip_x",
       .label = "Flip left and right",
       .help =
           "Flips the stamp, tiles that are being pasted or, with the selection tool, the selected tiles: "
           "pictures and shapes. The other side is another turn of the same tile.",
       .key = KeyChord{'x'},
       .menu = menus::kMapSelection,
       .run = turn_tiles(TileTurn::left_right),
       .words = "mirror horizontal"},
      {.id = "map/flip_y",
       .label = "Flip up and down",
       .help =
           "Flips the stamp, tiles that are being pasted or, with the selection tool, the selected tiles: "
           "pictures and shapes.",
       .key = KeyChord{'y'},
       .menu = menus::kMapSelection,
       .run = turn_tiles(TileTurn::up_down),
       .words = "mirror vertical"},
      {.id = "map/turn_right",
       .label = "Turn right",
       .help = "Turns the stamp, tiles that are being pasted or, with the selection tool, the selected tiles "
               "by a quarter, clockwise: pictures and shapes.",
       .key = KeyChord{'z'},
       .menu = menus::kMapSelection,
       .run = turn_tiles(kTurnRight),
       .words = "rotate quarter clockwise"},
      {.id = "map/turn_left",
       .label = "Turn left",
       .help = "Turns the stamp, tiles that are being pasted or, with the selection tool, the selected tiles "
               "by a quarter, the other way: pictures and shapes.",
       .key = shift('z'),
       .menu = menus::kMapSelection,
       .run = turn_tiles(kTurnLeft),
       .words = "rotate quarter counterclockwise"},
      {.id = "map/fill_selection",
       .label = "Fill the selection",
       .help = "Fills the selection with the stamp, repeated from its top-left corner.",
       .key = shift('f'),
       .menu = menus::kMapSelection,
       .run = fill_selection,
       .enabled = has_selected_cells},
      {.id = "map/select_all",
       .label = "Select all",
       .help = "Selects the whole map.",
       .key = ctrl('a'),
       .menu = menus::kMapSelection,
       .run = select_all},
      {.id = "map/select_none",
       .label = "Select nothing",
       .help = "Removes tiles that are being pasted; otherwise removes the selection.",
       .key = KeyChord{kKeyEscape},
       .menu = menus::kMapSelection,
       .run = select_none,
       .enabled = has_something_to_drop},
  };
}

void open_find_tiles(S session, A, U ui) {
  ui.view.level.find_tiles_open = true;
  ui.ask(request::FocusField("find_tiles/find"));
  ui.view.level.find_tile = session.choices().stamp.tiles.front().tile;
}

CommandRun find_next_tile(FindDirection direction) {
  return [direction](S session, A actions, U ui) {
    if (!ui.view.level.find_tiles_open) ui.view.level.find_tile = session.choices().stamp.tiles.front().tile;
    const auto tile = static_cast<TileNumber>(ui.view.level.find_tile);
    const auto cell = find_tile(session.level().map, tile, ui.view.canvas.search_start(), direction,
                                session.choices().selection);
    if (!cell) {
      const std::string place = session.choices().selection ? "selection" : "map";
      actions.push_back(action::ShowMessage{"The " + place + " has no tile " + std::to_string(tile) + "."});
      return;
    }
    ui.view.show_on_map(*cell);
  };
}

std::vector<Command> whole_map_commands() {
  return {
      {.id = "map/find",
       .label = "Find and replace tiles...",
       .help = "Finds the chosen tile on the map, counts it and replaces it.",
       .key = ctrl('h'),
       .menu = menus::kMapSearch,
       .run = open_find_tiles,
       .words = "search swap count"},
      {.id = "map/find_next",
       .label = "Next cell with the tile",
       .help = "Shows the next cell with the searched tile, or with the chosen one if none is searched.",
       .key = KeyChord{'n'},
       .menu = menus::kMapSearch,
       .run = find_next_tile(FindDirection::next),
       .repeats = true},
      {.id = "map/find_previous",
       .label = "Previous cell with the tile",
       .help = "Shows the previous cell with the searched tile, or with the chosen one if none is searched.",
       .key = shift('n'),
       .menu = menus::kMapSearch,
       .run = find_next_tile(FindDirection::previous),
       .repeats = true},
      {.id = "map/resize",
       .label = "Size of the map...",
       .help = "Makes the map larger or smaller, or shifts everything on it.",
       .key = ctrl('e'),
       .menu = menus::kMapSearch,
       .run = [](S, A, U ui) { ui.view.level.resize_open = true; },
       .words = "resize map level dimensions width height crop extend shift larger smaller"},
      {.id = "map/background",
       .label = "Background of the map...",
       .help = "Changes the colour that is seen where the map shows nothing, or makes it clear.",
       .menu = menus::kMapSearch,
       .run = [](S, A, U ui) { ui.view.level.background_open = true; },
       .words = "background color transparent clear sky alpha"},
  };
}

constexpr const char* kArrowHelp =
    "Moves the selected tiles by a cell, with the selection tool, or the chosen object by a px, with the "
    "object tool; otherwise the view.";

std::vector<Command> map_view_commands() {
  return {
      {.id = "map/fit",
       .label = "World view",
       .help = "Shows the whole map, or goes back to where you were.",
       .key = KeyChord{kKeyTab},
       .menu = menus::kViewZoom,
       .run = [](S, A, U ui) { ui.ask(request::FitMap{}); }},
      {.id = "map/left",
       .label = "Left",
       .help = kArrowHelp,
       .key = KeyChord{kKeyLeft},
       .run = move_or_scroll(-1, 0),
       .repeats = true},
      {.id = "map/right",
       .label = "Right",
       .help = kArrowHelp,
       .key = KeyChord{kKeyRight},
       .run = move_or_scroll(1, 0),
       .repeats = true},
      {.id = "map/up",
       .label = "Up",
       .help = kArrowHelp,
       .key = KeyChord{kKeyUp},
       .run = move_or_scroll(0, -1),
       .repeats = true},
      {.id = "map/down",
       .label = "Down",
       .help = kArrowHelp,
       .key = KeyChord{kKeyDown},
       .run = move_or_scroll(0, 1),
       .repeats = true},
  };
}

}  // namespace

std::vector<Command> map_commands() {
  return in_scope(Scope::map, joined({map_tool_commands(), selection_commands(), whole_map_commands(),
                                      map_view_commands()}));
}

}  // namespace talus
