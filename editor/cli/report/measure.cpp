#include "measure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <talus/sim/solver.h>
#include "cli/bench_kernel.h"
#include "cli/random.h"
#include "cli/timing.h"
#include "scenes.h"

namespace talus {
namespace {

using S = ReportScene;

constexpr double kNearEnd = 1.0 / 64;  // px: a motion that ends nearer to something may or may not meet it

// Rounds a coordinate at this scale to the row's precision.
double rounding(const Setup& setup) {
  return setup.scale *
         (setup.single ? std::numeric_limits<float>::epsilon() : std::numeric_limits<double>::epsilon());
}

// A compiled level, with its bodies outside of the ground.
struct Run {
  explicit Run(const Level& level)
      : scene(std::make_shared<const Scene>(compile_scene(level))),
        solver(make_solver(scene)),
        start(initial_state(*scene)) {
    for (Body& body : start.bodies) body.is_clear = true;
  }
  std::shared_ptr<const Scene> scene;
  std::unique_ptr<Solver> solver;
  State start;
};

// What a solver reports about one body.
struct Outcome {
  Rect to;
  std::optional<ContactRecord> first;  // contact
  bool met = false;                    // whether it met anything
};

// The article's bodies cross a slope before its floor is searched: such a contact has no time of impact.
bool is_met(const ContactRecord& contact) {
  return contact.handled &&
         (contact.response != Response::cross || (contact.slope && contact.slope->corrected));
}

std::vector<Outcome> outcomes(const State& end, const StepRecord& record) {
  std::vector<Outcome> found;
  for (const Body& body : end.bodies) found.push_back({body.box, {}, false});
  for (const ContactRecord& contact : record.contacts) {
    Outcome& outcome = found[static_cast<std::size_t>(contact.body - 1)];
    if (!is_met(contact)) continue;
    if (!outcome.met && contact.response != Response::cross) outcome.first = contact;
    outcome.met = true;
  }
  return found;
}

// The kernel records nothing: a ball that did not reach its goal met something.
std::vector<Outcome> outcomes(const BenchKernel& kernel, const std::vector<Drop>& drops) {
  std::vector<Outcome> found;
  for (std::size_t i = 0; i < drops.size(); ++i) {
    const Vec2 at = kernel.position(i);
    const Rect& start = drops[i].start;
    found.push_back({{at.x, at.y, start.w, start.h}, {}, at != start.position() + drops[i].motion});
  }
  return found;
}

// The larger of both: rounding has its limits in each coordinate.
double distance(Wide x, Wide y) { return static_cast<double>(std::max(std::abs(x), std::abs(y))); }

// Sums up drops.
struct DropTally {
  explicit DropTally(const Setup& of) : setup(of), floor(true_floor(of)) {}
  const Setup& setup;
  const TrueFloor floor;
  Errors geometry, impact;
  Counts counts;

  void add(const Drop& drop, const Outcome& outcome) {
    const Wide length = std::hypot(static_cast<Wide>(drop.motion.x), static_cast<Wide>(drop.motion.y));
    const bool hit = drop.impact <= 1;
    const bool clear = std::abs(drop.impact - 1) * length > kNearEnd;
    const Rect& to = outcome.to;
    const Wide under = Wide(to.y) + to.h - highest(floor, to.x, Wide(to.x) + to.w);  // px below the floor
    if (clear && hit && !outcome.met) ++counts.misses;
    if (clear && !hit && outcome.met) ++counts.ghosts;
    if (under > to.h / 2) ++counts.tunnels;
    if (is_teleport(drop.motion.x, drop.motion.y, to.x - drop.start.x, to.y - drop.start.y))
      ++counts.teleports;

    Wide error = hit ? off_floor(under) : distance(to.x - drop.x, to.y - drop.y);
    if (hit && outcome.first) {
      const ContactRecord& first = *outcome.first;
      error = std::max<Wide>(error, distance(first.touch.x - drop.x, first.touch.y - drop.y));
      if (setup.substeps == 1) impact.add(static_cast<double>(std::abs(first.ti - drop.impact) * length));
    }
    geometry.add(static_cast<double>(error));
  }

