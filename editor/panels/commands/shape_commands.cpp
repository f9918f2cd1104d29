// The commands of the tiles' shapes.
#include "command_table.h"
#include "edit/tile_shapes.h"

namespace talus {
namespace {

bool has_tiles(const Session& session, const Ui&) { return session.choices().area.sheet == SheetId::tiles; }

bool has_many_tiles(const Session& session, const Ui& ui) {
  const CellRect& tiles = session.choices().area.tiles;
  return has_tiles(session, ui) && tiles.w * tiles.h > 1;
}

// A single tile with a wide shape gets a new shape of the same width. Of several tiles, each gets its own
// shape.
void suggest(const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const SpriteArea& area = session.choices().area;
  const int tile = area.tile_at(session.level(), 0, 0);
  const int width = shape_of_tile(level, static_cast<TileNumber>(tile)).tiles;
  Edit edit = suggest_shapes(level, area);
  bool found = !edit.empty();
  if (!has_many_tiles(session, ui)) {
    const auto shape = suggest_shape(level, tile, width);
    found = shape.has_value();
    if (shape) edit = give_shape(level, area, *shape);
    edit.label = "Suggest a shape from pixels";
  }
  if (!edit.empty()) return actions.push_back(action::EditLevel{std::move(edit)});
  const bool in_true_colour = level.sheet(SheetId::tiles).picture != nullptr;
  actions.push_back(action::ShowMessage{
      found            ? "The tile already has the shape that its pixels suggest."
      : in_true_colour ? "Nothing to suggest: no pixel of the tile is more opaque than clear."
                       : "Nothing to suggest: all pixels of the tile have colour 0.",
      false});
}

std::optional<int> owner(const Session& session) {
  return tile_reaching_over(session.level(), session.choices().area.tile_at(session.level(), 0, 0));
}

bool has_owner(const Session& session, const Ui& ui) { return has_tiles(session, ui) && owner(session); }

void go_to_owner(const Session& session, Actions& actions, Ui& ui) {
  actions.push_back(action::SelectTiles{{SheetId::tiles, ui.place_on_sheet(*owner(session))}});
}

void give(const Session& session, Actions& actions, Ui&) {
  const SpriteArea& area = session.choices().area;
  const TileShape shape =
      shape_of_tile(session.level(), static_cast<TileNumber>(area.tile_at(session.level(), 0, 0)));
  emit_edit(actions, give_shape(session.level(), area, shape));
}

}  // namespace

std::vector<Command> shape_commands() {
  return {
      {.id = "shape/suggest",
       .label = "Suggest the shape from pixels",
       .help =
           "Proposes a shape from the pixels of each selected tile: those that are not colour 0, in true "
           "colour those that are more opaque than clear. What is one-way stays so. One undo takes it back.",
       .menu = menus::kEditShape,
       .run = suggest,
       .enabled = has_tiles},
      {.id = "shape/give",
       .label = "Give the shape to all selected",
       .help = "Gives the shape of the first selected tile to all selected ones.",
       .menu = menus::kEditShape,
       .run = give,
       .enabled = has_many_tiles},
      {.id = "shape/owner",
       .label = "Go to the tile whose shape reaches over this one",
       .help = "Selects it: a ramp's shape is that of its left tile.",
       .run = go_to_owner,
       .enabled = has_owner,
       .words = "ramp half part owner"},
  };
}

}  // namespace talus
