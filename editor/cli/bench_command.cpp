// talus bench FILE --bodies N --frames N [--pairs] [--solver S] [--set KEY=VALUE] [--threads N] [--seed N]

#include <nlohmann/json.hpp>
#include <ostream>

#include <talus/level/ground.h>
#include <talus/sim/solver.h>
#include "bench_balls.h"
#include "bench_kernel.h"
#include "command.h"
#include "progress_line.h"
#include "timing.h"
#include "trace.h"

namespace talus {
namespace {

struct BenchOptions {
  std::string file;
  int bodies = 0;
  int frames = 0;
  int threads = 1;
  std::uint64_t seed = 1;
  bool pairs = false;
  PhysicsOptions physics;
};

void bench(CommandContext& context, const BenchOptions& options) {
  std::optional<Level> level = load_or_fail(context, options.file);
  if (!level) return;
  level->tuning.shared.bodies = options.pairs ? 1 : 0;
  apply_physics(options.physics, level->tuning);
  if (const auto problem = ground_problem(*level))
    return fail(context, options.file, "", "the level " + *problem);
  if (!spawn_balls(*level, options.bodies, options.seed)) {
    return fail(context, options.file, "",
                "the map has too few free cells for " + std::to_string(options.bodies) + " bodies");
  }

  const auto scene = std::make_shared<const Scene>(compile_scene(*level));
  const std::unique_ptr<Solver> solver = make_solver(scene);
  State state = initial_state(*scene);
  BenchKernel kernel(*level, state);
  const Input input;
  const auto bodies = static_cast<double>(state.bodies.size());
  std::vector<double> solver_ns, kernel_ns, ratios;
  std::vector<Vec2> before;
  std::size_t resting = 0;  // steps of a body in which it did not move
  double total_ns = 0;
  // The two take turns, so that other work on the machine affects both.
  ProgressLine progress(context.err, options.file, is_terminal(context.err));
  for (int frame = 0; frame < options.frames; ++frame) {
    if (!progress.at(static_cast<double>(frame) / options.frames))
      return fail(context, options.file, "", "was cancelled");
    before.clear();
    for (const Body& body : state.bodies) before.push_back(body.box.position());
    const double ns = nanoseconds([&] { solver->step(state, input); });
    total_ns += ns;
    solver_ns.push_back(ns / bodies);
    kernel_ns.push_back(nanoseconds([&] { kernel.step(); }) / bodies);
    ratios.push_back(solver_ns.back() / kernel_ns.back());
    for (std::size_t i = 0; i < before.size(); ++i) resting += state.bodies[i].box.position() == before[i];
  }

  progress.wipe();
  nlohmann::ordered_json line;
  line["solver"] = solver_name(scene->tuning.solver);
  line["bodies"] = state.bodies.size();
  line["frames"] = options.frames;
  line["pairs"] = level->tuning.shared.pairs() != BodyPairs::pass;
  line["threads"] = 1;  // every solver steps bodies in their order
  line["seed"] = options.seed;
  line["ns_per_body_step"] = median(solver_ns);
  line["mean_ns_per_body_step"] = total_ns / options.frames / bodies;
  line["kernel_ns_per_body_step"] = median(kernel_ns);
  line["ratio_to_kernel"] = median(ratios);
  line["resting"] = static_cast<double>(resting) / options.frames / bodies;
  line["kernel_checksum"] = kernel.checksum();
  line["hash"] = hash_text(state_hash(state));
  context.out << line.dump() << '\n';
}

}  // namespace

void add_bench_command(CLI::App& program, CommandContext& context) {
  CLI::App* command =
      program.add_subcommand("bench", "Time a level's simulation: one JSON line, medians over the frames");
  auto options = std::make_shared<BenchOptions>();
  command->add_option("FILE", options->file, "Level or cart")->required();
  command->add_option("--bodies", options->bodies, "Balls to put on free cells")
      ->required()
      ->check(CLI::Range(1, 10'000'000));
  command->add_option("--frames", options->frames, "Steps to time")
      ->required()
      ->check(CLI::Range(1, 10'000'000));
  command->add_flag("--pairs", options->pairs,
                    "Balls block one another; by default they pass, so that each body costs the same");
  add_physics_options(*command, options->physics);
  add_part_options(*command, context);
  add_outside_option(*command, context);
  command
      ->add_option(
          "--threads", options->threads,
          "Maximum of threads; every solver steps its bodies in order, on one thread, so more have no effect")
      ->check(CLI::Range(1, 256));
  command->add_option("--seed", options->seed, "Where the balls start");
  command->callback([&context, options] { bench(context, *options); });
}

}  // namespace talus
