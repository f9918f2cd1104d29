// Draws a step's records as lines, boxes, marks, bars and labels.
#include "overlay.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "collision/ground_queries.h"
#include "number_label.h"
#include "outline.h"

namespace talus {
namespace {

constexpr double kNormalLength = 8;  // px
constexpr double kBarHeight = 2;     // px
constexpr double kBarGap = 2;        // px between the bar and the body below it
constexpr double kFloorMargin = 4;   // px by which the floor line sticks out on both sides of the body

constexpr double kFloorReach = 64;  // px below a body at which a floor is looked for; of the chosen one, all

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

// The two ends of a slope's surface, left to right.
std::pair<Vec2, Vec2> slope_surface(const Obstacle& slope) {
  const Rect& b = slope.box;
  if (slope.role == TileRole::up_slope) return {{b.x, b.bottom()}, {b.right(), b.y}};
  return {{b.x, b.y}, {b.right(), b.bottom()}};
}

class Drawer {
 public:
  Drawer(const Scene& scene, const State& state, const StepRecord& record, OverlaySet overlays, Rect visible,
         int chosen_body)
      : scene_(scene),
        state_(state),
        record_(record),
        overlays_(overlays),
        visible_(visible),
        chosen_(chosen_body) {}

  OverlayDrawing draw() {
    if (overlays_.has(OverlayId::tested_tiles)) draw_tested();
    if (overlays_.has(OverlayId::boxes)) draw_boxes();
    if (overlays_.has(OverlayId::outline)) add_outline(scene_, visible_, out_);
    for (const Body& body : state_.bodies) {
      if (overlays_.has(OverlayId::velocity)) draw_velocity(body);
      if (overlays_.has(OverlayId::floor_height) && scene_.ground) draw_floor(body);
    }
    for (const ContactRecord& contact : record_.contacts) {
      // An edit may have taken the body away since the step.
      if (const Body* body = state_.find(contact.body)) draw_contact(contact, *body);
    }
    draw_probes();
    return std::move(out_);
  }

 private:
  bool sees(const Rect& r) const {
    return r.right() >= visible_.x && r.x <= visible_.right() && r.bottom() >= visible_.y &&
           r.y <= visible_.bottom();
  }

  void line(OverlayId id, Vec2 from, Vec2 to, bool arrow = false) {
    const Rect around{std::min(from.x, to.x), std::min(from.y, to.y),
                      std::max(from.x, to.x) - std::min(from.x, to.x),
                      std::max(from.y, to.y) - std::min(from.y, to.y)};
    if (sees(around)) out_.lines.push_back({id, from, to, arrow});
  }
  void box(OverlayId id, const Rect& r, bool filled = false) {
    if (sees(r)) out_.boxes.push_back({id, r, filled});
  }
  void label(OverlayId id, Vec2 at, std::string text, const Body& body) {
    if (sees(body.box))
      out_.labels.push_back({id, at, std::move(text), body.id == chosen_, body.id, body.box});
  }

  void draw_tested() {
    std::set<std::tuple<int, int, int>> drawn;  // several bodies may have tested the same box
    for (const TestedBox& tested : record_.tested) {
      const Obstacle& other = tested.other;
      const bool is_new = drawn.insert({other.body, other.cell.y, other.cell.x}).second;
      if (is_new) box(OverlayId::tested_tiles, other.box, true);
    }
  }

  void draw_boxes() {
    for (const SceneItem& item : scene_.items) {
      if (item.role != TileRole::ball) box(OverlayId::boxes, item.box);
    }
    for (const Body& body : state_.bodies) box(OverlayId::boxes, body.box);
  }

  void draw_velocity(const Body& body) {
    if (body.velocity == Vec2{}) return;
    const Vec2 from = body.box.center(), to = from + body.velocity * kPixelsPerVelocity;
    line(OverlayId::velocity, from, to, true);
    label(OverlayId::velocity, to, two_decimals(body.velocity.x) + ", " + two_decimals(body.velocity.y),
          body);
  }

  // The floor straight below, as the ground has it.
  void draw_floor(const Body& body) {
    const Rect& b = body.box;
    if (!sees(b)) return;
    const double reach = body.id == chosen_ ? scene_.ground->height() * double{kTileSide} : kFloorReach;
    const auto floor = floor_below(*scene_.ground, b, reach, body.foot);
    if (!floor) return;
    const double x = b.center().x;
    const Vec2 end{b.right() + kFloorMargin, floor->y};
    line(OverlayId::floor_height, {b.x - kFloorMargin, floor->y}, end);
    if (floor->y > b.bottom()) line(OverlayId::floor_height, {x, b.bottom()}, {x, floor->y});
    label(OverlayId::floor_height, end, "floor " + two_decimals(floor->y), body);
  }

  void draw_contact(const ContactRecord& contact, const Body& body) {
    const Vec2 point = touched_point(contact, body.box);
    if (overlays_.has(OverlayId::normals) && contact.normal != Vec2{}) {
      line(OverlayId::normals, point, point + contact.normal * kNormalLength, true);
    }
    if (overlays_.has(OverlayId::touch_points)) {
      if (sees({point.x, point.y, 0, 0})) out_.marks.push_back({OverlayId::touch_points, point});
      label(OverlayId::touch_points, point, "t " + two_decimals(contact.ti), body);
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
    if (overlays_.has(OverlayId::floor_height) && !scene_.ground) {
      const auto [left, right] = slope_surface(probe.slope);
      const Vec2 end{b.right() + kFloorMargin, probe.floor_y};
      line(OverlayId::floor_height, left, right);
      line(OverlayId::floor_height, {b.x - kFloorMargin, probe.floor_y}, end);
      label(OverlayId::floor_height, end,
            "floor " + two_decimals(probe.floor_y) + " -> " + no_decimals(probe.placed_y + b.h), body);
    }
  }

  const Scene& scene_;
  const State& state_;
  const StepRecord& record_;
  OverlaySet overlays_;
  Rect visible_;
  int chosen_;
  OverlayDrawing out_;
};

}  // namespace

OverlayDrawing make_overlays(const Scene& scene, const State& state, const StepRecord& record,
                             OverlaySet overlays, Rect visible, int chosen_body) {
  return Drawer(scene, state, record, overlays, visible, chosen_body).draw();
}

}  // namespace talus
