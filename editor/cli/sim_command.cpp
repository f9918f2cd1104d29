// talus sim FILE --frames N [--solver S] [--set KEY=VALUE] [--input F.jsonl] [--trace F.jsonl] [--hash]
// talus sim FILE --verify [--solver S] [--set KEY=VALUE]
// talus sim FILE.talusrec [--frames N] [--trace F.jsonl] [--hash], or --verify
// Both with --until CONDITION: to the first frame in which it holds

#include <limits>
#include <ostream>

#include <talus/level/ground.h>
#include <talus/sim/solver.h>
#include "formats/files/atomic_file.h"
#include "formats/last_catch.h"
#include "formats/native/hard_case_file.h"
#include "formats/native/input_entry.h"
#include "formats/text/append_number.h"
#include "input_file.h"
#include "progress_line.h"
#include "sim/case_input.h"
#include "sim/hard_case_run.h"
#include "sim_run.h"
#include "trace.h"
#include "until.h"

namespace talus {
namespace {

// Returns the recorded input, empty input without a file, or nothing after a reported failure.
std::optional<std::vector<RecordedInput>> load_input(CommandContext& context, const std::string& file) {
  if (file.empty()) return std::vector<RecordedInput>();
  const auto bytes = read_file(file);
  if (!bytes) {
    fail(context, file, bytes.error().place, bytes.error().message);
    return std::nullopt;
  }
  auto inputs = read_guarded([&] { return read_input_lines(*bytes); });
  if (!inputs) {
    fail(context, file, inputs.error().place, inputs.error().message);
    return std::nullopt;
  }
  return std::move(*inputs);
}

// One line for each check of a hard case, such as "failed position body 1: 0.5, bound 0".
void verify(CommandContext& context, const SimOptions& options, const Level& level) {
  const auto hard = hard_case_of(level);
  if (!hard) return fail(context, options.file, hard.error().place, hard.error().message);
  if (!*hard) return fail(context, options.file, "", "has no key \"hard_case\" to verify");
  const auto results = run_hard_case(**hard, level);
  if (!results) return fail(context, options.file, "key hard_case", results.error());
  for (const CaseResult& result : *results) {
    std::string line = result.passed ? "passed " : "failed ";
    line += case_measure_infos()[static_cast<std::size_t>(result.check.measure)].key;
    line += " body " + std::to_string(result.check.body) + ": ";
    append_number(line, result.measured);
    line += ", bound ";
    append_number(line, result.check.bound);
    context.out << line << '\n';
    if (!result.passed) context.status = kExitBad;
  }
}

void simulate_level(CommandContext& context, const SimOptions& options) {
  std::optional<Level> level = load_or_fail(context, options.file);
  if (!level) return;
  apply_physics(options.physics, level->tuning);
  if (const auto problem = ground_problem(*level))
    return fail(context, options.file, "", "the level " + *problem);
  warn_of_ignored_ground(context, options.file, *level);
  if (options.verify) return verify(context, options, *level);
  std::optional<std::vector<RecordedInput>> inputs = load_input(context, options.input);
  if (!inputs) return;
  const auto hard = hard_case_of(*level);
  if (!hard) return fail(context, options.file, hard.error().place, hard.error().message);
  const std::vector<CaseInput> script = *hard ? (*hard)->input : std::vector<CaseInput>();

  // The line holds back the signals that end the program, and so outlives the trace's unfinished file.
  ProgressLine line(context.err, options.file, is_terminal(context.err) && options.trace != "-");
  TraceFile trace(context, options);
  if (!trace.good()) return;

  const auto scene = std::make_shared<const Scene>(compile_scene(*level));
  const std::unique_ptr<Solver> solver = make_solver(scene);
  State state = initial_state(*scene);
  InputPlayer player(std::move(*inputs));
  StepRecord record;
  Until until(options.until);
  const auto ground = until.wanted() ? measured_ground(*scene, *level) : nullptr;
  record.only_events = options.no_contacts && !until.wanted();
  StepRecord* wanted = trace.wanted() || until.wanted() ? &record : nullptr;
  Input input;
  const auto stops = [&] {
    return until.wanted() && until.stops_at({scene, ground, state, record, input, {}});
  };
  bool stopped = stops();
  for (std::int64_t i = 0; !stopped && i < options.frames; ++i) {
    if (!line.at(static_cast<double>(i) / static_cast<double>(options.frames)))
      return fail(context, options.file, "", "was cancelled");
    const std::int64_t frame = state.frame + 1;
    input = added(case_input(script, frame), player.at(frame));
    solver->step(state, input, wanted);
    trace.write(state, wanted);
    stopped = stops();
  }
  line.wipe();
  if (!trace.finish()) return;
  until.report(context, options.file);
  if (options.hash) context.out << hash_text(state_hash(state)) << '\n';
}

}  // namespace

void add_sim_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("sim", "Run a level without a window and write what happens");
  auto options = std::make_shared<SimOptions>();
  command->add_option("FILE", options->file, "Level, cart or recording")->required();
  CLI::Option* frames =
      command
          ->add_option("--frames", options->frames,
                       "Steps to make; for a recording at most its own, which is the default")
          ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000'000}));
  CLI::Option* verify_flag =
      command->add_flag("--verify", options->verify,
                        "Run a hard case as its file says, and print each check of its right answer; or run "
                        "a recording, and compare the hash of each frame");
  add_physics_options(*command, options->physics);
  add_part_options(*command, context);
  add_outside_option(*command, context);
  command->add_option("--input", options->input,
                      "Recorded mouse and keys (JSON lines), in addition to those of a hard case");
  command->add_option("--trace", options->trace, "Write each frame here (JSON lines); - for standard output");
  command->add_flag("--no-contacts", options->no_contacts,
                    "Leave contacts, capped and cut_short out of the trace; events stay");
  command->add_flag("--hash", options->hash, "Print the hash of the last state on the last line");
  command
      ->add_option("--until", options->until,
                   "Stop at the first frame in which this holds for any body, such as \"penetration > 1\", "
                   "and print the frame and why; the exit status is 1 if there is none")
      ->check(problem_of_condition);
  for (const char* other : {"--frames", "--input", "--trace", "--hash", "--until"})
    verify_flag->excludes(other);
  command->callback([&context, options, frames] {
    const bool recording = is_recording_file(options->file);
    if (!recording && !options->verify && frames->empty()) throw CLI::RequiredError("--frames");
    if (!recording) return simulate_level(context, *options);
    if (frames->empty()) options->frames = std::numeric_limits<std::int64_t>::max();
    simulate_recording(context, *options);
  });
}

}  // namespace talus
