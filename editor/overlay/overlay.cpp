// Draws a step's records as lines, boxes, marks, bars and labels.
#include "overlay.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <unordered_set>
#include <utility>

#include "collision/ground_queries.h"
#include "motion.h"
#include "number_label.h"
#include "outline.h"
#include "removed_edges.h"
#include "visible.h"
#include "visible_items.h"

namespace talus {
namespace {

constexpr double kNormalLength = 8;  // px
constexpr double kBarHeight = 2;     // px
constexpr double kBarGap = 2;        // px between the bar and the body below it
constexpr double kFloorMargin = 4;   // px by which the floor line sticks out on both sides of the body

constexpr double kFloorReach = 64;  // px below a body at which a floor is looked for; of the chosen one, all
constexpr double kFloorStep = 1;    // px between the places where a floor's height is shown
constexpr int kMostFloorParts = 64;
constexpr double kFloorTick = 1.5;  // px

// The middle of what two intervals share; of the gap between them when they are apart.
double shared_middle(double a_min, double a_max, double b_min, double b_max) {
  return (std::max(a_min, b_min) + std::min(a_max, b_max)) / 2;
}

// Where the mover's box at the contact meets the obstacle: the middle of the shared part of the touched side.
// A contact without a direction has the middle of the overlap.
Vec2 touched_point(const ContactRecord& contact, const Rect& body) {
  const Rect& o = contact.other.box;
  const Vec2 at = contact.touch, n = contact.normal;
  Vec2 point{shared_middle(at.x, at.x + body.w, o.x, o.right()),
             shared_middle(at.y, at.y + body.h, o.y, o.bottom())};
  if (n.x != 0) point.x = n.x < 0 ? o.x : o.right();
  if (n.y != 0) point.y = n.y < 0 ? o.y : o.bottom();
  return point;
}

// Of a body or of a tile's cell: one number, as thousands of them are looked up in a frame.
std::uint64_t key_of(const Obstacle& obstacle) {
  const auto number = [](int n) { return static_cast<std::uint64_t>(static_cast<std::uint32_t>(n)); };
  constexpr std::uint64_t kBody = std::uint64_t{1} << 63;  // the row of no cell, which is in the upper half
  if (obstacle.body != 0) return kBody | number(obstacle.body);
  return number(obstacle.cell.y) << 32 | number(obstacle.cell.x);
}

// The two ends of a slope's surface, left to right.
std::pair<Vec2, Vec2> slope_surface(const Obstacle& slope) {
  const Rect& b = slope.box;
  if (slope.role == TileRole::up_slope) return {{b.x, b.bottom()}, {b.right(), b.y}};
  return {{b.x, b.y}, {b.right(), b.bottom()}};
}

class Drawer {
 public:
  Drawer(const OverlaySource& source, OverlaySet overlays, Rect visible)
      : source_(source),
        scene_(source.scene),
        state_(source.state),
        record_(source.record),
        ground_(source.ground),
        overlays_(overlays),
        visible_(visible),
        chosen_(source.chosen_body) {}

  OverlayDrawing draw() {
    if (overlays_.has(OverlayId::tested_tiles)) draw_tested();
    if (overlays_.has(OverlayId::boxes)) draw_boxes();
    if (ground_ != nullptr) draw_ground();
    if (overlays_.has(OverlayId::swept_path)) add_swept_paths(source_, visible_, out_);
    for (const Body& body : state_.bodies) {
      if (overlays_.has(OverlayId::velocity)) draw_velocity(body);
      if (ground_ == nullptr || !meet(body.box, visible_)) continue;
      if (overlays_.has(OverlayId::floor_height)) draw_floor(body);
      if (overlays_.has(OverlayId::penetration)) draw_penetration(body);
    }
    for (const ContactRecord& contact : record_.contacts) {
      // An edit may have taken the body away since the step.
      if (const Body* body = state_.find(contact.body)) draw_contact(contact, *body);
    }
    draw_probes();
    return std::move(out_);
  }

 private:
  bool sees(const Rect& r) const { return meet(r, visible_); }

  void draw_ground() {
    if (overlays_.has(OverlayId::removed_edges)) add_removed_edges(*ground_, visible_, out_);
    if (overlays_.has(OverlayId::outline) || overlays_.has(OverlayId::one_way))
      add_outline(*ground_, overlays_, visible_, out_);
  }

  void line(OverlayId id, Vec2 from, Vec2 to, bool arrow = false) {
    if (meets(from, to, visible_)) out_.lines.push_back({id, from, to, arrow});
  }
  void box(OverlayId id, const Rect& r, bool filled = false) {
    if (sees(r)) out_.boxes.push_back({id, r, filled});
  }
  void label(OverlayId id, Vec2 at, std::string text, const Body& body) {
    if (sees(body.box))
      out_.labels.push_back({id, at, std::move(text), body.id == chosen_, body.id, body.box});
  }

  void draw_tested() {
    std::unordered_set<std::uint64_t> drawn;  // several bodies may have tested the same box
    for (const TestedBox& tested : record_.tested) {
      const Obstacle& other = tested.other;
      if (sees(other.box) && drawn.insert(key_of(other)).second)
        box(OverlayId::tested_tiles, other.box, true);
    }
  }

  void draw_boxes() {
    for_each_visible_item(scene_, visible_, [&](const SceneItem& item) {
      if (item.role != TileRole::ball) box(OverlayId::boxes, item.box);
    });
    for (const Body& body : state_.bodies) box(OverlayId::boxes, body.box);
  }

