// The table of commands.
#include "commands.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

template <class T>
void emit(S, A actions, U) {
  actions.push_back(T{});
}

template <MapTool tool>
void choose_map_tool(S, A actions, U) {
  actions.push_back(action::SetMapTool{tool});
}
template <MapTool tool>
bool is_map_tool(S session, const Ui&) {
  return session.choices().map_tool == tool;
}

template <SpriteTool tool>
void choose_sprite_tool(S, A actions, U) {
  actions.push_back(action::SetSpriteTool{tool});
}
template <SpriteTool tool>
bool is_sprite_tool(S session, const Ui&) {
  return session.choices().sprite_tool == tool;
}

template <CanvasMode mode>
void show_canvas(S, A, U ui) {
  ui.view.canvas = mode;
}
template <CanvasMode mode>
bool shows_canvas(S, const Ui& ui) {
  return ui.view.canvas == mode;
}

template <OverlayId id>
void toggle_overlay(S session, A actions, U) {
  actions.push_back(action::SetOverlay{id, !session.choices().overlays.has(id)});
}
template <OverlayId id>
bool has_overlay(S session, const Ui&) {
  return session.choices().overlays.has(id);
}

void edit(A actions, Edit edit) {
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit)});
}
template <Edit (*tool)(const Level&, const SpriteArea&)>
void edit_area(S session, A actions, U) {
  edit(actions, tool(session.level(), session.choices().area));
}
void clear_sprite(S session, A actions, U) {
  edit(actions, clear_area(session.level(), session.choices().area,
                           static_cast<std::uint8_t>(session.choices().secondary_color)));
}
bool area_is_square(S session, const Ui&) {
  return session.choices().area.tiles.w == session.choices().area.tiles.h;
}

template <int step, bool secondary>
void cycle_color(S session, A actions, U ui) {
  const int now = secondary ? session.choices().secondary_color : session.choices().color;
  ui.view.palette_color = (now + step + kColorCount) % kColorCount;
  actions.push_back(action::SetColor{ui.view.palette_color, secondary});
}

template <int dx, int dy>
void move_sheet_cursor(S session, A actions, U) {
  SpriteArea area = session.choices().area;
  area.tiles.x = std::clamp(area.tiles.x + dx, 0, kSheetColumns - area.tiles.w);
  area.tiles.y = std::clamp(area.tiles.y + dy, 0, kSheetColumns - area.tiles.h);
  actions.push_back(action::SelectTiles{area});
}
void switch_sheet(S session, A actions, U) {
  SpriteArea area = session.choices().area;
  area.sheet = area.sheet == SheetId::tiles ? SheetId::sprites : SheetId::tiles;
  actions.push_back(action::SelectTiles{area});
}

template <int dx, int dy>
void scroll_map(S, A, U ui) {
  ui.view.scroll_by = ui.view.scroll_by + Vec2{dx * 64.0, dy * 64.0};
}
void erase_hovered(S session, A actions, U ui) {
  const Stamp& stamp = session.choices().stamp;
  if (const auto cell = ui.view.hover.cell)
    edit(actions, erase_cells(session.level(), {cell->x, cell->y, stamp.w, stamp.h}));
}

void cycle_flag_overlay(S session, A actions, U) {
  const int next = session.choices().flag_overlay.value_or(-1) + 1;
  actions.push_back(
      action::SetFlagOverlay{next < kFlagCount ? std::optional<int>(next) : std::optional<int>()});
}

template <int direction>
void change_speed(S session, A actions, U) {
  const double now = session.playback().speed;
  actions.push_back(action::SetSpeed{direction > 0 ? now * 2 : now / 2});
}
void run_from_start(S, A actions, U) {
  actions.push_back(action::ResetPlay{});
  actions.push_back(action::Play{});
}

