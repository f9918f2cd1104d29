// Computes zoom and scroll positions.
#include "camera.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace talus {
namespace {

// Far enough for the longest map.
constexpr std::array<float, 25> kZooms = {1.0f / 32768,
                                          1.0f / 16384,
                                          1.0f / 8192,
                                          1.0f / 4096,
                                          1.0f / 2048,
                                          1.0f / 1024,
                                          1.0f / 512,
                                          1.0f / 256,
                                          1.0f / 128,
                                          1.0f / 64,
                                          1.0f / 32,
                                          1.0f / 16,
                                          0.125f,
                                          0.25f,
                                          0.5f,
                                          1,
                                          2,
                                          3,
                                          4,
                                          5,
                                          6,
                                          8,
                                          10,
                                          12,
                                          16};
constexpr int kQuarter = 13;         // the step of 1/4
constexpr double kKeptInSight = 48;  // px of the screen
constexpr float kLeastFitted = 96;   // px of the screen: in a smaller canvas nothing can be seen
constexpr double kClose = 0.8;       // the share of a zoom that is as good as the whole

int step_that_fits(Vec2 level, ImVec2 canvas) {
  int step = 0;
  for (std::size_t i = 0; i < kZooms.size(); ++i)
    if (level.x * kZooms[i] <= canvas.x && level.y * kZooms[i] <= canvas.y) step = static_cast<int>(i);
  return step;
}

// A canvas in which something can be seen.
ImVec2 fitted(ImVec2 canvas) { return {std::max(canvas.x, kLeastFitted), std::max(canvas.y, kLeastFitted)}; }

// Around a point in sight.
Vec2 room_in_sight(ImVec2 canvas) {
  return {std::min<double>(kKeptInSight, canvas.x / 4), std::min<double>(kKeptInSight, canvas.y / 4)};
}

// A map that is smaller than the canvas has `share` of the room before it; else only the map is shown.
double kept_on_map(double offset, double map, double canvas, double share) {
  return map <= canvas ? std::round((canvas - map) * share)
                       : std::clamp(offset, std::round(canvas - map), 0.0);
}

}  // namespace

Cell CanvasView::to_cell(ImVec2 p) const {
  const Vec2 at = to_level(p);
  return {static_cast<int>(std::floor(at.x / tile.width)), static_cast<int>(std::floor(at.y / tile.height))};
}

Rect CanvasView::visible() const {
  const Vec2 from = to_level(min), to = to_level(max);
  return {from.x, from.y, to.x - from.x, to.y - from.y};
}

float Camera::zoom() const { return between_.value_or(kZooms[static_cast<std::size_t>(step_)]); }

void Camera::zoom_at(ImVec2 at, int steps) {
  untouched_ = false;
  const double before = zoom();
  const int from = between_ && steps < 0 ? step_ + 1 : step_;
  const int step = std::clamp(from + steps, least_, static_cast<int>(kZooms.size()) - 1);
  if (step == step_ && !between_) return;
  step_ = step;
  between_.reset();
  before_.reset();
  const double ratio = zoom() / before;
  offset_ = {std::round(at.x - (at.x - offset_.x) * ratio), std::round(at.y - (at.y - offset_.y) * ratio)};
}

void Camera::scroll(Vec2 pixels) {
  if (pixels == Vec2{}) return;
  untouched_ = false;
  offset_ = offset_ - pixels;
}

void Camera::centre(Vec2 point, ImVec2 canvas) {
  untouched_ = false;
  offset_ = {std::round(canvas.x / 2 - point.x * zoom()), std::round(canvas.y / 2 - point.y * zoom())};
}

void Camera::keep_middle(ImVec2 before, ImVec2 now) {
  offset_ = {offset_.x + (now.x - before.x) / 2, offset_.y + (now.y - before.y) / 2};
}

Vec2 Camera::missing(Vec2 point, Vec2 room, ImVec2 canvas) const {
  const auto along = [](double at, double beside, double size) {
    return std::round(at - std::clamp(at, beside, size - beside));
  };
  return {along(offset_.x + point.x * zoom(), room.x, canvas.x),
          along(offset_.y + point.y * zoom(), room.y, canvas.y)};
}

bool Camera::is_in_sight(Vec2 point, ImVec2 canvas) const {
  return !shows_whole() && missing(point, room_in_sight(canvas), canvas) == Vec2{};
}

void Camera::keep_in_sight(Vec2 point, ImVec2 canvas) {
  if (!shows_whole()) scroll(missing(point, room_in_sight(canvas), canvas));
}

