// The commands of brushes, random painting and the ground tool, and those for finding the way on large maps.
#include <algorithm>
#include <numeric>

#include "command_table.h"
#include "edit/auto_tile.h"
#include "edit/brush_tools.h"
#include "edit/stamp.h"
#include "formats/tilesets/displaced_tile.h"
#include "panels/canvas/ground_hint.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

void save_brush(S session, A actions, U ui) {
  const Level& level = session.level();
  const Choices& choices = session.choices();
  const Stamp stamp = choices.selection ? stamp_of_map(level, *choices.selection) : choices.stamp;
  ui.ask(request::ShowTab(panel_id::kBrushes));
  emit_edit(actions, add_brush(level, brush_of_stamp(stamp, free_brush_name(level), choices.random_stamp)));
}

void toggle_random(S session, A actions, U) {
  actions.push_back(action::SetRandomStamp{!session.choices().random_stamp, session.choices().random_seed});
}

void shuffle(S session, A actions, U) {
  actions.push_back(action::SetRandomStamp{true, session.choices().random_seed + 1});
}

// Looks at the selected tiles if there are several, and at the whole sheet otherwise.
void propose_ground(S session, A actions, U ui) {
  std::vector<TileNumber> among;
  const SpriteArea& area = session.choices().area;
  if (area.sheet == SheetId::tiles && area.tiles.w * area.tiles.h > 1) {
    for (const MapCell cell :
         stamp_of_tiles(ui.layout(SheetId::tiles), area.tiles, displaced_tile(session.level())).tiles)
      among.push_back(cell.tile);
  } else {
    among.resize(static_cast<std::size_t>(session.level().tile_count()));
    std::iota(among.begin(), among.end(), TileNumber{0});
  }
  ui.ask(request::ShowTab(panel_id::kBrushes));
  if (proposed_auto_tiles(session.level(), among).empty()) {
    actions.push_back(action::ShowMessage{
        "None of these tiles is solid: give one the solid flag, so that it can be the inside of the ground.",
        true});
    return;
  }
  emit_edit(actions, propose_auto_tiles(session.level(), among));
}

void clear_ground(S session, A actions, U) {
  actions.push_back(action::EditLevel{set_auto_tiles(session.level(), {})});
}

}  // namespace

std::vector<Command> brush_commands() {
  return in_scope(
      Scope::map,
      {
          {.id = "map/ground",
           .label = "Ground",
           .help = "Paints ground: each cell gets the tile that fits its neighbours. With Ctrl it removes "
                   "ground, with Shift it fills a rectangle. Choose the ground's tiles under Brushes.",
           .key = KeyChord{'g'},
           .menu = menus::kMapTools,
           .icon = Icon::ground,
           .run = choose_map_tool(MapTool::ground),
           .checked = is_map_tool(MapTool::ground)},
          {.id = "map/random",
           .label = "Tiles at random",
           .help = "The stamp and the rectangle put one tile of the stamp, taken at random, into each cell.",
           .key = KeyChord{'d'},
           .menu = menus::kMapBrushes,
           .icon = Icon::dice,
           .run = toggle_random,
           .checked = [](S session, const Ui&) { return session.choices().random_stamp; }},
          {.id = "map/shuffle",
           .label = "Other tiles at random",
           .help = "Chooses other random tiles for what is painted from now on.",
           .key = shift('d'),
           .menu = menus::kMapBrushes,
           .run = shuffle},
          {.id = "brushes/add",
           .label = "Save as a brush",
           .help = "Keeps the stamp, or the selected tiles of the map, in the level, under a name.",
           .key = shift('b'),
           .menu = menus::kMapBrushes,
           .run = save_brush},
          {.id = "ground/propose",
           .label = "Propose tiles for ground",
           .help = "Chooses the ground's tiles by their shapes and pixels, among the selected tiles, or "
                   "among all tiles of the sheet if only one is selected.",
           .key = shift('g'),
           .menu = menus::kMapBrushes,
           .run = propose_ground},
          {.id = "ground/clear",
           .label = "Clear the tiles for ground",
           .help = "Removes all tiles from the set for ground.",
           .run = clear_ground,
           .enabled = [](S session, const Ui&) { return !session.level().auto_tiles.empty(); }},
          {.id = "map/minimap",
           .label = "Minimap",
           .help = "Shows the whole map in a corner of the map; a click or a drag there moves the view.",
           .key = KeyChord{'o'},
           .menu = menus::kViewZoom,
           .icon = Icon::minimap,
           .run = toggle<&View::canvas, &CanvasesView::minimap>,
           .checked = is_on<&View::canvas, &CanvasesView::minimap>},
      });
}

}  // namespace talus
