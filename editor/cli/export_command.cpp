// talus export FILE --to FORMAT -o OUT, or --preset NAME, or --all; with --watch after each change of FILE.
#include "command.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "export/lua_parts.h"
#include "export/preset_clash.h"
#include "export_writer.h"
#include "file_watch.h"
#include "formats/files/atomic_file.h"
#include "platform/user_folder.h"
#include "session/files/export_permissions.h"

namespace talus {
namespace {

struct ExportOptions {
  std::string input, output, target;
  std::string parts;  // parts of the Lua runtime besides those that the level uses
  std::vector<std::string> presets;
  bool all = false;
  bool watch = false;
  bool playable = false;  // for a cart: with code that plays the level
  bool allow_code = false;
  // The presets for which --allow-code was given: those of the first level that is read; empty before that.
  std::optional<std::vector<ExportPreset>> may_bring_code = {};
  ExportRules rules;

  bool takes_presets() const { return all || !presets.empty(); }
};

std::vector<std::string> exporter_ids() {
  std::vector<std::string> ids;
  for (const Exporter& exporter : exporters()) ids.emplace_back(exporter.id);
  return ids;
}

// Returns an empty text, or the existing names for the error about an unknown one.
std::string unknown_preset(const std::string& name, const std::vector<ExportPreset>& presets) {
  std::string known;
  for (const ExportPreset& preset : presets) {
    if (preset.name == name) return "";
    known += (known.empty() ? "" : ", ") + ("\"" + preset.name + "\"");
  }
  return "there is no preset \"" + name + "\"; " +
         (known.empty() ? "the level has none: make them in the editor, in File > Export"
                        : "the level has " + known);
}

// Reports presets that would write one another's files. Returns true if there are any.
bool find_clashes(CommandContext& context, const ExportOptions& options,
                  std::span<const ExportPreset> presets) {
  bool found = false;
  for (; !presets.empty(); presets = presets.subspan(1)) {
    const std::string problem = clash_problem(presets, 0, options.input);
    if (!problem.empty()) fail(context, options.input, "", problem);
    found = found || !problem.empty();
  }
  return found;
}

// Why a preset that came with the level must not be written, one sentence without its full stop; empty if it
// may. Other programs could run the level's code under the name that the level chose.
std::string code_problem_of(const ExportOptions& options, const ExportPermissions& permissions,
                            const Level& level, const ExportPreset& preset) {
  if (!brings_code(level, preset.exporter)) return "";
  const auto& meant = options.may_bring_code;
  if (meant && std::find(meant->begin(), meant->end(), preset) != meant->end()) return "";
  if (permissions.allows(preset)) return "";
  return "writes the level's own code to " + preset.path +
         ", which has not been allowed: allow it in the editor, in File > Export, or by --allow-code";
}

void export_presets(CommandContext& context, const ExportOptions& options, Level level) {
  std::vector<ExportPreset> presets = std::exchange(level.exports, {});
  for (const std::string& name : options.presets) {
    if (const std::string problem = unknown_preset(name, presets); !problem.empty())
      return fail(context, options.input, "", problem);
  }
  if (presets.empty())
    return fail(context, options.input, "", "has no presets: make them in the editor, in File > Export");
  const auto& names = options.presets;
  std::erase_if(presets, [&](const ExportPreset& preset) {
    return !options.all && std::find(names.begin(), names.end(), preset.name) == names.end();
  });
  if (find_clashes(context, options, presets)) return;
  ExportPermissions permissions(state_folder() + "/" + kPermissionsFile);
  permissions.open(options.input);
  for (const ExportPreset& preset : presets) {
    if (const std::string problem = code_problem_of(options, permissions, level, preset); !problem.empty()) {
      fail(context, options.input, "preset \"" + preset.name + "\"", problem);
      continue;
    }
    const auto output = output_of(preset, options.input);
    if (!output) {
      fail(context, options.input, "preset \"" + preset.name + "\"", output.error().error.message);
      continue;
    }
    carry_out(context, {.level = level,
                        .input = options.input,
                        .exporter = preset.exporter,
                        .output = *output,
                        .parts = preset.parts,
                        .preset = preset.name,
                        .is_of_level = true,
                        .rules = options.rules,
                        .tells = true});
  }
}

void export_file(CommandContext& context, ExportOptions& options) {
  context.inputs.clear();
  const auto loaded = load_file_or_fail(context, options.input);
  if (!loaded || fail_for_missing(context, options.input, *loaded)) return;
  const Level& level = loaded->level;
  if (options.allow_code && !options.may_bring_code) options.may_bring_code = level.exports;
  if (options.takes_presets()) return export_presets(context, options, level);
  carry_out(context, {.level = level,
                      .input = options.input,
                      .exporter = options.target + (options.playable ? "-playable" : ""),
                      .output = options.output,
                      .parts = options.parts,
                      .rules = options.rules,
                      .tells = options.watch});
}

// The message about a file that cannot be read.
std::string waiting_text(const std::string& file) {
  std::error_code ignored;
  const auto bytes = read_file(file);
  if (bytes || !std::filesystem::exists(file, ignored)) return "does not exist; waiting for it";
  return bytes.error().message + "; waiting for a file";
}

// Errors are reported, but the next version may be better: they neither end the watch nor change the status.
// It ends if nobody can read the reports any more.
void watch_and_export(CommandContext& context, ExportOptions options) {
  watch_file(
      options.input,
      [&] {
        context.status = kExitGood;
        export_file(context, options);
        // The starters there were reported at the beginning. Files that are changed during the watch are
        // kept.
        if (context.status == kExitGood) options.rules = {.allow_outside = options.rules.allow_outside};
        return context.out.good();
      },
      [&] {
        fail(context, options.input, "", waiting_text(options.input));
        return context.out.good();
      });
  context.status = kExitGood;
}

void check_options(const ExportOptions& options) {
  const bool is_cart = options.target == "tic" || options.target == "tic-text";
  if (options.playable && !is_cart)
    throw CLI::ValidationError("--playable", "can only be used with --to tic and --to tic-text");
  const Exporter* exporter = find_exporter(options.target + (options.playable ? "-playable" : ""));
  if (!options.parts.empty() && (exporter == nullptr || !exporter->takes_parts))
    throw CLI::ValidationError("--parts",
                               "can only be used with the formats that contain the Lua runtime: love, "
                               "lua-runtime, tic --playable and tic-text --playable");
  if (!options.takes_presets() && (options.target.empty() || options.output.empty()))
    throw CLI::ValidationError("export", "needs --to and --output, or --preset, or --all");
  if (options.watch && options.output == "-")
    throw CLI::ValidationError("--watch", "needs a file or folder to write");
}

}  // namespace

void add_export_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("export", "Write a level in a game's format");
  auto options = std::make_shared<ExportOptions>();
  command->add_option("FILE", options->input, "Level or cart")->required();
  add_part_options(*command, context);
  CLI::Option* target =
      command->add_option("--to", options->target, "Format to write")->check(CLI::IsMember(exporter_ids()));
  CLI::Option* output = command->add_option(
      "-o,--output", options->output, "File to write, - for standard output; for some formats a folder");
  CLI::Option* presets =
      command->add_option("--preset", options->presets,
                          "Instead of --to and --output: the name of a preset of the level; may be repeated");
  command
      ->add_flag("--all", options->all,
                 "Instead of --to and --output: all presets of the level, as made in File > Export")
      ->excludes(target)
      ->excludes(output)
      ->excludes(presets);
  presets->excludes(target)->excludes(output);
  command->add_flag("--watch", options->watch,
                    "Export now and after every change of FILE, until Ctrl+C; prints a line for each export");
  command->add_flag("--playable", options->playable,
                    "With tic and tic-text: put code into the cart that plays the level");
  command
      ->add_option("--parts", options->parts,
                   "Parts of the Lua runtime besides those that the level uses, for what the game adds while "
                   "it runs: " +
                       lua_part_names() + "; separated by commas")
      ->excludes(presets);
  command->add_flag(
      "--fresh", options->rules.fresh,
      "Write the files that you may change, such as main.lua, anew; by default changed ones stay");
  command->add_flag("--force", options->rules.force,
                    "Replace files beside the named one, in the folder, or of a preset, even if they are not "
                    "unchanged exports");
  command->add_flag(
      "--allow-outside", options->rules.allow_outside,
      "Read the tilesets and pictures that a map names also outside of the folder of FILE; let presets write "
      "there, and exports through links that lead out of their folder");
  add_missing_option(*command, context);
  command->add_flag(
      "--allow-code", options->allow_code,
      "Let presets write the level's own code, as carts hold it, though nobody has allowed that in "
      "the editor; with --watch those that the level has at first");
  command->callback([&context, options] {
    check_options(*options);
    context.reads_outside = options->rules.allow_outside;
    options->input = level_path(options->input);
    if (options->watch)
      watch_and_export(context, *options);
    else
      export_file(context, *options);
  });
}

}  // namespace talus