  void draw_velocity(const Body& body) {
    if (body.velocity == Vec2{}) return;
    const Vec2 from = body.box.center(), to = from + body.velocity * kPixelsPerVelocity;
    line(OverlayId::velocity, from, to, true);
    label(OverlayId::velocity, to, two_decimals(body.velocity.x) + ", " + two_decimals(body.velocity.y),
          body);
  }

  // The floor straight below, as the ground has it, and its height under every x of the body.
  void draw_floor(const Body& body) {
    const Rect& b = body.box;
    const double reach = body.id == chosen_ ? ground_->height() * double{kTileSide} : kFloorReach;
    const auto floor = floor_below(*ground_, b, reach, body.foot);
    if (!floor) return;
    const double x = b.center().x;
    const Vec2 end{b.right() + kFloorMargin, floor->y};
    line(OverlayId::floor_height, {b.x - kFloorMargin, floor->y}, end);
    if (floor->y > b.bottom()) line(OverlayId::floor_height, {x, b.bottom()}, {x, floor->y});
    if (body.id == chosen_) draw_floor_profile(b, reach);
    label(OverlayId::floor_height, end, "floor " + two_decimals(floor->y), body);
  }

  void draw_floor_profile(const Rect& box, double reach) {
    const int parts = std::clamp(static_cast<int>(std::ceil(box.w / kFloorStep)), 1, kMostFloorParts);
    std::optional<Vec2> before;
    for (int i = 0; i <= parts; ++i) {
      const double x = box.x + box.w * i / parts;
      const auto floor = floor_below(*ground_, {x, box.y, 0, box.h}, reach);
      if (floor) line(OverlayId::floor_height, {x, floor->y}, {x, floor->y + kFloorTick});
      if (floor && before) line(OverlayId::floor_height, *before, {x, floor->y});
      before = floor ? std::optional<Vec2>({x, floor->y}) : std::nullopt;
    }
  }

  // What of the body is in the ground: the strip at the side through which it gets out soonest.
  void draw_penetration(const Body& body) {
    const auto out = way_out(*ground_, body.box, body.foot);
    if (!out) return;
    Rect inside = body.box;
    if (out->x != 0) {
      inside.w = std::min(inside.w, std::abs(out->x));
      if (out->x < 0) inside.x = body.box.right() - inside.w;
    } else {
      inside.h = std::min(inside.h, std::abs(out->y));
      if (out->y < 0) inside.y = body.box.bottom() - inside.h;
    }
    box(OverlayId::penetration, inside, true);
    const Vec2 from = inside.center();
    line(OverlayId::penetration, from, from + *out, true);
    label(OverlayId::penetration, from, "in " + two_decimals(std::abs(out->x) + std::abs(out->y)), body);
  }

  void draw_contact(const ContactRecord& contact, const Body& body) {
    const Vec2 point = touched_point(contact, body.box);
    if (overlays_.has(OverlayId::normals) && contact.normal != Vec2{}) {
      line(OverlayId::normals, point, point + contact.normal * kNormalLength, true);
    }
    if (overlays_.has(OverlayId::touch_points)) {
      if (sees({point.x, point.y, 0, 0})) out_.marks.push_back({OverlayId::touch_points, point});
      label(OverlayId::touch_points, point, time_label(contact.ti, contact.overlaps), body);
    }
  }

  // A body may look for a floor at several contacts of a step; the last look decided where it is.
  void draw_probes() {
    std::vector<const SlopeProbe*> last(state_.bodies.size());
    for (const ContactRecord& contact : record_.contacts) {
      const Body* body = state_.find(contact.body);
      if (body != nullptr && contact.slope) last[body - state_.bodies.data()] = &*contact.slope;
    }
    for (std::size_t i = 0; i < last.size(); ++i) {
      if (last[i] != nullptr) draw_probe(*last[i], state_.bodies[i]);
    }
  }

  void draw_probe(const SlopeProbe& probe, const Body& body) {
    const Rect& b = body.box;
    const double x = b.center().x;
    if (overlays_.has(OverlayId::normals)) {
      const Vec2 floor{x, probe.floor_y};
      line(OverlayId::normals, floor, floor + probe.normal * kNormalLength, true);
    }
    if (overlays_.has(OverlayId::slope_delta)) {
      const Rect bar{b.x, b.y - kBarGap - kBarHeight, b.w, kBarHeight};
      if (sees(bar)) out_.bars.push_back({OverlayId::slope_delta, bar, probe.delta});
      label(OverlayId::slope_delta, {x, bar.y}, "delta " + two_decimals(probe.delta), body);
    }
    if (overlays_.has(OverlayId::floor_height) && !scene_.ground && !scene_.single_ground) {
      const auto [left, right] = slope_surface(probe.slope);
      const Vec2 end{b.right() + kFloorMargin, probe.floor_y};
      line(OverlayId::floor_height, left, right);
      line(OverlayId::floor_height, {b.x - kFloorMargin, probe.floor_y}, end);
      label(OverlayId::floor_height, end,
            "floor " + two_decimals(probe.floor_y) + " -> " + no_decimals(probe.placed_y + b.h), body);
    }
  }

  const OverlaySource& source_;
  const Scene& scene_;
  const State& state_;
  const StepRecord& record_;
  const Terrain* const ground_;
  OverlaySet overlays_;
  Rect visible_;
  int chosen_;
  OverlayDrawing out_;
};

}  // namespace

OverlayDrawing make_overlays(const OverlaySource& source, OverlaySet overlays, Rect visible) {
  return Drawer(source, overlays, visible).draw();
}

}  // namespace talus
