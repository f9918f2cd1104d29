#include "meetings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <talus/level/level.h>
#include <talus/sim/solver.h>
#include "cli/random.h"
#include "cli/timing.h"
#include "debug/metrics.h"
#include "scenes.h"
#include "sim/meet/form.h"

namespace talus {
namespace {

constexpr std::array kSubsteps = {1, 2, 4};
constexpr double kGravity = 0.25;  // px/frame^2

// Where the first coordinates of the bodies are right, by frame.
using Places = std::function<std::vector<Vec2>(int frame)>;

struct MeetingScene {
  std::string_view name, meaning;
  int frames = 0;
  Level level;
  Places right = {};        // empty: no closed form
  bool is_free = false;     // nothing but the bodies gives or takes momentum
  bool is_elastic = false;  // energy is kept
};

// Nothing slows bodies down, and all bounce as fast as they came.
Level open_level(int columns, int rows, double gravity) {
  Level level;
  level.map = TileMap(columns, rows);
  level.sheet(SheetId::tiles).flags[1] = flag_bit(level.roles.solid);
  Tuning& t = level.tuning;
  t.solver = SolverKind::exact;
  t.shared.bodies = static_cast<double>(BodyPairs::meet);
  t.shared.fall_blend = t.shared.drift_blend = 0;
  t.shared.floor_bounce = t.shared.wall_bounce = 1;
  t.exact.gravity = gravity;
  t.exact.rebound = 1;
  return level;
}

// The same with solid tiles around it.
Level room(int columns, int rows, double gravity) {
  Level level = open_level(columns, rows, gravity);
  for (int x = 0; x < columns; ++x)
    for (const int y : {0, rows - 1}) level.map.set({x, y}, 1);
  for (int y = 0; y < rows; ++y)
    for (const int x : {0, columns - 1}) level.map.set({x, y}, 1);
  return level;
}

void add(Level& level, Rect box, Vec2 velocity, BodyKind kind = BodyKind::ball) {
  add_body(level, box, velocity);
  level.spawns.back().kind = kind;
}

// ---- Scenes ----

MeetingScene cradle() {
  MeetingScene scene{"cradle", "Five equal boxes in a row; the first comes at 2 px a frame.", 60,
                     open_level(64, 4, 0)};
  scene.is_free = scene.is_elastic = true;
  std::vector<Vec2> start;
  for (int i = 0; i < 5; ++i) {
    start.push_back({i == 0 ? 41.3 : 100.0 + 8 * i, 8});
    add(scene.level, {start.back().x, 8, 8, 8}, {i == 0 ? 2.0 : 0.0, 0});
  }
  scene.right = [start](int frame) {
    std::vector<Vec2> at = start;
    const double way = 2.0 * frame, gap = 100 - 41.3;
    at.front().x += std::min(way, gap);
    at.back().x += std::max(way - gap, 0.0);
    return at;
  };
  return scene;
}

MeetingScene unequal() {
  MeetingScene scene{"masses 1 and 1000", "A light box and a heavy one run into each other.", 60,
                     open_level(128, 40, 0)};
  scene.is_free = scene.is_elastic = true;
  const Rect light{100, 100, 8, 8}, heavy{130, 20, 256, 250};
  const double v = 2, w = -1, ratio = 1000;
  add(scene.level, light, {v, 0});
  add(scene.level, heavy, {w, 0});
  scene.right = [=](int frame) {
    const double meets = (heavy.x - light.right()) / (v - w), after = std::max(frame - meets, 0.0);
    const double before = std::min<double>(frame, meets);
    const double v1 = (v + ratio * w + ratio * (w - v)) / (1 + ratio);
    const double w1 = (v + ratio * w + (v - w)) / (1 + ratio);
    return std::vector<Vec2>{{light.x + v * before + v1 * after, light.y},
                             {heavy.x + w * before + w1 * after, heavy.y}};
  };
  return scene;
}

// Thirty bodies of all sizes.
MeetingScene closed_room(std::string_view name, std::string_view meaning, BodyKind kind) {
  MeetingScene scene{name, meaning, 1000, room(40, 30, 0)};
  scene.is_elastic = true;
  std::uint64_t random = 1;
  for (int i = 0; i < 30; ++i) {
    const double w = next_between(random, 4, 24);
    const double h = kind == BodyKind::marble ? w : next_between(random, 4, 24);
    const double vx = next_between(random, -3, 3), vy = next_between(random, -3, 3);
    add(scene.level, {12 + 49.0 * (i % 6), 12 + 44.0 * (i / 6), w, h}, {vx, vy}, kind);
  }
  return scene;
}

MeetingScene gas() {
  return closed_room("closed room", "Thirty boxes of all sizes fly about in a closed room.", BodyKind::ball);
}

MeetingScene bounce() {
  MeetingScene scene{"bounce", "A box falls and bounces for ever.", 1000, room(8, 20, kGravity)};
  scene.is_elastic = true;
  const double top = 40.3, drop = 19 * 8 - 8 - top;
  add(scene.level, {24, top, 8, 8}, {});
  scene.right = [=](int frame) {
    const double half = std::sqrt(2 * drop / kGravity);
    const double t = std::remainder(frame, 2 * half);  // frames from the nearest highest place
    return std::vector<Vec2>{{24, top + kGravity * t * t / 2}};
  };
  return scene;
}

MeetingScene incline() {
  MeetingScene scene{"incline", "A crate slides down a slope of 3 in 4, with its friction of 0.5.", 100,
                     open_level(64, 64, kGravity)};
  scene.level.curves.push_back({"", {Segment{{0, 100}, {400, 400}}, Curve::Faces::up}, ""});
  const Vec2 start{40, 130 - 8};  // on its lower left corner
  add(scene.level, {start.x, start.y, 8, 8}, {}, BodyKind::crate);
  scene.right = [=](int frame) {
    const double way = kGravity * (0.6 - 0.5 * 0.8) * frame * frame / 2;
    return std::vector<Vec2>{{start.x + 0.8 * way, start.y + 0.6 * way}};
  };
  return scene;
}

MeetingScene stack() {
  MeetingScene scene{"stack", "Ten crates rest on one another.", 1000, room(8, 20, kGravity)};
  std::vector<Vec2> start;
  for (int i = 0; i < 10; ++i) {
    start.push_back({24, 19.0 * 8 - 8 * (i + 1)});
    add(scene.level, {start.back().x, start.back().y, 8, 8}, {}, BodyKind::crate);
  }
  scene.right = [start](int) { return start; };
  return scene;
}

MeetingScene pyramid() {
  MeetingScene scene{"pyramid", "55 crates fall a little way into a pyramid, and rest.", 600,
                     room(20, 20, kGravity)};
  for (int row = 0; row < 10; ++row)
    for (int i = 0; i < 10 - row; ++i)
      add(scene.level, {20 + 4.0 * row + 9 * i, 19.0 * 8 - 8.5 * (row + 1), 8, 8}, {}, BodyKind::crate);
  return scene;
}

MeetingScene pile() {
  MeetingScene scene{"pile", "300 crates fall into a bin.", 400, room(24, 80, kGravity)};
  std::uint64_t random = 1;
  for (int i = 0; i < 300; ++i) {
    const double x = 10 + 17.0 * (i % 10) + next_between(random, 0, 7), y = 10 + 17.0 * (i / 10);
    add(scene.level, {x, y, next_between(random, 5, 9), next_between(random, 5, 15)}, {}, BodyKind::crate);
  }
  return scene;
}

MeetingScene valley() {
  MeetingScene scene{"valley", "30 crates fall into a valley of two slopes of 3 in 4.", 400,
                     open_level(32, 32, kGravity)};
  scene.level.curves = {{"", {Segment{{8, 100}, {128, 190}}, Curve::Faces::up}, ""},
                        {"", {Segment{{128, 190}, {248, 100}}, Curve::Faces::up}, ""}};
  std::uint64_t random = 1;
  for (int i = 0; i < 30; ++i) {
    const double x = 52 + 26.0 * (i % 6) + next_between(random, 0, 9), y = 10 + 17.0 * (i / 6);
    add(scene.level, {x, y, next_between(random, 5, 12), next_between(random, 5, 15)}, {}, BodyKind::crate);
  }
  return scene;
}

// ---- Scenes of circles ----

MeetingScene marbles() {
  return closed_room("marbles", "Thirty marbles of all sizes fly about in a closed room.", BodyKind::marble);
}

MeetingScene rolling() {
  MeetingScene scene{"rolling", "A disc rolls down a slope of 3 in 4.", 80, open_level(64, 64, kGravity)};
  scene.level.curves.push_back({"", {Segment{{0, 100}, {400, 400}}, Curve::Faces::up}, ""});
  const Vec2 start{40 + 4 * 0.6 - 4, 130 - 4 * 0.8 - 4};
  add(scene.level, {start.x, start.y, 8, 8}, {}, BodyKind::disc);
  scene.right = [=](int frame) {
    const double way = kGravity * 0.6 * 2 / 3 * frame * frame / 2;
    return std::vector<Vec2>{{start.x + 0.8 * way, start.y + 0.6 * way}};
  };
  return scene;
}

MeetingScene bowl() {
  MeetingScene scene{"bowl", "A disc rolls to and fro in a round bowl.", 3000, open_level(32, 24, kGravity)};
  scene.is_elastic = true;
  scene.level.curves.push_back({"", {Arc{{128, 60}, 60, 68, 188, false}, Curve::Faces::up}, ""});
  const double around = 60 - 4, angle = 0.6;
  add(scene.level, {128 - around * std::sin(angle) - 4, 60 + around * std::cos(angle) - 4, 8, 8}, {},
      BodyKind::disc);
  return scene;
}

MeetingScene pile_of_discs() {
  MeetingScene scene{"pile of discs", "60 discs fall into a bin.", 400, room(14, 60, kGravity)};
  std::uint64_t random = 1;
  for (int i = 0; i < 60; ++i) {
    const double side = next_between(random, 5, 12);
    const double x = 10 + 16.0 * (i % 6) + next_between(random, 0, 3), y = 10 + 17.0 * (i / 6);
    add(scene.level, {x, y, side, side}, {}, BodyKind::disc);
  }
  return scene;
}

std::vector<MeetingScene> meeting_scenes() {
  return {cradle(), unequal(), gas(),     bounce(),  incline(), stack(),        pyramid(),
          pile(),   valley(),  marbles(), rolling(), bowl(),    pile_of_discs()};
}

// ---- Measures ----

double mass(const Body& body) { return mass_of(body.kind, {body.box.w, body.box.h}); }

Vec2 momentum(const State& state) {
  Vec2 sum;
  for (const Body& body : state.bodies) sum = sum + body.velocity * mass(body);
  return sum;
}

double energy(const State& state, double gravity) {
  double sum = 0;
  for (const Body& body : state.bodies) {
    const double turning = body.spin * body.spin / 4;  // half of a disc's mass counts at its rim
    sum += mass(body) * (dot(body.velocity, body.velocity) / 2 + turning - gravity * body.box.y);
  }
  return sum;
}

// px
double deepest_overlap(const State& state) {
  const auto form = [](const Body& body) {
    return Form{body.box, radius_of(body.kind, {body.box.w, body.box.h})};
  };
  double deepest = 0;
  for (std::size_t i = 0; i < state.bodies.size(); ++i)
    for (std::size_t k = 0; k < i; ++k)
      deepest = std::max(deepest, -nearness(form(state.bodies[i]), form(state.bodies[k]), true).gap);
  return deepest;
}

void raise(std::optional<double>& most, double value) { most = std::max(most.value_or(0), value); }

MeetingRow measure(MeetingScene scene, int substeps, double share) {
  MeetingRow row;
  row.scene = scene.name;
  row.meaning = scene.meaning;
  row.substeps = substeps;
  scene.level.tuning.exact.substeps = substeps;
  const double gravity = scene.level.tuning.exact.gravity;
  const auto compiled = std::make_shared<const Scene>(compile_scene(scene.level));
  const auto solver = make_solver(compiled);
  State state = initial_state(*compiled);
  const Vec2 first_momentum = momentum(state);
  const double first_energy = energy(state, gravity);
  row.bodies = state.bodies.size();
  row.frames = std::max(1, static_cast<int>(scene.frames * share));
  std::vector<double> times;
  for (int frame = 1; frame <= row.frames; ++frame) {
    times.push_back(nanoseconds([&] { solver->step(state, {}); }) / static_cast<double>(row.bodies));
    if (row.bodies > 1) raise(row.penetration, deepest_overlap(state));
    if (scene.is_free) raise(row.momentum, length(momentum(state) - first_momentum) / length(first_momentum));
    if (scene.is_elastic)
      raise(row.energy, std::abs(energy(state, gravity) - first_energy) / std::abs(first_energy));
    if (!scene.right) continue;
    const std::vector<Vec2> right = scene.right(frame);
    for (std::size_t i = 0; i < right.size(); ++i)
      raise(row.error, length(state.bodies[i].box.position() - right[i]));
  }
  row.ns = median(times);
  return row;
}

std::string cell(const std::optional<double>& value) { return value ? csv_number(*value) : ""; }

// Two significant digits, for people.
std::string shown(const std::optional<double>& value) {
  if (!value) return "";
  char text[32];
  std::snprintf(text, sizeof text, *value >= 100 ? "%.0f" : "%.2g", *value);
  return text;
}

}  // namespace

std::vector<MeetingRow> measure_meetings(double share) {
  std::vector<MeetingRow> rows;
  for (const MeetingScene& scene : meeting_scenes()) {
    for (const int substeps : kSubsteps) rows.push_back(measure(scene, substeps, share));
  }
  return rows;
}

std::string meetings_csv(std::span<const MeetingRow> rows, const BuildFacts& facts) {
  std::string csv =
      "scene,substeps,bodies,frames,ns_per_body_and_frame,momentum_drift,energy_drift,penetration_max_px,"
      "error_max_px,commit,compiler,flags,cpu\n";
  for (const MeetingRow& row : rows) {
    csv += '"' + std::string(row.scene) + "\"," + std::to_string(row.substeps) + ',' +
           std::to_string(row.bodies) + ',' + std::to_string(row.frames) + ',' + csv_number(row.ns) + ',' +
           cell(row.momentum) + ',' + cell(row.energy) + ',' + cell(row.penetration) + ',' + cell(row.error) +
           ',' + facts_of_csv(facts) + '\n';
  }
  return csv;
}

std::string meetings_section(std::span<const MeetingRow> rows) {
  std::string page = R"(## Bodies that meet

Boxes and circles with the tuning `bodies: meet` of `exact`, in double precision; all rows are in `meetings.csv`. Momentum and energy: the
largest drift in any frame, as a share of what there was at the start, where nothing else may change them. Penetration: the deepest
overlap of two bodies in any frame, px. Error: the largest distance of a body from the closed form in any frame, px.

| scene | sub-steps | bodies | frames | ns a body and frame | momentum | energy | penetration | error |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
)";
  for (const MeetingRow& row : rows) {
    page += "| " + std::string(row.scene) + " | " + std::to_string(row.substeps) + " | " +
            std::to_string(row.bodies) + " | " + std::to_string(row.frames) + " | " + shown(row.ns) + " | " +
            shown(row.momentum) + " | " + shown(row.energy) + " | " + shown(row.penetration) + " | " +
            shown(row.error) + " |\n";
  }
  page += '\n';
  for (const MeetingRow& row : rows) {
    if (row.substeps == kSubsteps.front())
      page += "- " + std::string(row.scene) + ": " + std::string(row.meaning) + '\n';
  }
  return page + '\n';
}

}  // namespace talus
