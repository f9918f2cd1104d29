// Chooses the zoom at which a sheet opens.
#include "sheet_camera.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace talus {
namespace {

// px at scale 1, of a tile: smaller ones look alike, and larger ones only take room.
constexpr float kLeastSheetTile = 24, kMaxSheetTile = 48;

}  // namespace

void SheetCamera::begin(const Session& session, Ui& ui, CellRect tiles, ImVec2 room) {
  const SheetId sheet = session.choices().area.sheet;
  const Subject subject{ui.view.canvas.level_number, sheet,
                        sheet == SheetId::tiles ? ui.view.sprites.tileset : -1};
  const int side = session.level().map.tile_size().width;
  const bool is_another = subject != subject_;
  const bool is_resized = tiles != tiles_ || side != tile_.width || room.x != room_.x || room.y != room_.y;
  subject_ = subject;
  tiles_ = tiles;
  tile_ = {side, side};
  room_ = room;
  if (is_another || (is_resized && camera_.is_untouched())) start_afresh(ui);
  camera_.limit(size(), room_);
  if (const int steps = std::exchange(ui.view.sprites.sheet_zoom, 0)) {
    camera_.zoom_at({room.x / 2, room.y / 2}, steps);
    zoom_is_chosen_ = true;
  }
  camera_.clamp(size(), room_);
}

// A sheet that fits at a larger zoom fills the panel.
void SheetCamera::start_afresh(const Ui& ui) {
  const auto of_tile = [&](float length) { return ui.px(length) / static_cast<float>(tile_.width); };
  const Vec2 whole = size();
  const auto fits = static_cast<float>(std::min(room_.x / whole.x, room_.y / whole.y));
  const float least = zoom_is_chosen_ ? camera_.zoom() : of_tile(kLeastSheetTile);
  const float most = zoom_is_chosen_ ? camera_.zoom() : std::max(of_tile(kMaxSheetTile), fits);
  camera_.show_corner(least, most, whole, room_);
}

bool SheetCamera::take_mouse(const Session& session, const Ui& ui, ImVec2 corner) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool hovered = ImGui::IsItemHovered();
  if (hovered && hand_.zoom(camera_, {mouse.x - corner.x, mouse.y - corner.y})) zoom_is_chosen_ = true;
  int button = CameraHand::kNone;
  if (space_moves_view(session, ui.view) && ImGui::IsMouseClicked(0)) button = 0;
  if (ImGui::IsMouseClicked(2)) button = 2;
  hand_.move(camera_, hovered ? button : CameraHand::kNone);
  camera_.clamp(size(), room_);
  return hand_.is_moving();
}

void SheetCamera::show(CellRect tiles) {
  const SheetView shown = view({0, 0});
  const ImVec2 from = shown.canvas.corner_of({tiles.x - tiles_.x, tiles.y - tiles_.y});
  const float width = shown.cell() * static_cast<float>(tiles.w);
  const float height = shown.cell() * static_cast<float>(tiles.h);
  const bool is_in_sight =
      from.x >= 0 && from.y >= 0 && from.x + width <= room_.x && from.y + height <= room_.y;
  if (!is_in_sight)
    show(Vec2{(tiles.x - tiles_.x + tiles.w / 2.0) * tile_.width,
              (tiles.y - tiles_.y + tiles.h / 2.0) * tile_.height});
}

void SheetCamera::show(Vec2 place) {
  camera_.keep_in_sight(place, room_);
  camera_.stay_on_map(size(), room_);
}

}  // namespace talus