std::vector<Command> file_commands() {
  return {
      {"file/new",
       "New level",
       "Starts an empty level.",
       Scope::everywhere,
       ctrl('n'),
       {},
       false,
       emit<action::NewLevel>},
      {"file/open",
       "Open...",
       "Opens a level or a TIC-80 cart.",
       Scope::everywhere,
       ctrl('o'),
       {},
       false,
       [](S, A, U ui) { ui.view.dialog = FileDialog::open; }},
      {"file/save",
       "Save",
       "Saves to the level's own file, in its own format.",
       Scope::everywhere,
       ctrl('s'),
       {},
       false,
       emit<action::SaveFile>},
      {"file/save_as",
       "Save as...",
       "Saves under another name; the ending chooses the format.",
       Scope::everywhere,
       ctrl_shift('s'),
       {},
       false,
       [](S, A, U ui) { ui.view.dialog = FileDialog::save_as; }},
      {"file/quit",
       "Quit",
       "Ends the program; unsaved changes are asked about.",
       Scope::everywhere,
       ctrl('q'),
       {},
       false,
       emit<action::Quit>},
      {"edit/undo",
       "Undo",
       "Takes back the last change; a stroke is one.",
       Scope::everywhere,
       ctrl('z'),
       {},
       true,
       emit<action::Undo>,
       [](S s, const Ui&) { return s.history().can_undo(); }},
      {"edit/redo", "Redo", "Makes again what Undo took back.", Scope::everywhere, ctrl('y'), ctrl_shift('z'),
       true, emit<action::Redo>, [](S s, const Ui&) { return s.history().can_redo(); }},
  };
}

std::vector<Command> view_commands() {
  return {
      {"view/sprites",
       "Sprites",
       "Gives the keys to the sheet and the pixels.",
       Scope::everywhere,
       {kKeyF2},
       {},
       false,
       [](S, A, U ui) { ui.view.focus = Focus::sprites; },
       nullptr,
       [](S, const Ui& ui) { return ui.view.focus == Focus::sprites; }},
      {"view/map",
       "Map",
       "Gives the keys to the map, and shows it.",
       Scope::everywhere,
       {kKeyF3},
       {},
       false,
       [](S, A, U ui) {
         ui.view.focus = Focus::map;
         if (ui.view.canvas == CanvasMode::play) ui.view.canvas = CanvasMode::map;
       },
       nullptr,
       [](S, const Ui& ui) { return ui.view.focus == Focus::map; }},
      {"canvas/map",
       "Show the map",
       "Shows the map alone.",
       Scope::everywhere,
       ctrl('1'),
       {},
       false,
       show_canvas<CanvasMode::map>,
       nullptr,
       shows_canvas<CanvasMode::map>},
      {"canvas/play",
       "Show the play view",
       "Shows the play view alone.",
       Scope::everywhere,
       ctrl('2'),
       {},
       false,
       show_canvas<CanvasMode::play>,
       nullptr,
       shows_canvas<CanvasMode::play>},
      {"canvas/both",
       "Show map and play view",
       "Shows the map above the play view.",
       Scope::everywhere,
       ctrl('3'),
       {},
       false,
       show_canvas<CanvasMode::both>,
       nullptr,
       shows_canvas<CanvasMode::both>},
      {"canvas/zoom_in",
       "Zoom in",
       "Zooms in; the wheel does it at the mouse.",
       Scope::everywhere,
       {'='},
       shift('='),
       true,
       [](S, A, U ui) { ++ui.view.zoom_by; }},
      {"canvas/zoom_out",
       "Zoom out",
       "Zooms out; the wheel does it at the mouse.",
       Scope::everywhere,
       {'-'},
       {},
       true,
       [](S, A, U ui) { --ui.view.zoom_by; }},
      {"canvas/grid",
       "Grid",
       "Shows the borders of the cells.",
       Scope::everywhere,
       {'`'},
       {},
       false,
       [](S s, A actions, U) { actions.push_back(action::SetGrid{!s.choices().grid}); },
       nullptr,
       [](S s, const Ui&) { return s.choices().grid; }},
      {"canvas/borders",
       "Screen borders",
       "Shows the borders of the screens, every 30 by 17 cells.",
       Scope::everywhere,
       {'b'},
       {},
       false,
       [](S s, A actions, U) { actions.push_back(action::SetScreenBorders{!s.choices().screen_borders}); },
       nullptr,
       [](S s, const Ui&) { return s.choices().screen_borders; }},
      {"canvas/flag_tint",
       "Next flag tint",
       "Tints the cells whose tile has a flag: the next flag, or none.",
       Scope::everywhere,
       {'f'},
       {},
       true,
       cycle_flag_overlay,
       nullptr,
       [](S s, const Ui&) { return s.choices().flag_overlay.has_value(); }},
      {"canvas/paint_in_play",
       "Paint in the play view",
       "The left button paints in the play view, instead of holding balls.",
       Scope::everywhere,
       {'p'},
       {},
       false,
       [](S, A, U ui) { ui.view.paint_in_play = !ui.view.paint_in_play; },
       nullptr,
       [](S, const Ui& ui) { return ui.view.paint_in_play; }},
      {"help/commands",
       "Find a command...",
       "Lists every command; type to find one.",
       Scope::everywhere,
       ctrl('p'),
       {},
       false,
       [](S, A, U ui) { ui.view.command_palette_open = true; }},
      {"help/keys",
       "Keys and mouse",
       "Shows every key.",
       Scope::everywhere,
       {kKeyF1},
       {},
       false,
       [](S, A, U ui) { ui.view.help_open = !ui.view.help_open; },
       nullptr,
       [](S, const Ui& ui) { return ui.view.help_open; }},
  };
}