 private:
  // A box that slid on leaves a curved floor along the tangent; it may be above the floor, but never below.
  Wide off_floor(Wide under) const {
    return is_curve(setup.scene) ? std::max<Wide>(under, 0) : std::abs(under);
  }
};

template <class Step>
double median_ns(int repeats, std::size_t moves, Step step) {
  std::vector<double> times;
  times.reserve(static_cast<std::size_t>(repeats));
  for (int i = 0; i < repeats; ++i) times.push_back(step() / static_cast<double>(moves));
  return median(times);
}

void measure_drops(Row& row, const Effort& effort) {
  const std::vector<Drop> drops = report_drops(row.setup, effort.moves);
  Level level = report_level(row.setup);
  for (const Drop& drop : drops) add_body(level, drop.start, drop.motion);
  Run run(level);
  row.moves = drops.size();

  std::vector<Outcome> found;
  if (row.setup.solver) {
    State end = run.start;
    StepRecord record;
    run.solver->step(end, {}, &record);
    found = outcomes(end, record);
    row.ns = median_ns(effort.repeats, row.moves, [&] {
      end = run.start;
      return nanoseconds([&] { run.solver->step(end, {}); });
    });
  } else {
    row.ns = median_ns(effort.repeats, row.moves, [&] {
      BenchKernel kernel(level, run.start);
      const double ns = nanoseconds([&] { kernel.step(); });
      found = outcomes(kernel, drops);
      return ns;
    });
  }

  DropTally tally(row.setup);
  for (std::size_t i = 0; i < drops.size(); ++i) tally.add(drops[i], found[i]);
  row.geometry = tally.geometry.spread();
  row.impact = tally.impact.spread();
  row.counts = tally.counts;
}

// Pushes a box into a wall, slides it down and takes it away, and compares each move with its own answer.
class WallTally {
 public:
  explicit WallTally(const Setup& setup)
      : slack_(kNearEnd + 4 * rounding(setup)), factor_(factor_of(setup)) {}

  Errors geometry;
  Counts counts;
  std::size_t moves = 0;

  // wall: px, its left side. The mover is the last body of `state`.
  void run(Solver& solver, State& state, double wall) {
    const Rect start = state.bodies.back().box;
    const Rect at = step(solver, state, {8 * factor_, 0});
    if (at.right() > wall + slack_) ++counts.misses;
    if (at.right() > wall + start.w / 2) ++counts.tunnels;
    geometry.add(distance(Wide(at.x) + at.w - wall, Wide(at.y) - start.y));
    free_move(solver, state, {0, 40 * factor_});
    free_move(solver, state, {-5 * factor_, 0});
  }

 private:
  Rect step(Solver& solver, State& state, Vec2 motion) {
    Body& body = state.bodies.back();
    const Rect from = body.box;
    body.velocity = motion;
    solver.step(state, {});
    ++moves;
    if (is_teleport(motion.x, motion.y, body.box.x - from.x, body.box.y - from.y)) ++counts.teleports;
    return body.box;
  }

  void free_move(Solver& solver, State& state, Vec2 motion) {
    const Rect from = state.bodies.back().box;
    const Rect to = step(solver, state, motion);
    const double error = distance(Wide(to.x) - from.x - motion.x, Wide(to.y) - from.y - motion.y);
    if (error > slack_) ++counts.ghosts;
    geometry.add(error);
  }

