#include "animation_fields.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "panels/canvas/turned_tile.h"
#include "panels/emit_edit.h"
#include "panels/ui/long_list.h"

namespace talus {
namespace {

constexpr float kPreview = 48, kTile = 62, kDuration = 66;  // px at scale 1

// The tiles that are selected on the sheet, row by row; the tile itself if those are sprites.
std::vector<TileNumber> selected_tiles(const Session& session, TileNumber tile) {
  const SpriteArea& area = session.choices().area;
  if (area.sheet != SheetId::tiles) return {tile};
  std::vector<TileNumber> tiles;
  for (int y = 0; y < area.tiles.h; ++y)
    for (int x = 0; x < area.tiles.w; ++x)
      tiles.push_back(static_cast<TileNumber>(area.tile_at(session.level(), x, y)));
  return tiles;
}

// At the cursor, which goes on to the right of it.
void draw_tile(TileNumber tile, float side, TileSize size, const Ui& ui) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + side, at.y + side}, theme::color(theme::kDark));
  const float longest = static_cast<float>(std::max(size.width, size.height));
  const ImVec2 to{at.x + side * static_cast<float>(size.width) / longest,
                  at.y + side * static_cast<float>(size.height) / longest};
  draw_map_cell(list, tile, size, at, to, ui);
  ImGui::Dummy({side, side});
}

std::string length_text(const TileAnimation& animation) {
  int length = 0;
  for (const AnimationFrame& frame : animation) length += frame.duration;
  return std::to_string(animation.size()) + (animation.size() == 1 ? " frame, " : " frames, ") +
         std::to_string(length) + " ms";
}

}  // namespace

void AnimationFields::draw(const Session& session, TileNumber tile, Actions& actions, Ui& ui) {
  const TileAnimation* const animation = find_animation(session.level().animations, tile);
  ui.heading(animation == nullptr ? "Animation" : "Animation, " + length_text(*animation));
  if (animation != nullptr) {
    const TileNumber shown = tile_shown_at(*animation, ui.time * 1000);
    draw_tile(shown, ui.px(kPreview), session.level().map.tile_size(), ui);
    ui.item("tile/preview", "The animation as it plays.");
    ui.want_frames();
    ImGui::SameLine();
  }
  ImGui::BeginGroup();
  draw_buttons(session, tile, actions, ui);
  ImGui::EndGroup();
  if (animation == nullptr) {
    ui.hint("None. Add frame begins one with this tile; then select other tiles on the sheet, and add them.");
    return;
  }
  ui.begin_row();
  draw_rows(static_cast<int>(animation->size()), [&](int index) {
    ImGui::PushID(index);
    draw_frame(session, tile, index, actions, ui);
    ImGui::PopID();
  });
  ui.end_row();
}

// The tile stays in the panel from the first frame on, so that others can be selected.
void AnimationFields::draw_buttons(const Session& session, TileNumber tile, Actions& actions, Ui& ui) const {
  const bool has_frames = find_animation(session.level().animations, tile) != nullptr;
  if (ui.text_button("tile/add_frame", "Add frame", false,
                     "Adds a frame with each tile that is selected on the sheet.")) {
    emit_edit(actions, add_frames(session.level(), tile, selected_tiles(session, tile)));
    ui.view.sprites.kept_tile = tile;
  }
  if (!has_frames) return;
  ImGui::SameLine();
  if (ui.text_button("tile/remove_animation", "Remove", false, "Removes the animation of the tile."))
    emit_edit(actions, remove_animation(session.level(), tile));
}

void AnimationFields::draw_frame(const Session& session, TileNumber tile, int index, Actions& actions,
                                 Ui& ui) {
  const Level& level = session.level();
  const AnimationFrame frame = (*find_animation(level.animations, tile))[static_cast<std::size_t>(index)];
  const std::string name = "tile/frame" + std::to_string(index);
  draw_tile(frame.tile, ui.px(theme::kButton), level.map.tile_size(), ui);
  ImGui::SameLine();
  double shown = frame.tile, duration = frame.duration;
  bool changed = draw_number_field({name + "_tile", "#%.0f", "The number of the tile that is shown.", kTile},
                                   shown, session, number_edit_, ui);
  ImGui::SameLine();
  changed |= draw_number_field({name + "_ms", "%.0f ms", "How long it is shown, 1 to 60000 ms.", kDuration},
                               duration, session, number_edit_, ui);
  if (changed) {
    const double last = level.tile_count() - 1;
    const AnimationFrame now{
        static_cast<TileNumber>(std::lround(std::clamp(shown, 0.0, last))),
        static_cast<int>(std::lround(std::clamp(duration, 1.0, 1.0 * kMaxFrameDuration)))};
    emit_edit(actions, change_frame(level, tile, index, now), number_edit_.stroke);
  }
  const int count = static_cast<int>(find_animation(level.animations, tile)->size());
  ImGui::SameLine();
  if (ui.icon_button(name + "_up", Icon::arrow_up, false, "Shows the frame earlier.", "", index > 0))
    emit_edit(actions, move_frame(level, tile, index, index - 1));
  ImGui::SameLine();
  if (ui.icon_button(name + "_down", Icon::arrow_down, false, "Shows the frame later.", "",
                     index + 1 < count))
    emit_edit(actions, move_frame(level, tile, index, index + 1));
  ImGui::SameLine();
  if (ui.icon_button(name + "_remove", Icon::close, false, "Removes the frame.", ""))
    emit_edit(actions, remove_frame(level, tile, index));
}

}  // namespace talus