std::vector<Command> play_commands() {
  return {
      {"play/toggle",
       "Play or pause",
       "Runs the simulation, or stops it where it is.",
       Scope::everywhere,
       {kKeyF5},
       {},
       false,
       emit<action::TogglePlay>,
       nullptr,
       [](S s, const Ui&) { return s.playback().running; }},
      {"play/step",
       "Step one frame",
       "Pauses and makes exactly one step.",
       Scope::everywhere,
       {kKeyF10},
       {},
       true,
       emit<action::StepFrame>},
      {"play/run",
       "Run from the start",
       "Goes back to frame 0 and runs.",
       Scope::everywhere,
       ctrl('r'),
       {},
       false,
       run_from_start},
      {"play/reset",
       "Back to frame 0",
       "Puts every body back where the level has it.",
       Scope::everywhere,
       {kKeyHome},
       {},
       false,
       emit<action::ResetPlay>},
      {"play/slower",
       "Slower",
       "Halves the speed, down to 1/8.",
       Scope::everywhere,
       {','},
       {},
       true,
       change_speed<-1>,
       [](S s, const Ui&) { return s.playback().speed > 0.125; }},
      {"play/faster",
       "Faster",
       "Doubles the speed, up to 8.",
       Scope::everywhere,
       {'.'},
       {},
       true,
       change_speed<1>,
       [](S s, const Ui&) { return s.playback().speed < 8; }},
      {"play/no_body",
       "Choose no body",
       "Empties the inspector.",
       Scope::everywhere,
       ctrl('d'),
       {},
       false,
       [](S, A actions, U) { actions.push_back(action::SelectBody{0}); },
       [](S s, const Ui&) { return s.choices().body != 0; }},
  };
}

template <OverlayId id>
Command overlay_command(std::string_view command_id) {
  const OverlayInfo& info = overlay_infos()[static_cast<std::size_t>(id)];
  const int digit = '1' + static_cast<int>(id);
  return {command_id, info.label, info.help,          Scope::everywhere, alt(digit),
          {},         false,      toggle_overlay<id>, nullptr,           has_overlay<id>};
}

std::vector<Command> overlay_commands() {
  return {
      overlay_command<OverlayId::boxes>("overlay/boxes"),
      overlay_command<OverlayId::normals>("overlay/normals"),
      overlay_command<OverlayId::touch_points>("overlay/touch_points"),
      overlay_command<OverlayId::velocity>("overlay/velocity"),
      overlay_command<OverlayId::slope_delta>("overlay/slope_delta"),
      overlay_command<OverlayId::floor_height>("overlay/floor_height"),
      overlay_command<OverlayId::tested_tiles>("overlay/tested_tiles"),
  };
}

