#include "scenes.h"

#include <cmath>
#include <numbers>

#include "cli/random.h"

namespace talus {
namespace {

using S = ReportScene;
constexpr TileNumber kSolidTile = 1, kSlopeTile = 2;
constexpr int kHillSlopes = 12;  // slopes of the hillside

// Places in px and cells, from the origin of the scene.
constexpr double kFlatY = 88;
constexpr Cell kHillFoot = {4, 11};  // the first slope's cell
constexpr Segment kLine = {{3.25, 100.5}, {203.75, 4.25}};
constexpr Segment kLongLine = {{0, 600.25}, {2000, 100.5}};
constexpr Vec2 kArcCenter = {128, 128};
constexpr double kArcRadius = 64, kArcHalf = 45;
constexpr double kSineLeft = 64, kSineWidth = 128, kSineY = 64, kSineHeight = 8, kSineWave = 64;
constexpr int kWallColumn = 16;

// The part of the map that a scene needs, in cells. It is low, or narrow, so that long maps may have it at
// their far end.
Cell ground_size(S scene) {
  if (scene == S::roll_slope) return {256, 76};
  if (scene >= S::bounce_fall) return {12, 13};
  return {scene == S::roll_flat ? 64 : 32, 13};
}

Segment moved(const Segment& line, Vec2 by) { return {line.from + by, line.to + by}; }

Arc arc_at(Vec2 origin) {
  const Vec2 center = origin + kArcCenter;
  return {center, kArcRadius, center.x - kArcHalf, center.x + kArcHalf, true};
}

Sine sine_at(Vec2 origin) {
  const double left = origin.x + kSineLeft;
  return {left, left + kSineWidth, origin.y + kSineY, kSineHeight, kSineWave, left};
}

double height(const Arc& arc, double x) {
  const double u = x - arc.center.x;
  return arc.center.y - std::sqrt((arc.radius - u) * (arc.radius + u));
}
double height(const Sine& sine, double x) {
  return sine.middle + sine.amplitude * std::sin(2 * std::numbers::pi * (x - sine.origin) / sine.wavelength);
}

template <class Form>
Curve curve_of(const Form& form, int segments) {
  if (segments == 0) return {form};
  Polyline line{form.x0, form.x1, {}};
  for (int i = 0; i <= segments; ++i) {
    line.ys.push_back(height(form, form.x0 + (form.x1 - form.x0) * i / segments));
  }
  return {line};
}

void lay_floor(Level& level, Cell at, int columns) {
  for (int x = at.x; x < at.x + columns; ++x) level.map.set({x, at.y}, kSolidTile);
}

void lay_hill(Level& level, Cell corner) {
  for (int i = 0; i < kHillSlopes; ++i) {
    const Cell slope = {corner.x + kHillFoot.x + 2 * i, corner.y + kHillFoot.y - i};
    level.map.set(slope, kSlopeTile);
    for (int y = slope.y + 1; y <= corner.y + kHillFoot.y + 1; ++y) {
      lay_floor(level, {slope.x, y}, 2);
    }
  }
}

// Velocities stay as they are, except that contacts take away the part into the ground.
void tune_drops(Tuning& tuning) {
  SharedTuning& t = tuning.shared;
  t.fall_blend = t.drift_blend = 0;
  t.floor_bounce = t.wall_bounce = t.slope_bounce = 0;
  t.floor_grip = 1;
}

void tune(const Setup& setup, Tuning& tuning) {
  tuning.solver = setup.solver.value_or(SolverKind::article);
  tuning.exact.single_precision = setup.single ? 1 : 0;
  tuning.exact.substeps = setup.substeps;
  tuning.shared.bodies = setup.scene == S::wall_of_bodies ? 1 : 0;
  if (setup.scene < S::roll_flat) tune_drops(tuning);
  if (setup.scene < S::bounce_fall) return;
  tuning.shared.floor_bounce = tuning.shared.floor_grip = 1;
  tuning.shared.drift_blend = 0;
  if (setup.scene == S::bounce_fall) return;
  tuning.exact.gravity = 0.25;
  tuning.exact.rebound = setup.scene == S::bounce_rebound ? 1 : 0;
}

LineFloor wide(const Segment& line) { return {line.from.x, line.from.y, line.to.x, line.to.y}; }

}  // namespace

double stored(const Setup& setup, double value) {
  return setup.single ? static_cast<double>(static_cast<float>(value)) : value;
}
Vec2 stored(const Setup& setup, Vec2 value) { return {stored(setup, value.x), stored(setup, value.y)}; }

Vec2 report_origin(const Setup& setup) {
  const double at = std::floor(setup.scale / setup.tile) * setup.tile;
  if (setup.scale <= kMaxSquareScale) return {at, at};
  return setup.scene >= S::bounce_fall ? Vec2{0, at} : Vec2{at, 0};
}

double wall_x(const Setup& setup) { return report_origin(setup).x + kWallColumn * setup.tile; }

Level report_level(const Setup& setup) {
  Level level;
  level.tuning = new_tuning({setup.tile, setup.tile});
  tune(setup, level.tuning);
  if (setup.scene == S::wall_of_bodies) {
    level.map = TileMap(1, 1);
    return level;
  }
  const Vec2 origin = report_origin(setup);
  const Cell corner = {static_cast<int>(origin.x) / setup.tile, static_cast<int>(origin.y) / setup.tile};
  const Cell size = ground_size(setup.scene);
  level.map = TileMap(corner.x + size.x + 1, corner.y + size.y, {setup.tile, setup.tile});
  level.sheet(SheetId::tiles).flags[kSolidTile] = flag_bit(level.roles.solid);
  level.sheet(SheetId::tiles).flags[kSlopeTile] = flag_bit(level.roles.up_slope);
  const auto add = [&](const Curve& curve) { level.curves.push_back({"", curve, ""}); };
  switch (setup.scene) {
    case S::slope_tiles:
    case S::tiny_bodies:
      lay_hill(level, corner);
      break;
    case S::segment:
      add({moved(kLine, origin)});
      break;
    case S::roll_slope:
      add({moved(kLongLine, origin)});
      break;
    case S::arc:
      add(curve_of(arc_at(origin), setup.segments));
      break;
    case S::sine:
      add(curve_of(sine_at(origin), setup.segments));
      break;
    case S::wall_of_tiles:
      for (int y = 0; y < size.y; ++y) level.map.set({corner.x + kWallColumn, corner.y + y}, kSolidTile);
      break;
    default:
      lay_floor(level, {corner.x, corner.y + static_cast<int>(kFlatY) / kCartTileSize}, size.x);
  }
  return level;
}

TrueFloor true_floor(const Setup& setup) {
  const Vec2 origin = report_origin(setup);
  switch (setup.scene) {
    case S::slope_tiles:
    case S::tiny_bodies: {
      const double tile = setup.tile;
      const Vec2 foot = origin + Vec2{kHillFoot.x * tile, (kHillFoot.y + 1) * tile};
      return wide({foot, foot + Vec2{2 * kHillSlopes * tile, -kHillSlopes * tile}});
    }
    case S::segment:
      return wide(moved(kLine, origin));
    case S::roll_slope:
      return wide(moved(kLongLine, origin));
    case S::arc: {
      const Arc arc = arc_at(origin);
      return ArcFloor{arc.center.x, arc.center.y, arc.radius};
    }
    case S::sine: {
      const Sine sine = sine_at(origin);
      return SineFloor{sine.middle, sine.amplitude, sine.wavelength, sine.origin};
    }
    default: {
      const Wide y = origin.y + kFlatY * factor_of(setup);
      return LineFloor{origin.x, y, origin.x + 256, y};
    }
  }
}

std::vector<Drop> report_drops(const Setup& setup, std::size_t count) {
  const TrueFloor floor = true_floor(setup);
  const Vec2 origin = report_origin(setup);
  const double size = setup.scene == S::tiny_bodies ? 1.0 / 64 : setup.tile, factor = factor_of(setup);
  std::uint64_t random = 1;
  std::vector<Drop> drops(count);
  for (Drop& drop : drops) {
    const double x = origin.x + factor * next_between(random, 92, 156);
    const double speed = factor * next_between(random, 3, 8);
    const double gap = 2 * factor + speed * next_between(random, 0, 1.2);
    const auto y = static_cast<double>(highest(floor, x, x + size)) - size - gap;
    const Vec2 at = stored(setup, {x, y});
    drop.start = {at.x, at.y, size, size};
    drop.motion = stored(setup, {speed * next_between(random, -0.8, 0.8), speed});
    drop.impact = time_of_impact(floor, {at.x, at.y, size, size}, drop.motion.x, drop.motion.y);
    const Wide share = drop.impact > 1 ? 1 : drop.impact;
    drop.x = at.x + share * drop.motion.x;
    drop.y = at.y + share * drop.motion.y;
  }
  return drops;
}

void add_body(Level& level, const Rect& box, Vec2 velocity) {
  Spawn spawn;
  spawn.position = box.position();
  spawn.size = {box.w, box.h};
  spawn.velocity = velocity;
  level.spawns.push_back(spawn);
}

}  // namespace talus
