// What recording adds to a step, and how long a seek in an hour takes. Both report the promised number as a
// counter; the benchmark's own times say less.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "sim/timeline.h"

namespace talus {
namespace {

constexpr std::int64_t kGroup = 64;  // steps measured together, with one keyframe of 1,000 bodies

// Processor time of this thread, so that other work of the machine does not count.
double nanoseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) * 1e9 + static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Floors with steps in them. Lively balls lose no speed and never come to rest; tiring ones are the
// article's.
enum Balls { kLively, kTiring };
Level level_with(int bodies, SolverKind solver, Balls balls) {
  Level level;
  level.tuning.solver = solver;
  level.tuning.shared.bodies = 0;
  if (balls == kLively) {
    level.tuning.shared.floor_bounce = level.tuning.shared.floor_grip = 1;
    level.tuning.shared.drift_blend = 0;
  }
  auto& flags = level.sheet(SheetId::tiles).flags;
  flags[1] = 1;
  for (Cell c{0, 0}; c.y < 136; ++c.y) {
    for (c.x = 0; c.x < 240; ++c.x) {
      if (c.y % 8 == 7 || (c.y % 8 == 6 && c.x % 8 == 3)) level.map.set(c, 1);
    }
  }
  for (int i = 0; i < bodies; ++i) {
    Spawn spawn;
    spawn.position = {(i % 50) * 38.0 + 5, (i / 50 % 16) * 64.0 + 20};
    spawn.velocity = {i % 7 - 3.0, 0};
    level.spawns.push_back(spawn);
  }
  return level;
}

// A solver alone and a timeline step the same frames of 1,000 bodies in turns. ratio: the median step of the
// timeline, with its share of keyframes, divided by the solver's. with_record: both record contacts.
void record(benchmark::State& state, SolverKind kind, Balls balls, bool with_record) {
  const Level level = level_with(1'000, kind, balls);
  const auto scene = std::make_shared<const Scene>(compile_scene(level));
  std::vector<double> alone, recorded;
  for (auto _ : state) {
    const auto solver = make_solver(scene);
    State bodies = initial_state(*scene);
    StepRecord record;
    Timeline timeline(level);
    for (int i = 0; balls == kTiring && i < 960; ++i) {
      solver->step(bodies, {}, nullptr);
      timeline.step({}, false);
    }
    for (int round = 0; round < 30; ++round) {
      const double first = nanoseconds();
      for (int i = 0; i < kGroup; ++i) solver->step(bodies, {}, with_record ? &record : nullptr);
      alone.push_back(nanoseconds() - first);
      const double second = nanoseconds();
      for (int i = 0; i < kGroup; ++i) timeline.step({}, with_record);
      recorded.push_back(nanoseconds() - second);
    }
    if (timeline.state() != bodies) state.SkipWithError("the recording changed a result");
  }
  state.counters["ratio"] = median(recorded) / median(alone);
  state.counters["step_us"] = median(alone) / kGroup / 1e3;
}

// An hour of 100 bodies at 60 frames a second, and seeks all over it. ms: the longest and the median seek.
void seek(benchmark::State& state, SolverKind kind) {
  constexpr std::int64_t kHour = 216'000;
  Timeline timeline(level_with(100, kind, kLively));
  for (std::int64_t i = 0; i < kHour; ++i) timeline.step({.mouse = {}, .right = i % 64 < 32}, false);
  std::vector<double> times;
  std::int64_t frame = 1;
  for (auto _ : state) {
    frame = frame * 48'271 % kHour;
    const double begin = nanoseconds();
    timeline.seek(frame);
    times.push_back((nanoseconds() - begin) / 1e6);
  }
  state.counters["median_ms"] = median(times);
  state.counters["longest_ms"] = *std::max_element(times.begin(), times.end());
  state.counters["keyframe_MB"] = static_cast<double>(timeline.keyframe_bytes()) / 1e6;
  state.counters["stride"] = static_cast<double>(timeline.keyframe_stride());
}

BENCHMARK_CAPTURE(record, article, SolverKind::article, kLively, false)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(record, bump, SolverKind::bump, kLively, false)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(record, exact, SolverKind::exact, kLively, false)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(record, exact_at_rest, SolverKind::exact, kTiring, false)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(record, exact_contacts, SolverKind::exact, kLively, true)
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seek, article, SolverKind::article)->Iterations(500)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seek, bump, SolverKind::bump)->Iterations(500)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(seek, exact, SolverKind::exact)->Iterations(500)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace talus
