// The commands of the sprites and of the map.
#include <algorithm>

#include "command_table.h"
#include "edit/shape_tools.h"
#include "edit/spawn_tools.h"
#include "spawn_gesture.h"

namespace talus {
namespace {

constexpr double kSegmentReach = 4;  // px, from the mouse to the segment that Delete takes away

using S = const Session&;
using A = Actions&;
using U = Ui&;

template <MapTool tool>
void choose_map_tool(S, A actions, U) {
  actions.push_back(action::SetMapTool{tool});
}

template <MapTool tool>
bool is_map_tool(S session, const Ui&) {
  return session.choices().map_tool == tool;
}

template <MapTool tool>
Command map_tool(std::string_view id, KeyChord key, std::string_view label, std::string_view help) {
  return toggle(id, key, label, help, choose_map_tool<tool>, is_map_tool<tool>);
}

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
  if (session.choices().map_tool == MapTool::body) {
    const int chosen = chosen_spawn(session);
    if (chosen >= 0) edit(actions, remove_spawn(session.level(), chosen));
    return;
  }
  if (session.choices().map_tool == MapTool::segment) {
    if (const auto at = ui.view.hover.pixel)
      edit(actions, remove_segment(session.level(), *at, kSegmentReach));
    return;
  }
  const Stamp& stamp = session.choices().stamp;
  if (const auto cell = ui.view.hover.cell)
    edit(actions, erase_cells(session.level(), {cell->x, cell->y, stamp.w, stamp.h}));
}

std::vector<Command> pixel_commands() {
  return in_scope(
      Scope::sprites,
      {
          sprite_tool<SpriteTool::pencil>("pixels/pencil", KeyChord{'1'}, "Pencil",
                                          "Draws pixels; the right button draws the other colour."),
          sprite_tool<SpriteTool::pick>("pixels/pick", KeyChord{'2'}, "Pick colour",
                                        "Takes the colour under the mouse; so does the middle button."),
          sprite_tool<SpriteTool::fill>("pixels/fill", KeyChord{'4'}, "Fill",
                                        "Fills an area of one colour; with Ctrl, that colour everywhere."),
          command("pixels/flip_h", KeyChord{'5'}, "Flip left and right",
                  "Mirrors the selected tiles, left to right.", edit_area<flip_horizontal>),
          command("pixels/flip_v", KeyChord{'6'}, "Flip up and down",
                  "Mirrors the selected tiles, top to bottom.", edit_area<flip_vertical>),
          command("pixels/rotate", KeyChord{'7'}, "Rotate",
                  "Turns the selected tiles by a quarter, clockwise.", edit_area<rotate_clockwise>,
                  area_is_square),
          also_on(KeyChord{kKeyDelete},
                  command("pixels/clear", KeyChord{'8'}, "Clear",
                          "Fills the selected tiles with the right button's colour.", clear_sprite)),
      });
}

std::vector<Command> sheet_commands() {
  return in_scope(Scope::sprites,
                  {
                      repeating(command("palette/previous", KeyChord{'['}, "Previous colour",
                                        "The left button's colour, one back.", cycle_color<-1, false>)),
                      repeating(command("palette/next", KeyChord{']'}, "Next colour",
                                        "The left button's colour, one on.", cycle_color<1, false>)),
                      repeating(command("palette/previous_right", shift('['), "Previous right colour",
                                        "The right button's colour, one back.", cycle_color<-1, true>)),
                      repeating(command("palette/next_right", shift(']'), "Next right colour",
                                        "The right button's colour, one on.", cycle_color<1, true>)),
                      command("sheet/switch", KeyChord{kKeyTab}, "Tiles or sprites",
                              "Switches between the two sheets.", switch_sheet),
                      repeating(command("sheet/left", KeyChord{kKeyLeft}, "Tile to the left",
                                        "Moves the selection.", move_sheet_cursor<-1, 0>)),
                      repeating(command("sheet/right", KeyChord{kKeyRight}, "Tile to the right",
                                        "Moves the selection.", move_sheet_cursor<1, 0>)),
                      repeating(command("sheet/up", KeyChord{kKeyUp}, "Tile above", "Moves the selection.",
                                        move_sheet_cursor<0, -1>)),
                      repeating(command("sheet/down", KeyChord{kKeyDown}, "Tile below",
                                        "Moves the selection.", move_sheet_cursor<0, 1>)),
                  });
}

std::vector<Command> map_commands() {
  return in_scope(
      Scope::map,
      {
          map_tool<MapTool::stamp>("map/stamp", KeyChord{'1'}, "Stamp", "Paints the selected tiles."),
          map_tool<MapTool::pan>(
              "map/pan", KeyChord{'2'}, "Move the view",
              "Drags the view; so do the middle and the right button, and Space where it is no player's."),
          map_tool<MapTool::rectangle>("map/rectangle", KeyChord{'3'}, "Rectangle",
                                       "Fills a dragged rectangle with the selected tiles."),
          map_tool<MapTool::fill>("map/fill", KeyChord{'4'}, "Fill", "Fills an area of equal tiles."),
          map_tool<MapTool::erase>("map/erase", KeyChord{'5'}, "Erase", "Paints tile 0."),
          map_tool<MapTool::pick>("map/pick", KeyChord{'6'}, "Pick tiles",
                                  "Takes the tiles of a dragged rectangle as the stamp."),
          map_tool<MapTool::body>(
              "map/body", KeyChord{'7'}, "Place bodies",
              "Places a ball or a player, as the inspector says, or moves one that is there."),
          map_tool<MapTool::slope>(
              "map/slope", KeyChord{'8'}, "Lay a slope",
              "Drag a line: the selected slope tiles are laid along it, or, without any, new ones drawn."),
          map_tool<MapTool::segment>(
              "map/segment", KeyChord{'9'}, "Add a segment",
              "Drag a line: it stops bodies on its left, so to the right it is a floor, to the left a "
              "ceiling. For the exact solver."),
          repeating(
              command("map/delete", KeyChord{kKeyDelete}, "Erase at the mouse",
                      "Paints tile 0 under the mouse, as large as the stamp; with the body tool, "
                      "removes the chosen body, and with the segment tool, the segment under the mouse.",
                      erase_hovered)),
          command("map/fit", KeyChord{kKeyTab}, "World view",
                  "Shows the whole map, or goes back to where you were.",
                  [](S, A, U ui) { ui.view.fit_map = true; }),
          repeating(
              command("map/left", KeyChord{kKeyLeft}, "Scroll left", "Moves the view.", scroll_map<-1, 0>)),
          repeating(
              command("map/right", KeyChord{kKeyRight}, "Scroll right", "Moves the view.", scroll_map<1, 0>)),
          repeating(command("map/up", KeyChord{kKeyUp}, "Scroll up", "Moves the view.", scroll_map<0, -1>)),
          repeating(
              command("map/down", KeyChord{kKeyDown}, "Scroll down", "Moves the view.", scroll_map<0, 1>)),
      });
}

}  // namespace

std::vector<Command> tool_commands() { return joined({pixel_commands(), sheet_commands(), map_commands()}); }

}  // namespace talus
