// talus export FILE --to FORMAT -o OUT, or --preset NAME, or --all; with --watch after each change of FILE.
#include "export_command.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <ostream>
#include <utility>

#include "export/export_plan.h"
#include "file_watch.h"
#include "formats/atomic_file.h"
#include "platform/asset_path.h"

namespace talus {
namespace {

FormatResult<std::string> read_asset(const std::string& name) { return read_file(asset_path(name)); }

struct ExportOptions {
  std::string input, output, target;
  std::vector<std::string> presets;
  bool all = false;
  bool watch = false;
  bool playable = false;  // of a cart: with code that plays the level

  bool takes_presets() const { return all || !presets.empty(); }
};

std::vector<std::string> exporter_ids() {
  std::vector<std::string> ids;
  for (const Exporter& exporter : exporters()) ids.emplace_back(exporter.id);
  return ids;
}

void warn_of_dropped(CommandContext& context, const Exported& exported, const std::string& output) {
  for (const std::string& what : exported.dropped)
    context.err << output << ": warning: not stored in this format: " << what << '\n';
}

// Writes one export and says so in a line. `preset`: for errors; empty: it is none of a preset.
void write_and_tell(CommandContext& context, const ExportOptions& options, const Level& level,
                    const std::string& preset, const std::string& exporter, const std::string& output) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  const auto fail_with = [&](const ExportProblem& problem) {
    const FormatError& error = problem.error;
    if (problem.field == ExportProblem::Field::target)
      fail(context, options.input, "preset \"" + preset + "\"", error.message);
    else
      fail(context, problem.field == ExportProblem::Field::path ? output : options.input, error.place,
           error.message);
  };
  const auto plan = plan_export(level, exporter, output, read_asset);
  if (!plan) return fail_with(plan.error());
  if (const auto written = write_plan(*plan); !written) return fail_with(written.error());
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(Clock::now() - start);
  context.out << summary_of(*plan) << ", " << time.count() << " ms" << std::endl;
  warn_of_dropped(context, plan->content, output);
}

// "", or the names that there are for the error about one that is not.
std::string unknown_preset(const std::string& name, const std::vector<ExportPreset>& presets) {
  std::string known;
  for (const ExportPreset& preset : presets) {
    if (preset.name == name) return "";
    known += (known.empty() ? "" : ", ") + ("\"" + preset.name + "\"");
  }
  return "there is no preset \"" + name + "\"; " +
         (known.empty() ? "the level has none: they are made in the editor, in File > Export"
                        : "the level has " + known);
}

void export_presets(CommandContext& context, const ExportOptions& options, Level level) {
  const std::vector<ExportPreset> presets = std::exchange(level.exports, {});
  for (const std::string& name : options.presets) {
    if (const std::string problem = unknown_preset(name, presets); !problem.empty())
      return fail(context, options.input, "", problem);
  }
  if (presets.empty())
    return fail(context, options.input, "", "has no presets: they are made in the editor, in File > Export");
  for (const ExportPreset& preset : presets) {
    const auto& names = options.presets;
    if (!options.all && std::find(names.begin(), names.end(), preset.name) == names.end()) continue;
    if (const auto output = output_of(preset, options.input))
      write_and_tell(context, options, level, preset.name, preset.exporter, *output);
    else
      fail(context, options.input, "preset \"" + preset.name + "\"", output.error().error.message);
  }
}

void export_file(CommandContext& context, const ExportOptions& options) {
  const std::optional<Level> level = load_or_fail(context, options.input);
  if (!level) return;
  const std::string exporter = options.target + (options.playable ? "-playable" : "");
  if (options.takes_presets())
    export_presets(context, options, *level);
  else if (options.watch)
    write_and_tell(context, options, *level, "", exporter, options.output);
  else
    write_export(context, *find_exporter(exporter), *level, options.input, options.output);
}

// Errors are said, and what comes next may be better: they are no reason to end, nor for another status.
void watch_and_export(CommandContext& context, const ExportOptions& options) {
  watch_file(
      options.input, [&] { export_file(context, options); },
      [&] { fail(context, options.input, "", "is not there; waiting for it"); });
  context.status = kExitGood;
}

void check_options(const ExportOptions& options) {
  const bool is_cart = options.target == "tic" || options.target == "tic-text";
  if (options.playable && !is_cart)
    throw CLI::ValidationError("--playable", "goes with --to tic and --to tic-text alone");
  if (!options.takes_presets() && (options.target.empty() || options.output.empty()))
    throw CLI::ValidationError("export", "needs --to and --output, or --preset, or --all");
  if (options.watch && options.output == "-")
    throw CLI::ValidationError("--watch", "needs a file or folder to write");
}

}  // namespace

void write_export(CommandContext& context, const Exporter& exporter, const Level& level,
                  const std::string& input, const std::string& output) {
  if (const std::string problem = name_problem(exporter, output); !problem.empty())
    return fail(context, output, "", problem);
  const ReadAsset read = read_asset;
  const auto exported = exporter.write({level, std::filesystem::path(output).filename().string(), read});
  if (!exported) return fail(context, input, exported.error().place, exported.error().message);
  if (output == "-") {
    context.out << exported->files.front().bytes;
  } else if (const auto written = write_exported(exporter, *exported, output); !written) {
    return fail(context, output, written.error().place, written.error().message);
  }
  warn_of_dropped(context, *exported, output);
}

void add_export_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("export", "Write a level in a game's format");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("FILE", options->input, "Level or cart")->required();
  CLI::Option* target =
      command->add_option("--to", options->target, "Format to write")->check(CLI::IsMember(exporter_ids()));
  CLI::Option* output = command->add_option("-o,--output", options->output,
                                            "File to write, - for standard output; of some formats a folder");
  CLI::Option* presets = command->add_option(
      "--preset", options->presets, "Instead of both: a preset of the level, by its name; may be repeated");
  command->add_flag("--all", options->all, "Instead: all presets of the level, made in its export window")
      ->excludes(target)
      ->excludes(output)
      ->excludes(presets);
  presets->excludes(target)->excludes(output);
  command->add_flag("--watch", options->watch,
                    "Export at once and after every change of FILE, until Ctrl+C; a line for each");
  command->add_flag("--playable", options->playable,
                    "With tic and tic-text: put code into the cart that plays the level at once");
  command->callback([&context, options] {
    check_options(*options);
    if (options->watch)
      watch_and_export(context, *options);
    else
      export_file(context, *options);
  });
}

}  // namespace talus