Vec2 Camera::missing_to_middle(Vec2 point, ImVec2 canvas) const {
  Vec2 by = missing(point, {canvas.x / 3, canvas.y / 3}, canvas);
  if (!bounds_ || !is_on_canvas(point, canvas)) return by;
  const auto is_whole = [&](double offset, double from, double size, double room) {
    const double first = offset + from * zoom();
    return first >= -1 && first + size * zoom() <= room + 1;
  };
  if (is_whole(offset_.x, bounds_->x, bounds_->w, canvas.x)) by.x = 0;
  if (is_whole(offset_.y, bounds_->y, bounds_->h, canvas.y)) by.y = 0;
  return by;
}

bool Camera::is_in_middle(Vec2 point, ImVec2 canvas) const {
  return missing_to_middle(point, canvas) == Vec2{};
}

bool Camera::follow(Vec2 point, Vec2 map, ImVec2 canvas) {
  if (shows_whole()) return false;
  const Vec2 by = missing_to_middle(point, canvas);
  if (by == Vec2{}) return false;
  const Vec2 before = offset_;
  offset_ = offset_ - by;
  const Vec2 free = offset_;
  stay_on_map(map, canvas);
  if (by.x == 0) offset_.x = free.x;  // a smaller part of the map lies in the middle
  if (by.y == 0) offset_.y = free.y;
  return offset_ != before;
}

void Camera::fit(Vec2 level, ImVec2 canvas) {
  step_ = step_that_fits(level, fitted(canvas));
  between_.reset();
  centre(level * 0.5, canvas);
  untouched_ = true;
}

void Camera::show(const Rect& area, bool may_be_cut, const Rect& bounds, ImVec2 canvas) {
  before_.reset();
  between_.reset();
  const ImVec2 room = fitted(canvas);
  const double exact = std::min(room.x / area.w, room.y / area.h);
  step_ = step_that_fits({area.w, area.h}, room);
  const auto above = static_cast<std::size_t>(step_) + 1;
  if (above < kZooms.size() && zoom() < exact * kClose) {
    if (may_be_cut && kZooms[above] * kClose <= exact)
      ++step_;
    else
      between_ = static_cast<float>(exact);
  }
  centre(area.center(), canvas);
  stay_on(bounds, canvas);
  bounds_ = bounds;
  untouched_ = true;
}

void Camera::show_corner(float least, float most, Vec2 map, ImVec2 canvas) {
  const ImVec2 room = fitted(canvas);
  step_ = step_that_fits({map.x, 0}, room);
  between_.reset();
  before_.reset();
  while (step_ > 0 && zoom() > most) --step_;
  while (step_ + 1 < static_cast<int>(kZooms.size()) && zoom() < least) ++step_;
  const auto fits = static_cast<float>(room.x / map.x);
  if (zoom() > fits && fits >= least) between_ = fits;
  share_before_ = 0;
  offset_ = {};
  stay_on_map(map, canvas);
  untouched_ = true;
}

void Camera::stay_on_map(Vec2 map, ImVec2 canvas) { stay_on({0, 0, map.x, map.y}, canvas); }

void Camera::stay_on(const Rect& bounds, ImVec2 canvas) {
  const double left = std::round(bounds.x * zoom()), top = std::round(bounds.y * zoom());
  offset_ = {kept_on_map(offset_.x + left, bounds.w * zoom(), canvas.x, share_before_) - left,
             kept_on_map(offset_.y + top, bounds.h * zoom(), canvas.y, share_before_) - top};
}

void Camera::toggle_whole(Vec2 map, ImVec2 canvas) {
  if (before_) {
    step_ = before_->step;
    between_ = before_->between;
    offset_ = before_->offset;
    before_.reset();
  } else {
    before_ = Place{step_, between_, offset_};
    fit(map, canvas);
    untouched_ = false;
  }
}

void Camera::leave_whole(Vec2 point, ImVec2 canvas) {
  if (before_) {
    step_ = before_->step;
    between_ = before_->between;
  }
  before_.reset();
  centre(point, canvas);
}

void Camera::limit(Vec2 map, ImVec2 canvas) { least_ = std::min(kQuarter, step_that_fits(map, canvas)); }

void Camera::clamp(Vec2 map, ImVec2 canvas) {
  offset_.x = std::clamp(offset_.x, kKeptInSight - map.x * zoom(), canvas.x - kKeptInSight);
  offset_.y = std::clamp(offset_.y, kKeptInSight - map.y * zoom(), canvas.y - kKeptInSight);
}

CanvasView Camera::view(ImVec2 min, ImVec2 size, TileSize tile) const {
  return {min,
          {min.x + size.x, min.y + size.y},
          {min.x + std::round(offset_.x), min.y + std::round(offset_.y)},
          zoom(),
          tile};
}

}  // namespace talus
