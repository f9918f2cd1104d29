#include "measures.h"

#include <algorithm>
#include <cmath>

namespace talus::beside {
namespace {

double overlap_of_boxes(const Rect& a, const Rect& b) {
  const double x = std::min(a.right() - b.x, b.right() - a.x);
  const double y = std::min(a.bottom() - b.y, b.bottom() - a.y);
  return std::min(x, y);
}

double overlap_of_circles(const Rect& a, const Rect& b) {
  return (a.w + b.w) / 2 - length(a.center() - b.center());
}

double overlap_of_circle(const Rect& circle, const Rect& box) {
  const Vec2 center = circle.center();
  const Vec2 nearest{std::clamp(center.x, box.x, box.right()), std::clamp(center.y, box.y, box.bottom())};
  if (nearest == center) return overlap_of_boxes(circle, box);
  return circle.w / 2 - length(center - nearest);
}

double overlap(const Body& a, const Body& b) {
  if (a.is_round && b.is_round) return overlap_of_circles(a.at, b.at);
  if (a.is_round) return overlap_of_circle(a.at, b.at);
  if (b.is_round) return overlap_of_circle(b.at, a.at);
  return overlap_of_boxes(a.at, b.at);
}

}  // namespace

double length(Vec2 v) { return std::hypot(v.x, v.y); }

double mass(const World& world, std::size_t index) {
  return world.bodies[index].at.w * world.bodies[index].at.h;
}

double energy(const World& world, const Engine& engine) {
  double sum = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Vec2 v = engine.velocity(i);
    const double spin = engine.spin(i);
    sum += mass(world, i) * (dot(v, v) / 2 + spin * spin / 4);
  }
  return sum;
}

double deepest_overlap(const World& world, const Engine& engine) {
  std::vector<Body> bodies = world.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].at = engine.box(i);
  double deepest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) deepest = std::max(deepest, overlap(bodies[i], bodies[k]));
    for (const Rect& wall : world.walls) deepest = std::max(deepest, overlap(bodies[i], {wall}));
  }
  return deepest;
}

int count_lost(const World& world, const Engine& engine) {
  int count = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Vec2 at = engine.box(i).center();
    if (at.x < 0 || at.y < 0 || at.x > world.width || at.y > world.height) ++count;
  }
  return count;
}

int count_moving(const World& world, Engine& engine) {
  std::vector<Vec2> before;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) before.push_back(engine.box(i).position());
  engine.step();
  int count = 0;
  for (std::size_t i = 0; i < before.size(); ++i)
    if (length(engine.box(i).position() - before[i]) > 0.01) ++count;
  return count;
}

}  // namespace talus::beside
