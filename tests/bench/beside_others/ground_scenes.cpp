// Single bodies on the ground: they slide, roll, swing, fall off and bounce.
#include <algorithm>
#include <cmath>

#include "reference/closed_forms.h"
#include "scene_parts.h"

namespace talus::beside {
namespace {

constexpr double kRadius = 4;  // px, of round bodies

Body round_body(Vec2 center, Vec2 velocity = {}) {
  return {{center.x - kRadius, center.y - kRadius, 2 * kRadius, 2 * kRadius}, velocity, true};
}

// ---- A slide ----

constexpr Vec2 kSlideFrom{40, 40}, kSlideTo{440, 440};

World slide() {
  World world{.width = 480, .height = 480, .gravity = kGravity, .material = kCrate};
  world.inclines = {{kSlideFrom, kSlideTo}};
  world.bodies = {{{60, 52, 8, 8}}};
  return world;
}

Values run_slide(const World& world, int frames, Engine& engine) {
  const double half = std::sqrt(0.5);  // sine and cosine of the slope
  double off = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    const Rect box = engine.box(0);
    off = std::max(off, std::abs(box.bottom() - box.x) * half);
  }
  const Vec2 way = engine.box(0).position() - world.bodies[0].at.position();
  const double right = kGravity * half * (1 - world.material.friction) * frames * frames / 2;
  return {std::abs(dot(way, {half, half}) - right), off};
}

// ---- A disc that rolls ----

World roll() {
  World world = slide();
  world.material = kDisc;
  const double off = kRadius * std::sqrt(0.5);
  world.bodies = {round_body({64 + off, 64 - off})};
  return world;
}

Values run_roll(const World& world, int frames, Engine& engine) {
  const double half = std::sqrt(0.5);  // sine and cosine of the slope
  double off = 0, slip = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    const Vec2 center = engine.box(0).center();
    off = std::max(off, std::abs((center.x - center.y) * half - kRadius));
    slip = std::max(slip, std::abs(length(engine.velocity(0)) - engine.spin(0)));
  }
  const Vec2 way = engine.box(0).position() - world.bodies[0].at.position();
  const double gain = reference::disc_down_incline(kGravity, 1, world.material.friction).gain;
  return {std::abs(dot(way, {half, half}) - gain * frames * frames / 2), off, slip};
}

// ---- A bowl ----

constexpr double kSwing = 0.8;  // radians, to both sides of the lowest place

// From the middle of what is round to the middle of a body on it, which goes around that.
double way_radius(const HalfCircle& half) { return half.radius + (half.is_hill ? kRadius : -kRadius); }

World bowl(Material material) {
  World world{.width = 256, .height = 256, .gravity = kGravity, .material = material};
  world.half_circles = {{{128, 128}, 64, false}};
  const double around = way_radius(world.half_circles[0]);
  world.bodies = {round_body({128 - around * std::sin(kSwing), 128 + around * std::cos(kSwing)})};
  return world;
}

// A third of what pulls a disc goes into its turning. The energy is that above the lowest place.
Values run_bowl(const World& world, int frames, Engine& engine) {
  const HalfCircle& bowl = world.half_circles[0];
  const double around = way_radius(bowl), power = kGravity * around * (1 - std::cos(kSwing));
  const double pull = world.material == kDisc ? kGravity * 2 / 3 : kGravity;
  reference::Pendulum exact{-kSwing, pull / around};
  double energy_error = 0, place_error = 0, off_error = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    exact.frame();
    const Vec2 off = engine.box(0).center() - bowl.center;
    const double now = energy(world, engine) / mass(world, 0) + kGravity * (around - off.y);
    energy_error = std::max(energy_error, std::abs(now / power - 1));
    const Vec2 right{around * std::sin(exact.angle), around * std::cos(exact.angle)};
    place_error = std::max(place_error, length(off - right));
    off_error = std::max(off_error, std::abs(length(off) - around));
  }
  return {energy_error, place_error, off_error};
}

// ---- A hill ----

World hill() {
  World world{.width = 256, .height = 256, .gravity = kGravity};
  world.half_circles = {{{96, 160}, 56, true}};
  const double around = way_radius(world.half_circles[0]);
  world.bodies = {round_body({96, 160 - around}, {0.5, 0})};
  return world;
}

// What has left the hill keeps its speed across. The energy is that above the top.
Values run_hill(const World& world, int frames, Engine& engine) {
  const double start = world.bodies[0].velocity.x, top = world.bodies[0].at.y;
  const double around = way_radius(world.half_circles[0]);
  double energy_error = 0;
  for (int i = 0; i < frames; ++i) {
    engine.step();
    const double gained = energy(world, engine) / mass(world, 0) - start * start / 2;
    energy_error = std::max(energy_error, std::abs(gained - kGravity * (engine.box(0).y - top)));
  }
  const double cosine = reference::cosine_where_it_leaves(start, kGravity, around);
  const double across = std::sqrt(kGravity * around * cosine) * cosine;
  return {energy_error / (kGravity * around), std::abs(engine.velocity(0).x - across)};
}

// ---- A fall ----

constexpr double kFall = 100;  // px

World fall() {
  World world = floor_world(kElastic);
  world.bodies = {{{120, 256 - kWall - 8 - kFall, 8, 8}}};
  return world;
}

Values run_fall(const World& world, int frames, Engine& engine) {
  const double top = world.bodies[0].at.y, takes = std::sqrt(2 * kFall / kGravity);  // frames
  double energy_error = 0, place_error = 0;
  for (int i = 1; i <= frames; ++i) {
    engine.step();
    const Vec2 v = engine.velocity(0);
    const double fallen = engine.box(0).y - top;
    const double power = dot(v, v) / 2 + kGravity * (kFall - fallen);
    energy_error = std::max(energy_error, std::abs(power / (kGravity * kFall) - 1));
    const double phase = std::remainder(i, 2 * takes);
    place_error = std::max(place_error, std::abs(fallen - kGravity * phase * phase / 2));
  }
  return {energy_error, place_error};
}

}  // namespace

std::vector<ErrorScene> ground_scenes() {
  const std::vector<std::string> of_bowl{kEnergy, kPlace, "off the bowl, px"};
  return {{"slide", slide(), 100, {"way, px", "off the line, px"}, run_slide},
          {"rolling disc", roll(), 100, {"way, px", "off the line, px", "rim's slip, px/frame"}, run_roll},
          {"marble in a bowl", bowl(kElastic), 1000, of_bowl, run_bowl},
          {"disc in a bowl", bowl(kDisc), 1000, of_bowl, run_bowl},
          {"marble off a hill", hill(), 60, {kEnergy, "speed across, px/frame"}, run_hill},
          {"fall and bounce", fall(), 1000, {kEnergy, kPlace}, run_fall}};
}

}  // namespace talus::beside