  const double slack_, factor_;
};

// A box left of the upper half of a wall that begins at `wall`.
Rect beside(const Setup& setup, Vec2 wall, std::uint64_t& random) {
  const double factor = factor_of(setup), width = stored(setup, factor * next_between(random, 12, 13));
  const Vec2 at = stored(setup, {wall.x - width - factor * next_between(random, 1, 4),
                                 wall.y + factor * next_between(random, 20, 48)});
  return {at.x, at.y, width, 14 * factor};
}

void push_into_tiles(const Setup& setup, std::size_t count, WallTally& tally) {
  Level level = report_level(setup);
  const Vec2 wall = {wall_x(setup), report_origin(setup).y - 16 * factor_of(setup)};
  std::uint64_t random = 1;
  add_body(level, beside(setup, wall, random), {});
  Run run(level);
  for (std::size_t i = 0; i < count; ++i) {
    State state = run.start;
    state.bodies.back().box = beside(setup, wall, random);
    tally.run(*run.solver, state, wall.x);
  }
}

void push_into_bodies(const Setup& setup, std::size_t count, WallTally& tally) {
  std::uint64_t random = 1;
  for (std::size_t i = 0; i < count; ++i) {
    Level level = report_level(setup);
    const double x = setup.scale * next_between(random, 0, 1), y = setup.scale * next_between(random, 0, 1);
    const Vec2 wall = stored(setup, {x, y});
    add_body(level, {wall.x, wall.y, 16, 64}, {});
    add_body(level, {wall.x, stored(setup, wall.y + 64), 16, 64}, {});
    add_body(level, beside(setup, wall, random), {});
    Run run(level);
    State state = run.start;
    tally.run(*run.solver, state, wall.x);
  }
}

void measure_walls(Row& row, const Effort& effort) {
  WallTally tally(row.setup);
  const std::size_t count = std::max<std::size_t>(effort.moves / 4, 1);
  if (row.setup.scene == S::wall_of_bodies) {
    push_into_bodies(row.setup, count, tally);
  } else {
    push_into_tiles(row.setup, count, tally);
  }
  row.moves = tally.moves;
  row.geometry = tally.geometry.spread();
  row.counts = tally.counts;
}

// Measures balls over the frames of a run; differ(state, frame) adds their errors.
template <class Differ>
void measure_frames(Row& row, const Level& level, int frames, Differ differ) {
  Run run(level);
  State state = run.start;
  std::vector<double> times;
  for (int frame = 1; frame <= frames; ++frame) {
    times.push_back(nanoseconds([&] { run.solver->step(state, {}); }) /
                    static_cast<double>(state.bodies.size()));
    differ(state, frame);
  }
  row.moves = state.bodies.size() * static_cast<std::size_t>(frames);
  row.ns = median(times);
}

std::size_t balls_for(const Effort& effort) { return std::max<std::size_t>(effort.moves / 20, 1); }

void measure_rolls(Row& row, const Effort& effort) {
  const Setup& setup = row.setup;
  const bool slope = setup.scene == S::roll_slope;
  const auto floor = std::get<LineFloor>(true_floor(setup));
  const Wide steepness = (floor.y1 - floor.y0) / (floor.x1 - floor.x0);
  const Vec2 origin = report_origin(setup);
  Level level = report_level(setup);
  std::uint64_t random = 1;
  for (std::size_t i = 0; i < balls_for(effort); ++i) {
    const double x = origin.x + (slope ? next_between(random, 1600, 1900) : next_between(random, 200, 300));
    const auto y = static_cast<double>(highest(floor, x, x + kCartTileSize)) - kCartTileSize;
    const Vec2 at = stored(setup, {x, y - next_between(random, 10, 60)});
    add_body(level, {at.x, at.y, kCartTileSize, kCartTileSize},
             stored(setup, {next_between(random, -2, 2), 0}));
  }
  std::vector<WideBall> wide;
  for (const Spawn& s : level.spawns) {
    wide.push_back({s.position.x + kCartTileSize, s.position.y + kCartTileSize, s.velocity.x, s.velocity.y});
  }
  Errors errors;
  measure_frames(row, level, slope ? 120 : 300, [&](const State& state, int) {
    for (std::size_t i = 0; i < wide.size(); ++i) {
      step_ball(wide[i], level.tuning, floor.x0, floor.y0, steepness, setup.substeps);
      const Rect& box = state.bodies[i].box;
      errors.add(distance(Wide(box.x) + box.w - wide[i].x, Wide(box.y) + box.h - wide[i].y));
    }
  });
  row.trajectory = errors.spread();
}

void measure_bounces(Row& row, const Effort& effort) {
  const Setup& setup = row.setup;
  constexpr int kFrames = 240;
  const auto floor = static_cast<double>(std::get<LineFloor>(true_floor(setup)).y0);
  const Vec2 origin = report_origin(setup);
  Level level = report_level(setup);
  std::uint64_t random = 1;
  std::vector<std::vector<double>> right;
  for (std::size_t i = 0; i < balls_for(effort); ++i) {
    const double y = stored(setup, floor - kCartTileSize - next_between(random, 20, 100));
    add_body(level, {origin.x + 44, y, kCartTileSize, kCartTileSize}, {});
    right.push_back(bouncing(level.tuning, y + kCartTileSize - floor, kFrames));
  }
  Errors errors;
  measure_frames(row, level, kFrames, [&](const State& state, int frame) {
    for (std::size_t i = 0; i < right.size(); ++i) {
      const double bottom = state.bodies[i].box.bottom() - floor;
      errors.add(std::abs(bottom - right[i][static_cast<std::size_t>(frame)]));
    }
  });
  row.model = errors.spread();
}

}  // namespace

Row measure(const Setup& setup, const Effort& effort) {
  Row row;
  row.setup = setup;
  if (setup.scene >= S::bounce_fall) {
    measure_bounces(row, effort);
  } else if (setup.scene >= S::roll_flat) {
    measure_rolls(row, effort);
  } else if (setup.scene >= S::wall_of_tiles) {
    measure_walls(row, effort);
  } else {
    measure_drops(row, effort);
  }
  return row;
}

}  // namespace talus
