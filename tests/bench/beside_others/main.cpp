// talus_beside_others: errors and times of Talus, Box2D and Chipmunk in the same scenes.
//   talus_beside_others [--bodies N] [--rounds N] [--scene WORD] [--engine WORD] [--table]
// --scene and --engine: only those whose name has the word in it. --table: as Markdown.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <iostream>
#include <optional>
#include <string_view>

#include "measures.h"
#include "same_scenes.h"
#include "text_table.h"

namespace talus::beside {
namespace {

struct Options {
  int bodies = 1000, rounds = 5;
  std::string scene, engine;
  bool is_markdown = false;
};

// Nanoseconds of processor time, since other programs may run beside this one.
double now() {
  timespec time{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) * 1e9 + static_cast<double>(time.tv_nsec);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// By contestant, the times of all rounds.
using Times = std::vector<std::vector<double>>;

double step(Engine& engine, int frames) {
  const double before = now();
  for (int i = 0; i < frames; ++i) engine.step();
  return now() - before;
}

bool has(const std::string& name, const std::string& word) { return name.find(word) != std::string::npos; }

class Comparison {
 public:
  explicit Comparison(const Options& options) : options_(options) {
    for (const auto& make : {talus_engines, box2d_engines, chipmunk_engines})
      for (Contestant& c : make())
        if (has(c.name, options.engine)) contestants_.push_back(std::move(c));
    std::vector<std::string> names;
    for (const Contestant& c : contestants_) names.push_back(c.name);
    errors_.add({"scene", "error"}, names);
    times_.add({"scene"}, names);
  }

  bool is_empty() const { return contestants_.empty(); }

  void run() {
    for (const auto& scenes : {impact_scenes(), ground_scenes(), pile_scenes()})
      for (const ErrorScene& scene : scenes) {
        if (!has(scene.name, options_.scene)) continue;
        find_errors(scene);
        time_error_scene(scene);
      }
    auto speed = speed_scenes(options_.bodies);
    for (SpeedScene& scene : speed) {
      // What comes after the last phase that is asked for need not run.
      auto& phases = scene.phases;
      while (!phases.empty() && (phases.back().name.empty() || !has(phases.back().name, options_.scene)))
        phases.pop_back();
      if (!phases.empty()) time_speed_scene(scene);
    }
    std::cout << "Errors\n\n" << errors_.text(options_.is_markdown) << "\nns for a body and frame";
    std::cout << " (times the first column)\n\n" << times_.text(options_.is_markdown);
  }

 private:
  void find_errors(const ErrorScene& scene) {
    std::vector<std::vector<std::string>> cells(scene.measures.size());
    for (const Contestant& c : contestants_) {
      const auto engine = c.make(scene.world);
      const auto values = scene.run(scene.world, scene.frames, *engine);
      for (std::size_t i = 0; i < values.size(); ++i) cells[i].push_back(short_number(values[i]));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) errors_.add({scene.name, scene.measures[i]}, cells[i]);
  }

  // Short scenes run again and again, for 10 ms in each round.
  void time_error_scene(const ErrorScene& scene) {
    constexpr double kEnough = 1e7;  // ns
    Times times(contestants_.size());
    for (int round = 0; round < options_.rounds; ++round) {
      for (std::size_t k = 0; k < contestants_.size(); ++k) {
        double time = 0, steps = 0;
        while (time < kEnough) {
          const auto engine = contestants_[k].make(scene.world);
          time += step(*engine, scene.frames);
          steps += scene.frames * static_cast<double>(scene.world.bodies.size());
        }
        times[k].push_back(time / steps);
      }
    }
    add_times(scene.name, times);
  }

  void time_speed_scene(const SpeedScene& scene) {
    std::vector<Times> times(scene.phases.size(), Times(contestants_.size()));
    std::vector<std::vector<std::string>> overlaps(scene.phases.size());
    std::vector<std::string> lost, moving;
    const double bodies = static_cast<double>(scene.world.bodies.size());
    for (int round = 0; round < options_.rounds; ++round) {
      for (std::size_t k = 0; k < contestants_.size(); ++k) {
        const auto engine = contestants_[k].make(scene.world);
        for (std::size_t i = 0; i < scene.phases.size(); ++i) {
          const int frames = scene.phases[i].frames;
          times[i][k].push_back(step(*engine, frames) / (bodies * frames));
          if (round == 0) overlaps[i].push_back(short_number(deepest_overlap(scene.world, *engine)));
        }
        if (round > 0) continue;
        lost.push_back(std::to_string(count_lost(scene.world, *engine)));
        moving.push_back(std::to_string(count_moving(scene.world, *engine)));
      }
    }
    const std::string size = std::to_string(scene.world.bodies.size()) + " ";
    for (std::size_t i = 0; i < scene.phases.size(); ++i) {
      if (scene.phases[i].name.empty()) continue;
      add_times(size + scene.phases[i].name, times[i]);
      errors_.add({size + scene.phases[i].name, "overlap at the end, px"}, overlaps[i]);
    }
    if (scene.phases.size() == 1) return;
    errors_.add({size + scene.phases.back().name, "bodies that went through a wall"}, lost);
    errors_.add({size + scene.phases.back().name, "bodies that move"}, moving);
  }

  void add_times(const std::string& name, const Times& times) {
    std::vector<std::string> cells;
    const double first = median(times[0]);
    for (const auto& of_one : times) {
      const double time = median(of_one);
      cells.push_back(whole_number(time) + " (" + short_number(time / first) + ")");
    }
    times_.add({name}, cells);
  }

  Options options_;
  std::vector<Contestant> contestants_;
  TextTable errors_, times_;
};

std::optional<Options> parse(int count, char** words) {
  Options options;
  for (int i = 1; i < count; ++i) {
    const std::string_view word = words[i];
    if (word == "--table") {
      options.is_markdown = true;
      continue;
    }
    if (++i == count) return std::nullopt;
    if (word == "--bodies")
      options.bodies = std::atoi(words[i]);
    else if (word == "--rounds")
      options.rounds = std::atoi(words[i]);
    else if (word == "--scene")
      options.scene = words[i];
    else if (word == "--engine")
      options.engine = words[i];
    else
      return std::nullopt;
  }
  if (options.bodies < 1 || options.rounds < 1) return std::nullopt;
  return options;
}

}  // namespace
}  // namespace talus::beside

int main(int count, char** words) {
  using namespace talus::beside;
  const auto options = parse(count, words);
  if (!options) {
    std::cerr
        << "usage: talus_beside_others [--bodies N] [--rounds N] [--scene WORD] [--engine WORD] [--table]\n";
    return 2;
  }
  Comparison comparison(*options);
  if (comparison.is_empty()) {
    std::cerr << "talus_beside_others: no engine has \"" << options->engine << "\" in its name\n";
    return 2;
  }
  comparison.run();
}
