// Rows of brushes with their pictures, and the ground's tiles where they belong.
#include "brushes_panel.h"

#include <algorithm>
#include <cmath>

#include "edit/auto_tile.h"
#include "edit/brush_tools.h"
#include "edit/tile_note_tools.h"
#include "panels/canvas/turned_tile.h"
#include "panels/commands/commands.h"
#include "panels/emit_edit.h"
#include "panels/sprites/tile_number.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

constexpr float kPicture = 40;   // px at scale 1, the side of a brush's picture
constexpr float kPartSide = 24;  // px at scale 1, of a tile of the ground

// The brush in a square; for a brush that is too large, its top-left part.
void draw_picture(ImDrawList& list, const Brush& brush, ImVec2 at, float side, const Ui& ui) {
  const int longest = std::max(brush.w, brush.h);
  const float fits = std::floor(side / static_cast<float>(longest));
  const float cell = std::clamp(fits, static_cast<float>(kCartTileSize) / 2, side);
  const int most = static_cast<int>(side / cell);
  const int columns = std::min(brush.w, most), rows = std::min(brush.h, most);
  const ImVec2 from{at.x + std::floor((side - static_cast<float>(columns) * cell) / 2),
                    at.y + std::floor((side - static_cast<float>(rows) * cell) / 2)};
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const ImVec2 corner{from.x + static_cast<float>(x) * cell, from.y + static_cast<float>(y) * cell};
      draw_map_cell(list, brush.tiles[static_cast<std::size_t>(y * brush.w + x)], {}, corner,
                    {corner.x + cell, corner.y + cell}, ui);
    }
  }
}

void take(const Brush& brush, const Session& session, Actions& actions) {
  actions.push_back(action::SetStamp{stamp_of_brush(brush)});
  actions.push_back(action::SetRandomStamp{brush.random, session.choices().random_seed});
  actions.push_back(action::SetMapTool{MapTool::stamp});
}

// The places of the parts in the table: ground as it looks, then the slopes.
struct PartPlace {
  GroundPart part;
  int column, row;
};
constexpr PartPlace kPlaces[] = {{GroundPart::top_left, 0, 0},        {GroundPart::top, 1, 0},
                                 {GroundPart::top_right, 2, 0},       {GroundPart::left, 0, 1},
                                 {GroundPart::inside, 1, 1},          {GroundPart::right, 2, 1},
                                 {GroundPart::bottom_left, 0, 2},     {GroundPart::bottom, 1, 2},
                                 {GroundPart::bottom_right, 2, 2},    {GroundPart::slope_up, 4, 0},
                                 {GroundPart::slope_down, 5, 0},      {GroundPart::slope_up_left, 4, 1},
                                 {GroundPart::slope_up_right, 5, 1},  {GroundPart::slope_down_left, 4, 2},
                                 {GroundPart::slope_down_right, 5, 2}};

// A cell of the table. A dot marks the inside, which is needed, as long as it is not chosen.
void draw_part(GroundPart part, const Session& session, Actions& actions, Ui& ui) {
  const Level& level = session.level();
  const GroundPartInfo& info = kGroundParts[static_cast<std::size_t>(part)];
  const std::string name = "ground/" + std::string(info.key);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float side = ui.px(kPartSide);
  const auto choose = [&](TileNumber tile) {
    AutoTiles tiles = level.auto_tiles;
    tiles.of(part) = tile;
    emit_edit(actions, set_auto_tiles(level, tiles));
  };
  const SpriteArea& area = session.choices().area;
  if (ImGui::InvisibleButton(name.c_str(), {side, side}) && area.sheet == SheetId::tiles)
    choose(static_cast<TileNumber>(area.tile_at(level, 0, 0)));
  if (ImGui::IsItemClicked(1)) choose(0);
  const int tile = level.auto_tiles.of(part);
  const std::string now =
      tile == 0 ? "none" : "tile #" + std::to_string(number_on_screen(SheetId::tiles, tile));
  ui.item(name,
          "The " + std::string(info.label) + ": " + now + ". A click takes the tile selected on the sheet.",
          "right click: no tile");
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (tile != 0) draw_map_cell(list, static_cast<TileNumber>(tile), {}, at, {at.x + side, at.y + side}, ui);
  const bool hovered = ImGui::IsItemHovered();
  const ImU32 frame = theme::tone(hovered ? theme::kText : theme::kMuted, tile != 0 && !hovered ? 120 : 255);
  list.AddRect(at, {at.x + side, at.y + side}, frame);
  if (tile == 0 && part == GroundPart::inside)
    list.AddCircleFilled({at.x + side / 2, at.y + side / 2}, ui.px(3), theme::tone(theme::kAccent));
}

}  // namespace

void BrushesPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  ImGui::BeginChild("brushes");
  draw_ground(session, actions, ui);
  ui.heading("Brushes of the level");
  draw_buttons(session, actions, ui);
  draw_probability(session, actions, ui);
  draw_list(session, actions, ui);
  ImGui::EndChild();
}

void BrushesPanel::draw_buttons(const Session& session, Actions& actions, Ui& ui) const {
  command_text_button("brushes/add"_command, session, actions, ui,
                      {.label = "Save", .widget = "brushes/add_button"});
  ImGui::SameLine();
  command_text_button("map/random"_command, session, actions, ui,
                      {.label = "Random", .widget = "map/random_button"});
  ImGui::SameLine();
  command_text_button("map/shuffle"_command, session, actions, ui,
                      {.label = "Shuffle", .widget = "map/shuffle_button"});
}

