// The panel of a tile's shape.
#include "shape_panel.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "edit/shape_tools.h"
#include "panels/commands/commands.h"
#include "shape_editor.h"

namespace talus {
namespace {

constexpr float kLeastCanvas = 104, kMaxCanvas = 260;  // px at scale 1, height
constexpr float kBelowCanvas = 140;                    // px at scale 1, what is drawn there
// The same for polygons; what is below may scroll.
constexpr float kLeastPolygonCanvas = 224, kMaxPolygonCanvas = 420;
constexpr float kSuggestWidth = 196;               // px at scale 1, of a button
constexpr float kAddWidth = 96, kPartWidth = 132;  // px at scale 1, of lists
constexpr std::array<std::string_view, 4> kTurns = {"as it is", "mirrored", "upside down",
                                                    "turned by 180 degrees"};

// What the mouse does on the canvas.
std::string mouse_text(const EditedShape& edited) {
  if (edited.is_drawing)
    return "Click the points of a polygon, and the first one again (or press Enter) to close it. A right "
           "click "
           "takes the last one back, Esc ends.";
  switch (edited.shape().kind) {
    case TileShape::Kind::slope:
      return "Drag its line or handles, with Alt by half pixels.";
    case TileShape::Kind::profile:
      return "Drag its handles, or draw beside them, with Alt by half pixels.";
    case TileShape::Kind::polygon:
      return "Drag points, or the inside to move all. A click on a side inserts a point, a right click "
             "removes "
             "one. With Alt, points do not snap.";
    default:
      return "";
  }
}

// Where the shape comes from, and what can be done with its picture.
std::string origin_text(const Level& level, const EditedShape& edited) {
  const std::string number = "Tile " + std::to_string(edited.tile), mouse = mouse_text(edited);
  if (edited.is_drawing) return mouse;
  if (const auto left = tile_reaching_over(level, edited.tile))
    return number + " has no shape of its own: that of tile " + std::to_string(*left) +
           ", which is shown, reaches over it.";
  if (edited.shape().kind == TileShape::Kind::none) return number + " has no shape: bodies pass through it.";
  std::string text = number + " has no shape of its own; its flags make it this.";
  if (level.tile_shapes[static_cast<std::size_t>(edited.tile)].kind != TileShape::Kind::none)
    text = number + " has this shape of its own.";
  return mouse.empty() ? text : text + " " + mouse;
}

std::string part_text(const TileShape& shape, std::size_t part) {
  return std::to_string(part + 1) + " of " + std::to_string(part_count(shape)) + ": " +
         std::string(kind_label(part_at(shape, part)));
}

constexpr std::array<CommandId, kPointSnapCount> kSnaps = {
    "shape/snap_corners"_command, "shape/snap_halves"_command, "shape/snap_pixels"_command,
    "shape/snap_free"_command};
constexpr std::array<std::string_view, kPointSnapCount> kSnapLabels = {"grid", "half", "px", "free"};

void draw_area_hint(const Session& session, const EditedShape& edited, Ui& ui) {
  const CellRect& tiles = session.choices().area.tiles;
  const int count = tiles.w * tiles.h;
  if (count > 1)
    ui.hint("What changes here changes in all " + std::to_string(count) + " selected tiles" +
            (is_open(edited) ? " that have the same shape." : "."));
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
  follow_tile(session, ui);
  draw_kind(session, actions, ui);
  if (!is_open(edited_shape(session, ui.view))) {
    ui.same_line_if_fits(ui.px(kSuggestWidth));
    command_text_button("shape/suggest"_command, session, actions, ui);
  }
  draw_polygon_tools(session, actions, ui);
  draw_parts(session, actions, ui);
  // Parts whose height the shape changes are below the canvas, which must not move under a held mouse.
  draw_canvas(session, actions, ui, tile);
  if (is_open(edited_shape(session, ui.view)))
    draw_below_polygon(session, actions, ui);
  else
    draw_below_line(session, actions, ui);
  draw_copy(session, actions, ui, tile);
  ImGui::EndChild();
}

void ShapePanel::draw_below_line(const Session& session, Actions& actions, Ui& ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  ui.hint(origin_text(session.level(), edited));
  draw_area_hint(session, edited, ui);
  if (tile_reaching_over(session.level(), edited.tile))
    command_text_button("shape/owner"_command, session, actions, ui);
  draw_fields(session, actions, ui);
  draw_new_part(session, actions, ui);
  command_text_button("shape/give"_command, session, actions, ui);
}

// Its fields are near the canvas, as the chosen point is.
void ShapePanel::draw_below_polygon(const Session& session, Actions& actions, Ui& ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  if (edited.is_draft)
    draw_wrapped_text(draft_text(edited) + " Mend it, or go back with Esc.", theme::tone(theme::kError));
  draw_fields(session, actions, ui);
  draw_new_part(session, actions, ui);
  ui.hint(origin_text(session.level(), edited));
  if (edited.is_drawing) return;
  draw_area_hint(session, edited, ui);
  command_text_button("shape/give"_command, session, actions, ui);
  ui.same_line_if_fits(ui.px(kSuggestWidth));
  command_text_button("shape/suggest"_command, session, actions, ui);
}

void ShapePanel::follow_tile(const Session& session, Ui& ui) {
  ui.view.shape.last_frame = ImGui::GetFrameCount();
  const int tile = edited_shape(session, ui.view).tile;
  if (std::exchange(shown_, tile) == tile) return;
  ui.view.shape.part = 0;
  ui.view.shape.point.reset();
}

// The kind of the edited part. The first own shape is as similar as possible to that of its flags. Where
// there is nothing yet, a polygon is drawn.
void ShapePanel::draw_kind(const Session& session, Actions& actions, Ui& ui) const {
  const Level& level = session.level();
  const EditedShape edited = edited_shape(session, ui.view);
  const bool is_group = part_count(edited.whole) > 1;
  const TileShape& own = level.tile_shapes[static_cast<std::size_t>(edited.tile)];
  std::string shown(edited.is_drawing ? "polygon" : kind_label(edited.shape()));
  if (own.kind == TileShape::Kind::none && !edited.is_draft && part_count(edited.whole) > 0)
    shown += " by its flags";
  const TileShape::Kind now = own.kind == TileShape::Kind::none ? own.kind : edited.shape().kind;
  const auto kind = choose_shape_kind("shape/kind", now, shown, ui);
  if (!kind) return;
  ui.view.shape.point.reset();
  ui.view.shape.drawing.reset();
  if (*kind == TileShape::Kind::polygon && part_count(edited.whole) == 0)
    begin_drawing(session, ui.view);
  else if (is_group || edited.is_draft)
    put_part(session, actions, ui.view, with_kind(edited.shape(), *kind, edited.size));
  else
    actions.push_back(action::EditLevel{change_kinds(level, session.choices().area, *kind)});
}

// Above the canvas, which must not move under a held mouse: they stay while parts are chosen and changed.
void ShapePanel::draw_polygon_tools(const Session& session, Actions& actions, Ui& ui) const {
  const EditedShape edited = edited_shape(session, ui.view);
  if (!is_open(edited)) return;
  ui.begin_row();
  for (const CommandId id : {"shape/draw"_command, "shape/mirror_h"_command, "shape/mirror_v"_command}) {
    command_button(id, session, actions, ui);
    ImGui::SameLine();
  }
  ui.label("Snap");
  for (std::size_t i = 0; i < kSnaps.size(); ++i) {
    ImGui::SameLine();
    command_text_button(kSnaps[i], session, actions, ui, {.label = kSnapLabels[i]});
  }
  ui.end_row();
}

void ShapePanel::draw_fields(const Session& session, Actions& actions, Ui& ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  if (edited.is_drawing) return command_text_button("shape/close"_command, session, actions, ui);
  if (edited.is_polygon()) draw_point(session, actions, ui);
  TileShape part = edited.shape();
  part.conveyor = edited.whole.conveyor;  // a group is one as a whole
  const auto changed = draw_shape_fields("shape/kind", part, session, field_, actions, ui);
  if (!changed) return;
  TileShape whole =
      part_count(edited.whole) > 0 ? with_part_at(edited.whole, edited.part, *changed) : *changed;
  whole.conveyor = changed->conveyor;
  put_shape(session, actions, ui.view, whole, field_.stroke);
}

void ShapePanel::draw_point(const Session& session, Actions& actions, Ui& ui) {
  const EditedShape edited = edited_shape(session, ui.view);
  const std::vector<Vec2>& points = edited.shape().points;
  ui.begin_row();
  if (!edited.point) {
    ui.label(std::to_string(points.size()) + " points, none chosen");
    return ui.end_row();
  }
  ui.label("Point " + std::to_string(*edited.point + 1) + " of " + std::to_string(points.size()));
  Vec2 place = points[*edited.point];
  bool is_dragged = false;  // as far as it goes
  const auto draw_number = [&](const NumberField& field, double& value) {
    ImGui::SameLine();
    if (!draw_number_field(field, value, session, field_, ui)) return false;
    is_dragged = ImGui::IsItemActive();
    return true;
  };
  bool changed =
      draw_number({"shape/point_x", "x %.8g", "Px from the tile's left side.", 60, 0.125f}, place.x);
  changed |= draw_number({"shape/point_y", "y %.8g", "Px below the tile's top.", 60, 0.125f}, place.y);
  ui.same_line_if_fits(ui.px(64));
  command_text_button("shape/delete_point"_command, session, actions, ui, {.label = "Remove"});
  ui.end_row();
  if (!changed) return;
  if (kept_near(place, edited.size) != place && !is_dragged)
    return actions.push_back(
        action::ShowMessage{"Not changed: a point must be at most 8 tiles away from its tile.", true});
  put_part(session, actions, ui.view, with_point_at(edited.shape(), *edited.point, place, edited.size),
           field_.stroke);
}

void ShapePanel::draw_parts(const Session& session, Actions& actions, Ui& ui) const {
  const EditedShape edited = edited_shape(session, ui.view);
  const std::size_t count = part_count(edited.whole);
  if (count < 2) return;
  ui.begin_row();
  ui.label("Part");
  ImGui::SameLine();
  if (ui.begin_combo("shape/part", part_text(edited.whole, edited.part), ui.px(kPartWidth),
                     "The part of the shape that is edited. A click on a part chooses it, too.",
                     keys_of("shape/next_part"_command, ui))) {
    for (std::size_t i = 0; i < count; ++i) {
      if (selectable(part_text(edited.whole, i), {}, i == edited.part)) {
        ui.view.shape.part = i;
        ui.view.shape.point.reset();
      }
      ui.item("shape/part" + std::to_string(i));
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  command_text_button("shape/remove_part"_command, session, actions, ui, {.label = "Remove"});
  ui.end_row();
}

void ShapePanel::draw_new_part(const Session& session, Actions& actions, Ui& ui) const {
  const EditedShape edited = edited_shape(session, ui.view);
  if (part_count(edited.whole) == 0 || edited.is_drawing) return;
  ui.same_line_if_fits(ui.px(kAddWidth));
  if (!ui.begin_combo("shape/add", "Add a part", ui.px(kAddWidth),
                      "Adds a polygon, a slope and so on to the shape. All parts are one ground.",
                      keys_of("shape/add_part"_command, ui)))
    return;
  for (const TileShape::Kind kind : kPartKinds) {
    const std::string label(kind_label(kind));
    if (selectable(label, {}, false)) {
      if (kind == TileShape::Kind::polygon)
        begin_drawing(session, ui.view);
      else
        add_part(session, actions, ui.view, kind);
    }
    ui.item("shape/add_" + label);
  }
  ImGui::EndCombo();
}

void ShapePanel::draw_canvas(const Session& session, Actions& actions, Ui& ui, int tile) {
  // As wide as beside a scroll bar, which may come and go.
  const ImVec2 room{ImGui::GetWindowWidth() - ImGui::GetStyle().ScrollbarSize,
                    ImGui::GetContentRegionAvail().y};
  EditedShape edited = edited_shape(session, ui.view);
  const float least = ui.px(is_open(edited) ? kLeastPolygonCanvas : kLeastCanvas);
  const float most = ui.px(is_open(edited) ? kMaxPolygonCanvas : kMaxCanvas);
  const float height = std::clamp(room.y - ui.px(kBelowCanvas), least, most);
  const auto owner = edited.is_drawing ? std::nullopt : tile_reaching_over(session.level(), tile);
  if (owner) edited.whole = shape_of_tile(session.level(), static_cast<TileNumber>(*owner));
  const auto dragged = canvas_.draw(session, actions, owner.value_or(tile), edited, {room.x, height}, ui);
  if (!dragged) return;
  if (owner)
    actions.push_back(action::EditLevel{set_tile_shape(session.level(), *owner, *dragged), canvas_.stroke()});
  else
    put_part(session, actions, ui.view, *dragged, canvas_.stroke());
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
