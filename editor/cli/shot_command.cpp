// talus shot FILE [--frame N] [--overlay a,b] [--body ID] [--zoom N | --window WxH] -o PNG
// With --window also [--light] [--panel a,b] [--break CONDITION]... [--back] [--compare SOLVER [--two-views]]
// [--stage N].

#include <stdlib.h>

#include <charconv>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <ostream>
#include <tuple>

#include "command.h"
#include "formats/files/atomic_file.h"
#include "output_file.h"
#include "platform/shot.h"
#include "progress_line.h"
#include "session/checks/prover.h"

namespace talus {
namespace {

struct ShotCommandOptions {
  std::string file, output;
  std::int64_t frame = 0;
  std::vector<std::string> overlays;
  std::string window;  // "1280x720"; empty: only the play view
  PhysicsOptions physics;
  ShotOptions shot;
  WindowShotOptions window_shot;
  bool is_light = false;  // the theme of the window
  std::string compared;   // name of a solver; empty: no comparison
  bool metrics = false;   // measures the window's frames, as a line of JSON
};

// The size in "1280x720", or nothing.
std::optional<std::pair<int, int>> size_of(const std::string& text) {
  int width = 0, height = 0;
  const char* end = text.data() + text.size();
  const auto first = std::from_chars(text.data(), end, width);
  if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x') return std::nullopt;
  const auto second = std::from_chars(first.ptr + 1, end, height);
  if (second.ec != std::errc() || second.ptr != end) return std::nullopt;
  if (width < 700 || height < 450 || width > 8192 || height > 8192) return std::nullopt;
  return std::make_pair(width, height);
}

std::string check_size(const std::string& text) {
  return size_of(text) ? "" : "must be WIDTHxHEIGHT, from 700x450 to 8192x8192";
}

void print(const WindowCost& cost, std::ostream& out) {
  const nlohmann::json line = {{"frames", cost.frames.frames()},
                               {"median_ms", cost.frames.median_ms()},
                               {"max_ms", cost.frames.max_ms()},
                               {"vertices", cost.frames.last().vertices},
                               {"draw_calls", cost.frames.last().draw_calls},
                               {"ns_per_step", cost.ns_per_step}};
  out << line.dump() << '\n';
}

void shoot_window(CommandContext& context, const ShotCommandOptions& options) {
  WindowShotOptions shot = options.window_shot;
  shot.file = options.file;
  std::tie(shot.width, shot.height) = *size_of(options.window);
  shot.theme = options.is_light ? ThemeKind::light : ThemeKind::dark;
  shot.frames = static_cast<int>(options.frame);
  shot.overlays = options.shot.overlays;
  shot.body = options.shot.body;
  if (!options.physics.solver.empty()) shot.solver = solver_of_name(options.physics.solver);
  if (!options.compared.empty()) shot.compared = solver_of_name(options.compared);
  ProgressLine line(context.err, options.file, is_terminal(context.err));
  shot.goes_on = [&](double share) { return line.at(share); };
  WindowCost cost;
  const auto written = write_window_shot(shot, options.output, options.metrics ? &cost : nullptr);
  line.wipe();
  if (!written) return fail(context, options.output, "", written.error());
  if (options.metrics) print(cost, context.out);
}

void shoot(CommandContext& context, ShotCommandOptions& options) {
  std::optional<Level> level = load_or_fail(context, options.file);
  if (!level) return;
  if (const auto problem = output_problem({options.output, kPngBeginning, context.inputs}); !problem.empty())
    return fail(context, options.output, "", problem);
  apply_physics(options.physics, level->tuning);
  for (const std::string& key : options.overlays) options.shot.overlays.set(*find_overlay(key), true);
  if (!options.window.empty()) return shoot_window(context, options);
  Session session(std::move(*level), options.file);
  session.take_time();
  ProgressLine line(context.err, options.file, is_terminal(context.err));
  for (std::int64_t i = 0; i < options.frame; ++i) {
    if (!line.at(static_cast<double>(i) / static_cast<double>(options.frame)))
      return fail(context, options.file, "", "was cancelled");
    session.apply(action::StepFrame{});
  }
  if (options.shot.overlays.any(&Overlay::needs_reach)) {
    session.apply(action::FindReach{});
    if (session.message()) return fail(context, options.file, "", session.message()->text);
    while (session.reach().running()) session.advance(0);
  }
  if (options.shot.overlays.any(&Overlay::needs_proof)) {
    session.apply(action::Prove{});
    while (session.prover().running()) session.advance(0);
    if (session.message()) return fail(context, options.file, "", session.message()->text);
  }
  line.wipe();
  const auto written = write_shot(session, options.shot, options.output);
  if (!written) fail(context, options.output, "", written.error());
}

// Draws into a temporary file and copies that to standard output, since pictures are written atomically.
void shoot_to_output(CommandContext& context, ShotCommandOptions& options) {
  std::string folder = (std::filesystem::temp_directory_path() / "talus-shot-XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) return fail(context, folder, "", "cannot be created as a folder");
  options.output = folder + "/shot.png";
  shoot(context, options);
  if (context.status == kExitGood) context.out << read_file(options.output).value_or("");
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
}

// Draws into the named file, if it may be written.
void shoot_to_file(CommandContext& context, ShotCommandOptions& options) {
  if (const std::string problem = ending_problem(options.output, "png", "PNG picture"); !problem.empty())
    return fail(context, options.output, "", problem);
  shoot(context, options);
}

std::vector<std::string> overlay_keys() {
  std::vector<std::string> keys;
  for (const Overlay* overlay : all_overlays()) keys.emplace_back(overlay->key);
  return keys;
}

// Options for the debugger's panels; only with the whole window.
void add_debugger_options(CLI::App& command, ShotCommandOptions& options) {
  WindowShotOptions& shot = options.window_shot;
  const std::string window = "--window";
  command.add_option("--panel", shot.panels, "Show these tabs, one of each place, and the debugger")
      ->delimiter(',')
      ->check(CLI::IsMember(panels_in_tabs()))
      ->needs(window);
  command.add_option("--break", shot.breakpoints, "Condition of a breakpoint, such as 'penetration > 1'")
      ->needs(window);
  command.add_flag("--back", shot.runs_back, "Run back to the last frame at which one stops")
      ->needs("--break");
  command.add_option("--compare", options.compared, "Show the same input through this solver, too")
      ->check(CLI::IsMember(solver_names()))
      ->needs(window);
  command.add_flag("--two-views", shot.two_views, "Show the other side of --compare in a view of its own")
      ->needs("--compare");
  command.add_option("--stage", shot.stage, "Draw this stage of the body's step, from 0")->needs(window);
}

}  // namespace

void add_shot_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("shot", "Draw the play view into a PNG, as the editor would");
  auto options = std::make_shared<ShotCommandOptions>();
  command->add_option("FILE", options->file, "Level or cart")->required();
  command->add_option("--frame", options->frame, "Step to this frame first")
      ->check(CLI::Range(std::int64_t{0}, std::int64_t{1'000'000}));
  add_physics_options(*command, options->physics);
  add_part_options(*command, context);
  add_outside_option(*command, context);
  command->add_option("--overlay", options->overlays, "Overlays to draw")
      ->delimiter(',')
      ->check(CLI::IsMember(overlay_keys()));
  command->add_option("--zoom", options->shot.zoom, "Pixels of the picture for each px of the level")
      ->check(CLI::Range(1, 16));
  command->add_option("--body", options->shot.body,
                      "Id of the body whose details are labelled, and that the view goes with");
  command->add_option("--window", options->window, "Draw the editor's whole window in this size")
      ->type_name("WxH")
      ->check(check_size)
      ->excludes(std::string("--set"), std::string("--zoom"));
  command->add_flag("--light", options->is_light, "Draw the window in the light theme")->needs("--window");
  add_debugger_options(*command, *options);
  command->add_flag("--metrics", options->metrics, "Play 120 more frames, and print what they cost")
      ->needs("--window");
  command->add_option("-o,--output", options->output, "PNG to write; - for standard output")->required();
  command->callback([&context, options] {
    if (const auto two = panels_of_one_place(options->window_shot.panels))
      throw CLI::ValidationError("--panel", two->first + " and " + two->second +
                                                " are tabs of one place, so only one of them can be shown");
    if (options->output == "-") return shoot_to_output(context, *options);
    shoot_to_file(context, *options);
  });
}

}  // namespace talus