// How often random painting takes the tiles that are selected on the sheet.
void BrushesPanel::draw_probability(const Session& session, Actions& actions, Ui& ui) {
  const SpriteArea& area = session.choices().area;
  if (area.sheet != SheetId::tiles) return;
  const auto common = common_probability(session.level(), area);
  double value = common.value_or(1);
  const bool changed = draw_number_field(
      {"brushes/probability", common ? "probability %.6g" : "probability differs",
       "How often Random takes the tiles selected on the sheet: 1 as most, 0 never, 2 twice as often.", 160,
       0.02f},
      value, session, number_edit_, ui);
  if (!changed) return;
  emit_edit(actions, set_probability(session.level(), area, std::clamp(value, 0.0, kMaxProbability)),
            number_edit_.stroke);
}

void BrushesPanel::draw_list(const Session& session, Actions& actions, Ui& ui) {
  const std::vector<Brush>& brushes = session.level().brushes;
  if (brushes.empty()) {
    ui.hint(
        "No brush yet: select tiles on the sheet, or pick some from the map, and save them here under a "
        "name. "
        "They are kept with the level.");
    return;
  }
  draw_rows(static_cast<int>(brushes.size()), [&](int row) {
    ImGui::PushID(row);
    draw_brush(row, session, actions, ui);
    ImGui::PopID();
  });
}

void BrushesPanel::draw_brush(int index, const Session& session, Actions& actions, Ui& ui) {
  const Brush& brush = session.level().brushes[static_cast<std::size_t>(index)];
  const std::string name = "brushes/" + std::to_string(index);
  const float side = ui.px(kPicture), gap = ui.px(6), button = ui.px(theme::kButton);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::InvisibleButton("take", {side, side})) take(brush, session, actions);
  ui.item(name + "/take", "Takes this brush as the stamp.");
  const bool taken = session.choices().stamp == stamp_of_brush(brush);
  list.AddRectFilled(at, {at.x + side, at.y + side}, theme::color(theme::kDark));
  draw_picture(list, brush, at, side, ui);
  list.AddRect(
      {at.x - 1, at.y - 1}, {at.x + side + 1, at.y + side + 1},
      theme::tone(taken || ImGui::IsItemHovered() ? theme::kAccent : theme::kMuted, taken ? 255 : 160));
  const float text_x = at.x + side + gap;
  ImGui::SetCursorScreenPos({text_x, at.y});
  draw_name(index, at.x + width - text_x - button - gap, session, actions, ui);
  ImGui::SetCursorScreenPos({at.x + width - button, at.y});
  if (ui.icon_button(name + "/delete", Icon::close, false, "Deletes the brush; Undo brings it back.", ""))
    emit_edit(actions, remove_brush(session.level(), index));
  ImGui::SetCursorScreenPos({text_x, at.y + side - ImGui::GetTextLineHeight()});
  ui.muted(std::to_string(brush.w) + " x " + std::to_string(brush.h) + (brush.random ? ", at random" : ""));
  ImGui::SetCursorScreenPos({at.x, at.y + side + gap});
  ImGui::Dummy({0, 0});
}

// The field keeps the typed text until it is left; then the text becomes the name.
void BrushesPanel::draw_name(int index, float width, const Session& session, Actions& actions, Ui& ui) {
  const Brush& brush = session.level().brushes[static_cast<std::size_t>(index)];
  std::string text = renamed_ == index ? new_name_ : brush.name;
  ImGui::SetNextItemWidth(width);
  input_text("name", "no name", text);
  ui.item("brushes/" + std::to_string(index) + "/name", "The brush's name.");
  if (ImGui::IsItemActive()) {
    renamed_ = index;
    new_name_ = text;
  }
  if (!ImGui::IsItemDeactivated()) return;
  if (ImGui::IsItemDeactivatedAfterEdit()) emit_edit(actions, rename_brush(session.level(), index, text));
  if (renamed_ == index) renamed_ = -1;
}

void BrushesPanel::draw_ground(const Session& session, Actions& actions, Ui& ui) const {
  ui.heading("Ground: its tiles, and its slopes of one tile and of two");
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float step = ui.px(kPartSide) + ui.px(2);
  for (const PartPlace& place : kPlaces) {
    ImGui::SetCursorScreenPos(
        {at.x + ui.px(1) + step * (static_cast<float>(place.column) - (place.column > 3 ? 0.5f : 0)),
         at.y + ui.px(1) + step * static_cast<float>(place.row)});
    draw_part(place.part, session, actions, ui);
  }
  const float x = at.x + 6 * step;
  const float line = ImGui::GetFrameHeight() + ui.px(2);
  ImGui::SetCursorScreenPos({x, at.y});
  command_text_button("map/ground"_command, session, actions, ui,
                      {.label = "Paint", .widget = "map/ground_button"});
  ImGui::SetCursorScreenPos({x, at.y + line});
  command_text_button("ground/propose"_command, session, actions, ui,
                      {.label = "Propose", .widget = "ground/propose_button"});
  ImGui::SetCursorScreenPos({x, at.y + 2 * line});
  command_text_button("ground/clear"_command, session, actions, ui,
                      {.label = "Clear", .widget = "ground/clear_button"});
  ImGui::SetCursorScreenPos({at.x, at.y + std::max(3 * step, 3 * line) + ui.px(4)});
  if (session.level().auto_tiles.empty())
    ui.hint("Propose finds them on the sheet; or select a tile there and click its place here.");
}

}  // namespace talus