std::vector<Command> sprite_commands() {
  constexpr Scope in = Scope::sprites;
  return {
      {"pixels/pencil",
       "Pencil",
       "Draws pixels; the right button draws the other colour.",
       in,
       {'1'},
       {},
       false,
       choose_sprite_tool<SpriteTool::pencil>,
       nullptr,
       is_sprite_tool<SpriteTool::pencil>},
      {"pixels/pick",
       "Pick colour",
       "Takes the colour under the mouse; so does the middle button.",
       in,
       {'2'},
       {},
       false,
       choose_sprite_tool<SpriteTool::pick>,
       nullptr,
       is_sprite_tool<SpriteTool::pick>},
      {"pixels/fill",
       "Fill",
       "Fills an area of one colour; with Ctrl, that colour everywhere.",
       in,
       {'4'},
       {},
       false,
       choose_sprite_tool<SpriteTool::fill>,
       nullptr,
       is_sprite_tool<SpriteTool::fill>},
      {"pixels/flip_h",
       "Flip left and right",
       "Mirrors the selected tiles, left to right.",
       in,
       {'5'},
       {},
       false,
       edit_area<flip_horizontal>},
      {"pixels/flip_v",
       "Flip up and down",
       "Mirrors the selected tiles, top to bottom.",
       in,
       {'6'},
       {},
       false,
       edit_area<flip_vertical>},
      {"pixels/rotate",
       "Rotate",
       "Turns the selected tiles by a quarter, clockwise.",
       in,
       {'7'},
       {},
       false,
       edit_area<rotate_clockwise>,
       area_is_square},
      {"pixels/clear",
       "Clear",
       "Fills the selected tiles with the right button's colour.",
       in,
       {'8'},
       {kKeyDelete},
       false,
       clear_sprite},
      {"palette/previous",
       "Previous colour",
       "The left button's colour, one back.",
       in,
       {'['},
       {},
       true,
       cycle_color<-1, false>},
      {"palette/next",
       "Next colour",
       "The left button's colour, one on.",
       in,
       {']'},
       {},
       true,
       cycle_color<1, false>},
      {"palette/previous_right",
       "Previous right colour",
       "The right button's colour, one back.",
       in,
       shift('['),
       {},
       true,
       cycle_color<-1, true>},
      {"palette/next_right",
       "Next right colour",
       "The right button's colour, one on.",
       in,
       shift(']'),
       {},
       true,
       cycle_color<1, true>},
      {"sheet/switch",
       "Tiles or sprites",
       "Switches between the two sheets.",
       in,
       {kKeyTab},
       {},
       false,
       switch_sheet},
      {"sheet/left",
       "Tile to the left",
       "Moves the selection.",
       in,
       {kKeyLeft},
       {},
       true,
       move_sheet_cursor<-1, 0>},
      {"sheet/right",
       "Tile to the right",
       "Moves the selection.",
       in,
       {kKeyRight},
       {},
       true,
       move_sheet_cursor<1, 0>},
      {"sheet/up", "Tile above", "Moves the selection.", in, {kKeyUp}, {}, true, move_sheet_cursor<0, -1>},
      {"sheet/down", "Tile below", "Moves the selection.", in, {kKeyDown}, {}, true, move_sheet_cursor<0, 1>},
  };
}

