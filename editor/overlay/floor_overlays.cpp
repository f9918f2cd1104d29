// Overlays of the floor below a body, and of its place on a slope.
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "collision/ground_queries.h"
#include "number_label.h"
#include "overlay_pen.h"

namespace talus {
namespace {

constexpr double kBarHeight = 2;    // px
constexpr double kBarGap = 2;       // px between the bar and the body below it
constexpr double kFloorMargin = 4;  // px by which the floor line sticks out on both sides of the body

constexpr double kFloorReach =
    64;  // px below a body within which a floor is shown; the chosen body shows it at any distance
constexpr double kFloorStep = 1;  // px between two drawn heights of a floor
constexpr int kMaxFloorParts = 64;
constexpr double kFloorTick = 1.5;           // px
constexpr double kTouchingBody = 1.0 / 64;   // px; what a body stands on may be in it by so much
constexpr std::int64_t kBodiesPerWork = 16;  // looked at for a unit of work

// The two ends of a slope's surface, left to right.
std::pair<Vec2, Vec2> slope_surface(const Obstacle& slope) {
  const Rect& b = slope.box;
  if (slope.role == TileRole::up_slope) return {{b.x, b.bottom()}, {b.right(), b.y}};
  return {{b.x, b.y}, {b.right(), b.bottom()}};
}

void draw_floor_profile(const Terrain& ground, const Rect& box, double reach, BodyWork& work,
                        OverlayPen& pen) {
  const int parts = std::clamp(static_cast<int>(std::ceil(box.w / kFloorStep)), 1, kMaxFloorParts);
  std::optional<Vec2> before;
  for (int i = 0; i <= parts; ++i) {
    const double x = box.x + box.w * i / parts;
    const auto floor = floor_below(ground, {x, box.y, 0, box.h}, reach, Foot::box, work.budget());
    if (floor) pen.line({x, floor->y}, {x, floor->y + kFloorTick});
    if (floor && before) pen.line(*before, {x, floor->y});
    before = floor ? std::optional<Vec2>({x, floor->y}) : std::nullopt;
  }
}

// The part of a body, px, under which another one may be: of a circle the middle.
struct Underside {
  double x0, x1, y;
};

// The y, px, at which another body comes first straight below; nothing: there is none.
std::optional<double> top_below(const Underside& under, const Body& other, bool meets) {
  const Rect& o = other.box;
  const double radius = meets ? radius_of(other.kind, {o.w, o.h}) : 0;
  double y = o.y;
  if (radius > 0) {
    const double beside = std::clamp(o.center().x, under.x0, under.x1) - o.center().x;
    if (std::abs(beside) >= radius) return std::nullopt;
    y = o.bottom() - radius - std::sqrt(radius * radius - beside * beside);
  } else if (under.x0 >= o.right() || under.x1 <= o.x) {
    return std::nullopt;
  }
  return y < under.y - kTouchingBody ? std::nullopt : std::optional(y);
}

struct BodyBelow {
  int body;  // id
  double y;  // px
};

// The first body straight below one, where bodies stop one another.
std::optional<BodyBelow> body_below(const OverlaySource& source, const Body& body, double reach,
                                    BodyWork& work) {
  if (!source.scene.features.pairs) return std::nullopt;
  work.budget()->left -= static_cast<std::int64_t>(source.state.bodies.size()) / kBodiesPerWork;
  const bool meets = source.scene.features.meets;
  const Rect& b = body.box;
  Underside under{b.x, b.right(), b.bottom()};
  if (meets && radius_of(body.kind, {b.w, b.h}) > 0) under.x0 = under.x1 = b.center().x;
  std::optional<BodyBelow> first;
  for (const Body& other : source.state.bodies) {
    if (other.id == body.id) continue;
    const auto y = top_below(under, other, meets);
    if (y && *y <= under.y + reach && (!first || *y < first->y)) first = BodyBelow{other.id, *y};
  }
  return first;
}

// Draws what comes first straight below a body: the ground, for the chosen body at its height under every x,
// or another body.
void draw_floor(const OverlaySource& source, const Body& body, OverlayPen& pen) {
  const Rect& b = body.box;
  if (source.ground == nullptr || !pen.sees(b)) return;
  const bool is_chosen = body.id == source.chosen_body;
  const double reach = is_chosen ? source.ground->y_of(source.ground->height()) : kFloorReach;
  BodyWork work(pen.drawing(), is_chosen);
  const auto below = body_below(source, body, reach, work);
  const auto floor = floor_below(*source.ground, b, reach, body.foot, work.budget());
  if (!floor && !below) return;
  const bool is_body = below && (!floor || below->y < floor->y);
  const double x = b.center().x, y = is_body ? below->y : floor->y;
  const Vec2 end{b.right() + kFloorMargin, y};
  pen.line({b.x - kFloorMargin, y}, end);
  if (y > b.bottom()) pen.line({x, b.bottom()}, {x, y});
  if (is_chosen && !is_body) draw_floor_profile(*source.ground, b, reach, work, pen);
  pen.label(end, (is_body ? "body " + std::to_string(below->body) + " at " : "floor ") + two_decimals(y),
            body);
}

// Draws the floor that article and bump compute on a slope.
void draw_computed_floor(const OverlaySource& source, const SlopeProbe& probe, const Body& body,
                         OverlayPen& pen) {
  if (source.scene.ground || source.scene.single_ground) return;
  const Rect& b = body.box;
  const auto [left, right] = slope_surface(probe.slope);
  const Vec2 end{b.right() + kFloorMargin, probe.floor_y};
  pen.line(left, right);
  pen.line({b.x - kFloorMargin, probe.floor_y}, end);
  const double placed = probe.placed_y + b.h;
  const bool is_rounded = two_decimals(placed) != two_decimals(probe.floor_y);
  pen.label(end, "floor " + two_decimals(probe.floor_y) + (is_rounded ? " -> " + no_decimals(placed) : ""),
            body);
}

void draw_delta(const OverlaySource&, const SlopeProbe& probe, const Body& body, OverlayPen& pen) {
  const Rect& b = body.box;
  const Rect bar{b.x, b.y - kBarGap - kBarHeight, b.w, kBarHeight};
  pen.bar(bar, probe.delta);
  pen.label({b.center().x, bar.y}, "delta " + two_decimals(probe.delta), body);
}

}  // namespace

namespace overlay {

const Overlay slope_delta{
    .key = "slope_delta",
    .label = "slope delta",
    .help = "How far along a slope a body's centre is, from 0 at the left end to 1 at the right.",
    .group = OverlayGroup::contact,
    .color = 0xcc79a7,
    .safe_color = 0x8c6ec8,
    .digit = '5',
    .label_rank = 1,
    .labels_above = true,  // above its bar
    .draw_probe = draw_delta,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.bar({0.5, 2.5, 7, 3}, 0.5);
        },
};

const Overlay floor_height{
    .key = "floor_height",
    .label = "floor height",
    .help =
        "What comes first straight below each body: the floor, as the exact solver's ground has it, or a "
        "body that stops it. Of the other solvers also the floor computed on a slope, before and after "
        "rounding, and the slope's surface.",
    .group = OverlayGroup::ground,
    .color = 0xd55e00,
    .safe_color = 0xaa8c50,
    .digit = '6',
    .is_default = true,
    .needs_ground = true,
    .label_rank = 2,
    .draw_body = draw_floor,
    .draw_probe = draw_computed_floor,
    .draw_swatch =
        [](OverlayPen& pen) {
          pen.line({0, 5}, {8, 5});
        },
};

}  // namespace overlay
}  // namespace talus
