// The panel of a tile's shape.
#include "shape_panel.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "edit/shape_tools.h"
#include "panels/commands/commands.h"
#include "shape_editor.h"

namespace talus {
namespace {

constexpr float kLeastCanvas = 104, kMostCanvas = 260;  // px at scale 1, height
constexpr float kBelowCanvas = 140;                     // px at scale 1, what is drawn there
constexpr std::array<std::string_view, 4> kTurns = {"as it is", "mirrored", "upside down",
                                                    "turned by 180 degrees"};

// Where the shape comes from, and what can be done with its picture.
std::string origin_text(const Level& level, int tile) {
  const TileShape shape = shape_of_tile(level, static_cast<TileNumber>(tile));
  const std::string number = "Tile " + std::to_string(tile);
  if (const auto left = tile_reaching_over(level, tile))
    return number + " has no shape of its own: that of tile " + std::to_string(*left) +
           ", which is shown, reaches over it.";
  if (shape.kind == TileShape::Kind::none) return number + " has no shape: bodies pass through it.";
  std::string text = number + " has no shape of its own; its flags make it this.";
  if (level.tile_shapes[static_cast<std::size_t>(tile)].kind != TileShape::Kind::none)
    text = number + " has this shape of its own.";
  if (shape.kind == TileShape::Kind::slope) text += " Drag its line or handles, with Alt by half pixels.";
  if (shape.kind == TileShape::Kind::profile)
    text += " Drag its handles, or draw beside them, with Alt by half pixels.";
  return text;
}

// "tile 1", "tiles 1, 2"
std::string tiles_text(const std::vector<int>& tiles) {
  std::string text = tiles.size() == 1 ? "tile " : "tiles ";
  for (std::size_t i = 0; i < tiles.size(); ++i) text += (i > 0 ? ", " : "") + std::to_string(tiles[i]);
  return text;
}

}  // namespace

void ShapePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  if (area.sheet != SheetId::tiles) {
    ui.hint("Sprites are not ground: choose a tile on the sheet, and give it a shape here.");
    return;
  }
  const int tile = area.tile_at(session.level(), 0, 0);
  ImGui::BeginChild("shape");
  draw_kind(session, actions, ui, tile);
  ui.same_line_if_fits(ui.px(196));
  command_text_button("shape/suggest"_command, session, actions, ui);
  // Parts whose height the shape changes are below the canvas, which must not move under a held mouse.
  draw_canvas(session, actions, ui, tile);
  ui.hint(origin_text(session.level(), tile));
  if (const int count = area.tiles.w * area.tiles.h; count > 1)
    ui.hint("What changes here changes in all " + std::to_string(count) + " selected tiles.");
  if (tile_reaching_over(session.level(), tile))
    command_text_button("shape/owner"_command, session, actions, ui);
  draw_fields(session, actions, ui, tile);
  command_text_button("shape/give"_command, session, actions, ui);
  draw_copy(session, actions, ui, tile);
  ImGui::EndChild();
}

void ShapePanel::draw_kind(const Session& session, Actions& actions, Ui& ui, int tile) const {
  const Level& level = session.level();
  const TileShape& own = level.tile_shapes[static_cast<std::size_t>(tile)];
  const TileShape shape = shape_of_tile(level, static_cast<TileNumber>(tile));
  std::string shown(kind_label(shape));
  if (own.kind != shape.kind) shown += " by its flags";
  // Its first own shape is as similar as possible to that of its flags.
  if (const auto kind = choose_shape_kind("shape/kind", own.kind, shown, ui))
    actions.push_back(action::EditLevel{change_kinds(level, session.choices().area, *kind)});
}

void ShapePanel::draw_fields(const Session& session, Actions& actions, Ui& ui, int tile) {
  const TileShape now = shape_of_tile(session.level(), static_cast<TileNumber>(tile));
  if (const auto shape = draw_shape_fields("shape/kind", now, session, field_, actions, ui))
    actions.push_back(
        action::EditLevel{change_shapes(session.level(), session.choices().area, *shape), field_.stroke});
}