std::vector<Command> map_commands() {
  constexpr Scope in = Scope::map;
  return {
      {"map/stamp",
       "Stamp",
       "Paints the selected tiles.",
       in,
       {'1'},
       {},
       false,
       choose_map_tool<MapTool::stamp>,
       nullptr,
       is_map_tool<MapTool::stamp>},
      {"map/pan",
       "Move the view",
       "Drags the view; so do the middle and the right button, and Space.",
       in,
       {'2'},
       {},
       false,
       choose_map_tool<MapTool::pan>,
       nullptr,
       is_map_tool<MapTool::pan>},
      {"map/rectangle",
       "Rectangle",
       "Fills a dragged rectangle with the selected tiles.",
       in,
       {'3'},
       {},
       false,
       choose_map_tool<MapTool::rectangle>,
       nullptr,
       is_map_tool<MapTool::rectangle>},
      {"map/fill",
       "Fill",
       "Fills an area of equal tiles.",
       in,
       {'4'},
       {},
       false,
       choose_map_tool<MapTool::fill>,
       nullptr,
       is_map_tool<MapTool::fill>},
      {"map/erase",
       "Erase",
       "Paints tile 0.",
       in,
       {'5'},
       {},
       false,
       choose_map_tool<MapTool::erase>,
       nullptr,
       is_map_tool<MapTool::erase>},
      {"map/pick",
       "Pick tiles",
       "Takes the tiles of a dragged rectangle as the stamp.",
       in,
       {'6'},
       {},
       false,
       choose_map_tool<MapTool::pick>,
       nullptr,
       is_map_tool<MapTool::pick>},
      {"map/delete",
       "Erase at the mouse",
       "Paints tile 0 under the mouse, as large as the stamp.",
       in,
       {kKeyDelete},
       {},
       true,
       erase_hovered},
      {"map/fit",
       "World view",
       "Shows the whole map, or goes back to where you were.",
       in,
       {kKeyTab},
       {},
       false,
       [](S, A, U ui) { ui.view.fit_map = true; }},
      {"map/left", "Scroll left", "Moves the view.", in, {kKeyLeft}, {}, true, scroll_map<-1, 0>},
      {"map/right", "Scroll right", "Moves the view.", in, {kKeyRight}, {}, true, scroll_map<1, 0>},
      {"map/up", "Scroll up", "Moves the view.", in, {kKeyUp}, {}, true, scroll_map<0, -1>},
      {"map/down", "Scroll down", "Moves the view.", in, {kKeyDown}, {}, true, scroll_map<0, 1>},
  };
}

std::vector<Command> make_commands() {
  std::vector<Command> all;
  for (auto part :
       {file_commands, view_commands, play_commands, overlay_commands, sprite_commands, map_commands})
    for (Command& command : part()) all.push_back(command);
  return all;
}

bool scope_has_focus(Scope scope, const View& view) {
  return scope == Scope::everywhere || (scope == Scope::sprites) == (view.focus == Focus::sprites);
}

}  // namespace

std::span<const Command> commands() {
  static const std::vector<Command> all = make_commands();
  return all;
}

const Command& find_command(std::string_view id) {
  const auto all = commands();
  const auto it = std::find_if(all.begin(), all.end(), [&](const Command& c) { return c.id == id; });
  assert(it != all.end());
  return *it;
}

std::string keys_of(const Command& command) {
  std::string keys = to_string(command.key);
  if (command.other_key) keys += ", " + to_string(command.other_key);
  return keys;
}

std::string_view scope_label(Scope scope) {
  switch (scope) {
    case Scope::sprites:
      return "In the sprites (F2)";
    case Scope::map:
      return "In the map (F3)";
    default:
      return "Everywhere";
  }
}

bool run_key(KeyChord chord, bool repeated, const Session& session, Actions& actions, Ui& ui) {
  for (const Command& command : commands()) {
    if (chord != command.key && chord != command.other_key) continue;
    if (!scope_has_focus(command.scope, ui.view)) continue;
    if ((!repeated || command.repeats) && command.is_enabled(session, ui)) command.run(session, actions, ui);
    return true;
  }
  return false;
}

void command_button(std::string_view widget, std::string_view id, Icon icon, const Session& session,
                    Actions& actions, Ui& ui) {
  const Command& command = find_command(id);
  if (ui.icon_button(widget, icon, command.is_checked(session, ui), command.help, keys_of(command),
                     command.is_enabled(session, ui)))
    command.run(session, actions, ui);
}

}  // namespace talus
