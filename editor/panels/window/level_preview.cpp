// Reads examples, plays them, and draws them by textures of their own.
#include "level_preview.h"

#include <algorithm>
#include <cmath>

#include <talus/formats/format.h>
#include "area_picture.h"
#include "formats/native/hard_case_file.h"
#include "level/tile_color.h"
#include "overlay/visible.h"
#include "panels/canvas/body_drawing.h"
#include "panels/canvas/canvas_layers.h"
#include "panels/canvas/opening_area.h"
#include "panels/files/picture_in_list.h"
#include "sim/case_edit.h"
#include "sim/case_input.h"

namespace talus {
namespace {

constexpr std::int64_t kLeastPreviewFrames = 90, kMaxPreviewFrames = 600;  // of a run

// Of tiles that lie together on the sheet. Colour 0 is clear where they have 16 colours.
std::shared_ptr<const SheetPicture> picture_of_tiles(const Level& level, CellRect tiles) {
  const TileSize tile = level.map.tile_size();
  const Sheet& sheet = level.sheet(SheetId::tiles);
  SheetPicture picture{tiles.w * tile.width, tiles.h * tile.height, {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const int sheet_x = tiles.x * tile.width + x, sheet_y = tiles.y * tile.height + y;
      if (sheet.picture != nullptr) {
        const std::uint8_t* rgba = sheet.picture->at(sheet_x, sheet_y);
        picture.rgba.insert(picture.rgba.end(), rgba, rgba + 4);
        continue;
      }
      const int number = sheet.layout().tile_at({sheet_x / tile.width, sheet_y / tile.height});
      const TileImage& image = sheet.images[static_cast<std::size_t>(number)];
      const std::uint8_t index = color_at(image, tile, sheet_x % tile.width, sheet_y % tile.height);
      const Rgb color = level.palette[index];
      picture.rgba.insert(picture.rgba.end(),
                          {color.r, color.g, color.b, static_cast<std::uint8_t>(index == 0 ? 0 : 255)});
    }
  }
  return std::make_shared<const SheetPicture>(std::move(picture));
}

}  // namespace

LevelPreview::LevelPreview(const std::string& path) {
  auto loaded = load_level(path);
  if (!loaded) return;
  level_ = std::move(loaded->level);
  if (auto hard = hard_case_of(level_); hard && *hard) case_ = std::move(**hard);
  const auto scene = std::make_shared<const Scene>(compile_scene(level_));
  start_ = state_ = initial_state(*scene);
  solver_ = make_solver(scene);
  area_ = area_of_cells(opening_area(level_, state_).area, level_.map);
  picture_ = picture_of_area(level_, area_);
}

// Each is made when it is first seen.
const std::shared_ptr<const SheetPicture>& LevelPreview::image_of(CellRect tiles) const {
  auto& image = images_[{tiles.x, tiles.y, tiles.w, tiles.h}];
  if (image == nullptr) image = picture_of_tiles(level_, tiles);
  return image;
}

Input LevelPreview::input() const {
  constexpr std::int64_t kRun = 150, kBetweenJumps = 50, kJump = 12;  // frames
  if (!case_.input.empty()) return case_input(case_.input, state_.frame + 1);
  if (case_.frames > 0) return {};
  Input held;
  held.right = state_.frame / kRun % 2 == 0;
  held.left = !held.right;
  held.jump = state_.frame % kBetweenJumps >= kBetweenJumps - kJump;
  return held;
}

bool LevelPreview::is_over() const {
  const std::int64_t frames =
      case_.frames > 0 ? std::clamp(case_.frames, kLeastPreviewFrames, kMaxPreviewFrames) : kMaxPreviewFrames;
  const Body* player = followed_body(state_, 0);
  return state_.frame >= frames || (player != nullptr && !meet(player->box, area_));
}

void LevelPreview::step() {
  if (!solver_) return;
  if (is_over()) state_ = start_;
  if (state_.frame == 0) make_edits(case_.edits, state_);
  solver_->step(state_, input());
  make_edits(case_.edits, state_);
}

void LevelPreview::draw_body(const BodyDrawing& drawing, const Body& body, const CanvasView& view,
                             Ui& ui) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto at = [&](const Rect& box) {
    return std::pair(view.to_screen({box.x, box.y}), view.to_screen({box.right(), box.bottom()}));
  };
  if (const auto frame = drawing.frame_of(body)) {
    auto [from, to] = at(place_of_picture(*picture_of_body(level_, body), body.box, view.tile));
    if (body.velocity.x < 0) std::swap(from.x, to.x);
    return list.AddImage(ui.small_pictures->texture(image_of(*frame)), from, to);
  }
  const auto [from, to] = at(body.box);
  if (draw_own_look(list, body, from, to, 255)) return;
  if (const int tile = drawing.tile_of(body); tile >= 0) {
    const Cell place = level_.sheet(SheetId::tiles).layout().place_of(tile);
    return list.AddImage(ui.small_pictures->texture(image_of({place.x, place.y, 1, 1})), from, to);
  }
  list.AddCircleFilled({(from.x + to.x) / 2, (from.y + to.y) / 2}, (to.x - from.x) / 2,
                       theme::color(theme::kText));
}

void LevelPreview::draw(ImVec2 min, ImVec2 max, Ui& ui) const {
  draw_picture_in(picture_, min, max, ui);
  if (!picture_) return;
  const double zoom = std::min((max.x - min.x) / area_.w, (max.y - min.y) / area_.h);
  const Vec2 corner{min.x + (max.x - min.x - zoom * area_.w) / 2,
                    min.y + (max.y - min.y - zoom * area_.h) / 2};
  const CanvasView view{min,
                        max,
                        {corner.x - zoom * area_.x, corner.y - zoom * area_.y},
                        static_cast<float>(zoom),
                        level_.map.tile_size()};
  ImGui::PushClipRect(view.to_screen({area_.x, area_.y}), view.to_screen({area_.right(), area_.bottom()}),
                      true);
  draw_curves(*ImGui::GetWindowDrawList(), level_, view, ui.scale / 2);
  const BodyDrawing drawing(level_, state_.frame);
  for (const Body& body : state_.bodies)
    if (meet(body.box, area_)) draw_body(drawing, body, view, ui);
  ImGui::PopClipRect();
}

void LevelPreviews::begin_frame(double time, bool moves) {
  constexpr double kStep = 1.0 / 60;  // s
  may_read_ = true;
  steps_ = moves ? std::clamp(static_cast<int>((time - time_) / kStep), 0, kMaxSteps) : 0;
  time_ = steps_ == kMaxSteps || !moves ? time : time_ + steps_ * kStep;
}

void LevelPreviews::draw(const std::string& path, ImVec2 min, ImVec2 max, Ui& ui) {
  auto preview = previews_.find(path);
  if (preview == previews_.end() && may_read_) {
    may_read_ = false;
    preview = previews_.try_emplace(path, path).first;
  }
  if (preview == previews_.end()) return draw_picture_in(nullptr, min, max, ui);
  for (int i = 0; i < steps_; ++i) preview->second.step();
  preview->second.draw(min, max, ui);
}

void LevelPreviews::clear() { previews_.clear(); }

}  // namespace talus