void ShapePanel::draw_canvas(const Session& session, Actions& actions, Ui& ui, int tile) {
  // As wide as beside a scroll bar, which may come and go.
  const ImVec2 room{ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize,
                    ImGui::GetContentRegionAvail().y};
  const float height = std::clamp(room.y - ui.px(kBelowCanvas), ui.px(kLeastCanvas), ui.px(kMostCanvas));
  const int shown = tile_reaching_over(session.level(), tile).value_or(tile);
  const TileShape shape = shape_of_tile(session.level(), static_cast<TileNumber>(shown));
  const auto dragged = canvas_.draw(session, actions, shown, shape, {room.x, height}, ui);
  if (!dragged) return;
  actions.push_back(action::EditLevel{shown == tile
                                          ? change_shapes(session.level(), session.choices().area, *dragged)
                                          : set_tile_shape(session.level(), shown, *dragged),
                                      canvas_.stroke()});
}

void ShapePanel::draw_copy(const Session& session, Actions& actions, Ui& ui, int tile) {
  const Level& level = session.level();
  const bool has_shape = shape_of_tile(level, static_cast<TileNumber>(tile)).kind != TileShape::Kind::none;
  if (!has_shape) return;
  if (target_for_ != tile) target_ = -1;
  target_for_ = tile;
  const int target = target_ >= 0 ? target_ : free_target(level, tile, turn_).value_or(tile);
  ui.begin_row();
  ui.label("Copy");
  ImGui::SameLine();
  draw_turn_choice(ui);
  ImGui::SameLine();
  ui.label("to tile");
  ImGui::SameLine();
  draw_target(session, actions, ui, target);
  const std::vector<int> replaced = tiles_replaced(level, tile, target, turn_);
  ui.same_line_if_fits(ui.px(64));
  if (ui.text_button("shape/copy", replaced.empty() ? "Copy" : "Replace", false,
                     "Copies the pixels and the shape of the tile, and of all tiles that it reaches over.")) {
    auto edit = copy_turned(level, tile, target, turn_);
    if (edit) {
      actions.push_back(action::EditLevel{*std::move(edit)});
      target_ = -1;
    } else {
      actions.push_back(action::ShowMessage{"Not copied: " + edit.error() + ".", true});
    }
  }
  ui.end_row();
  if (target == tile)
    ui.hint("Turns tile " + std::to_string(tile) + " itself.");
  else if (!replaced.empty())
    ui.hint("Replaces the pixels and shape of " + tiles_text(replaced) + ".");
}

void ShapePanel::draw_target(const Session& session, Actions& actions, Ui& ui, int target) {
  int number = target;
  ImGui::SetNextItemWidth(ui.px(44));
  if (ImGui::InputInt("##target", &number, 0)) typed_ = number;
  const bool is_typed = ImGui::IsItemDeactivatedAfterEdit();
  ui.item("shape/target", "The number of the tile that gets it; at first the next one that is blank.");
  if (!is_typed) return;
  if (typed_ >= 0 && typed_ < session.level().tile_count())
    target_ = typed_;
  else
    actions.push_back(action::ShowMessage{"There is no tile " + std::to_string(typed_) +
                                              ": tiles have the numbers 0 to " +
                                              std::to_string(session.level().tile_count() - 1) + ".",
                                          true});
}

void ShapePanel::draw_turn_choice(Ui& ui) {
  if (!ui.begin_combo("shape/turn", std::string(kTurns[static_cast<std::size_t>(turn_)]), ui.px(112),
                      "How the copy is turned; a floor upside down is a ceiling."))
    return;
  for (std::size_t i = 0; i < kTurns.size(); ++i) {
    const auto turn = static_cast<ShapeTurn>(i);
    if (selectable(kTurns[i], {}, turn == turn_)) turn_ = turn;
    ui.item("shape/turn" + std::to_string(i));
  }
  ImGui::EndCombo();
}

}  // namespace talus
