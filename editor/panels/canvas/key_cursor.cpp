// The place of the keyboard's cursor, and its buttons.
#include "key_cursor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/ui/theme.h"

namespace talus {
namespace {

bool is_same(ImVec2 a, ImVec2 b) { return a.x == b.x && a.y == b.y; }

bool is_down(const CursorPointer& pointer) { return pointer.down[0] || pointer.down[1]; }

bool is_in(const CanvasView& view, ImVec2 p) {
  return p.x >= view.min.x && p.y >= view.min.y && p.x < view.max.x && p.y < view.max.y;
}

}  // namespace

void KeyCursor::go_to(std::initializer_list<std::string_view> canvases) {
  const auto found = std::find_if(canvases.begin(), canvases.end(), [&](std::string_view canvas) {
    return std::find(there_.begin(), there_.end(), canvas) != there_.end();
  });
  const std::string_view canvas = found == canvases.end() ? *canvases.begin() : *found;
  if (on_ && canvas == canvas_) return;
  canvas_ = canvas;
  on_ = entered_ = waits_ = true;
  lift();
  asked_ = {};
  stride_ = Stride::cell;
  screen_.reset();
}

void KeyCursor::go_to_next() {
  if (there_.empty()) return;
  const auto now = std::find(there_.begin(), there_.end(), canvas_);
  go_to({now == there_.end() || now + 1 == there_.end() ? there_.front() : *(now + 1)});
}

void KeyCursor::hide() {
  on_ = false;
  lift();
}

void KeyCursor::lift() {
  pen_ = false;
  buttons_ = {};
}

void KeyCursor::move(Cell by, Stride stride) {
  if (stride != stride_) asked_ = {};
  asked_ = {asked_.x + by.x, asked_.y + by.y};
  stride_ = stride;
}

void KeyCursor::press(int button) {
  buttons_[static_cast<std::size_t>(button)] = {.wanted = true, .key = key_};
}

// A button that no frame has seen yet stays down for one frame.
void KeyCursor::release(int key) {
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    if (buttons_[i].key != key || key == 0) continue;
    buttons_[i] = {.wanted = !given_ || !given_->down[i]};
  }
}

// A move of the cursor and a change of a button come one after the other, so that a gesture sees both. The
// buttons are released on a canvas before the cursor leaves it.
std::optional<CursorPointer> KeyCursor::begin_frame() {
  there_ = std::exchange(drawn_, {});
  const bool may_come = std::exchange(waits_, false);
  if (on_ && !may_come && std::find(there_.begin(), there_.end(), canvas_) == there_.end()) hide();
  if (given_ && is_down(*given_) && (!on_ || !screen_)) {
    given_->down = {};
    return given_;
  }
  if (given_ && std::any_of(buttons_.begin(), buttons_.end(), [](const Button& b) { return b.ends; })) {
    for (std::size_t i = 0; i < buttons_.size(); ++i) {
      if (std::exchange(buttons_[i].ends, false)) given_->down[i] = wants_down(static_cast<int>(i));
    }
    return given_;
  }
  if (!on_) given_.reset();
  if (!on_ || !screen_) return given_;
  if (!given_ || !is_same(given_->at, *screen_)) {
    given_ = CursorPointer{*screen_, given_ ? given_->down : std::array<bool, 2>{}};
    return given_;
  }
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    given_->down[i] = wants_down(static_cast<int>(i));
    if (buttons_[i].wanted && buttons_[i].key == 0) buttons_[i] = {.ends = true};
  }
  return given_;
}

Vec2 KeyCursor::kept_inside(Vec2 place) const {
  const CellRect& room = ground_.room;
  const double last = ground_.on_corners ? 0 : 1;
  return {std::clamp(place.x, room.x * 1.0, room.x + room.w - last),
          std::clamp(place.y, room.y * 1.0, room.y + room.h - last)};
}

Vec2 KeyCursor::moved(Vec2 place) const {
  if (stride_ == Stride::unit)
    return kept_inside({std::floor(place.x) + asked_.x, std::floor(place.y) + asked_.y});
  const double steps = stride_ == Stride::far ? kFar : 1;
  const auto go = [&](double from, int by, int first, int size, double cell) {
    const double middle = ground_.on_corners ? 0 : cell / 2;
    const double last = first + std::floor((size - (ground_.on_corners ? 0.0 : 1.0)) / cell) * cell;
    return std::clamp(std::floor(from / cell) * cell + by * steps * cell, first * 1.0, last) + middle;
  };
  return {go(place.x, asked_.x, ground_.room.x, ground_.room.w, ground_.cell.width),
          go(place.y, asked_.y, ground_.room.y, ground_.room.h, ground_.cell.height)};
}

std::optional<Vec2> KeyCursor::visit(std::string_view canvas, const CanvasView& view,
                                     const CursorGround& ground, ImVec2 mouse) {
  drawn_.emplace_back(canvas);
  if (!on_ || canvas != canvas_) return std::nullopt;
  ground_ = ground;
  const auto known = places_.find(canvas);
  const bool enters = std::exchange(entered_, false);
  Vec2 place;
  if (known != places_.end() && (!enters || is_in(view, view.to_screen(known->second)))) {
    place = known->second;
  } else {
    const ImVec2 middle{(view.min.x + view.max.x) / 2, (view.min.y + view.max.y) / 2};
    place = view.to_level(is_in(view, mouse) ? mouse : middle);
  }
  const bool moves = enters || asked_.x != 0 || asked_.y != 0;
  const Vec2 now = moves ? moved(kept_inside(place)) : kept_inside(place);
  asked_ = {};
  places_.insert_or_assign(std::string(canvas), now);
  return moves ? std::optional(now) : std::nullopt;
}

void KeyCursor::draw(std::string_view canvas, ImDrawList& list, const CanvasView& view, float scale) {
  if (!on_ || canvas != canvas_ || entered_) return;
  const Vec2 place = places_.find(canvas)->second;
  screen_ = view.to_screen(place);
  const ImU32 color = theme::color(pen_ ? theme::kWarning : theme::kAccent);
  const float width = std::max(1.0f, std::round(scale)) * (pen_ ? 2.0f : 1.0f);
  const auto frame = [&](ImVec2 min, ImVec2 max, float grown, float thick, ImU32 shade) {
    list.AddRect({min.x - grown, min.y - grown}, {max.x + grown, max.y + grown}, shade, 0, 0, thick);
  };
  ImVec2 min = *screen_, max = *screen_;
  float grown = 5 * scale;
  if (!ground_.on_corners) {
    const double w = ground_.cell.width, h = ground_.cell.height;
    const Vec2 from{std::floor(place.x / w) * w, std::floor(place.y / h) * h};
    min = view.to_screen(from);
    max = view.to_screen({from.x + w, from.y + h});
    grown = 2 * scale;
  }
  frame(min, max, grown, width + 2, theme::color(theme::kDark));
  frame(min, max, grown, width, color);
  const float dot = (pen_ ? 3.0f : 1.5f) * scale;
  list.AddCircleFilled(*screen_, dot + 1, theme::color(theme::kDark));
  list.AddCircleFilled(*screen_, dot, color);
}

}  // namespace talus
