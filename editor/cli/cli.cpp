#include "cli.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <optional>
#include <sstream>

#include <talus/collision/world.h>
#include <talus/formats/format.h>
#include "command.h"
#include "edit/layer_ground.h"
#include "formats/last_catch.h"
#include "formats/text/append_number.h"
#include "formats/text/utf8_text.h"
#include "level/level_text.h"
#include "platform/user_folder.h"
#include "progress_line.h"
#include "session/files/read_permissions.h"

namespace talus {
namespace {

constexpr std::array kAddCommands = {add_edit_command,  add_sim_command,    add_replay_command,
                                     add_new_command,   add_import_command, add_export_command,
                                     add_check_command, add_prove_command,  add_shot_command,
                                     add_bench_command, add_report_command};

bool begins_with_command(const CLI::App& program, const std::vector<std::string>& arguments) {
  const auto is_first = [&](const CLI::App* command) { return command->get_name() == arguments[0]; };
  return !arguments.empty() && !program.get_subcommands(is_first).empty();
}

// What is wrong with a first word that is neither a command nor the name of a file; nothing for others.
std::optional<std::string> unknown_command(const CLI::App& program,
                                           const std::vector<std::string>& arguments) {
  if (arguments.empty() || arguments[0].empty() || begins_with_command(program, arguments)) return {};
  const std::string& word = arguments[0];
  std::error_code ignored;
  const bool is_word = std::all_of(word.begin(), word.end(), [](char c) { return c >= 'a' && c <= 'z'; });
  if (!is_word || std::filesystem::exists(word, ignored)) return {};
  std::string names;
  for (const CLI::App* command : program.get_subcommands({}))
    names += (names.empty() ? "" : ", ") + command->get_name();
  return "is neither a command nor a file: the commands are " + names;
}

// `talus FILE` and `talus` alone mean `talus edit`.
std::vector<std::string> with_command(const CLI::App& program, std::vector<std::string> arguments) {
  const bool is_option = !arguments.empty() && arguments[0].size() > 1 && arguments[0][0] == '-';
  if (!is_option && !begins_with_command(program, arguments)) arguments.insert(arguments.begin(), "edit");
  return arguments;
}

// Applies "key=value". Returns what is wrong with it, or an empty text.
std::string apply_setting(const std::string& setting, Tuning& tuning) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string::npos) return "must be KEY=VALUE";
  const std::string key = setting.substr(0, equals);
  const auto fields = tuning_fields();
  const auto field =
      std::find_if(fields.begin(), fields.end(), [&](const TuningField& f) { return f.path() == key; });
  if (field == fields.end()) return "the tuning has no number \"" + key + "\"";
  if (!field->words.empty()) {
    const auto word = field->of_word(std::string_view(setting).substr(equals + 1));
    if (!word) {
      std::string words;
      for (const std::string_view each : field->words) words.append(words.empty() ? "" : ", ").append(each);
      return key + " must be one of " + words;
    }
    field->in(tuning) = *word;
    return "";
  }
  double value = 0;
  const char* end = setting.data() + setting.size();
  const auto [rest, code] = std::from_chars(setting.data() + equals + 1, end, value);
  if (code != std::errc() || rest != end || !field->accepts(value)) {
    std::string range;
    append_number(range, field->min);
    range += " to ";
    append_number(range, field->max);
    return key + (field->whole ? " must be a whole number from " : " must be a number from ") + range;
  }
  field->in(tuning) = value;
  return "";
}

}  // namespace

int run_cli(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  CommandContext context{out, err};
  CLI::App program("Talus: a level editor and physics debugger for tile games with slopes", "talus");
  program.require_subcommand(1);
  program.set_version_flag("--version", "talus " TALUS_VERSION);
  program.set_help_all_flag("--help-all", "Print the help of every command and exit");
  for (const auto add : kAddCommands) add(program, context);

  if (const auto problem = unknown_command(program, arguments)) {
    fail(context, arguments[0], "", *problem);
    return kExitUsage;
  }
  std::vector<std::string> remaining = with_command(program, arguments);
  std::reverse(remaining.begin(), remaining.end());  // CLI11 takes the last one first
  try {
    program.parse(remaining);
  } catch (const CLI::ParseError& error) {
    std::stringstream problem;  // it may quote what was typed
    const bool was_help = program.exit(error, out, problem) == static_cast<int>(CLI::ExitCodes::Success);
    for (std::string line; std::getline(problem, line);) say(err, line);
    return was_help ? kExitGood : kExitUsage;
  } catch (const WorldError& error) {
    fail(context, "talus", "", error.what());
  } catch (...) {
    const auto commands = program.get_subcommands();
    const std::string command = commands.empty() ? "" : " " + commands.front()->get_name();
    if (context.doing.empty()) context.doing = "running talus" + command;
    fail(context, "talus", "", "failed while " + context.doing + ": " + caught_text());
  }
  if (!out.flush()) fail(context, "-", "", "standard output cannot be written");
  return context.status;
}

void say(std::ostream& stream, const std::string& line) { stream << printable_line(line) << '\n'; }

void fail(CommandContext& context, const std::string& file, const std::string& place,
          const std::string& message) {
  say(context.err, to_string(FormatError{place, message}, file));
  context.status = kExitBad;
}

void add_outside_option(CLI::App& command, CommandContext& context) {
  command.add_flag("--allow-outside", context.reads_outside,
                   "Read the tilesets and pictures that a map names also outside of the folder of FILE; by "
                   "default numbered boxes stand for them");
}

void add_missing_option(CLI::App& command, CommandContext& context) {
  command.add_flag(
      "--allow-missing", context.allows_missing,
      "Go on without the tilesets and pictures that FILE names and that cannot be read; numbered "
      "boxes stand for them");
}

bool fail_for_missing(CommandContext& context, const std::string& file, const LoadedLevel& loaded) {
  const std::vector<std::string>& missing = loaded.missing;
  if (missing.empty() || context.allows_missing) return false;
  constexpr std::size_t kMaxNamed = 5;
  std::string names;
  for (std::size_t i = 0; i < std::min(missing.size(), kMaxNamed); ++i)
    names += (i == 0 ? "" : ", ") + missing[i];
  if (missing.size() > kMaxNamed) names += " and others";
  fail(context, file, "",
       "names " + count_text(missing.size(), "file") + " that could not be read: " + names +
           ": --allow-missing goes on without " + (missing.size() == 1 ? "it" : "them"));
  return true;
}

std::array<CLI::Option*, 2> add_part_options(CLI::App& command, CommandContext& context) {
  return {command.add_option("--layer", context.choices.layer,
                             "Take one tile layer of several alone: its name, or its number, from 1"),
          command.add_option(
              "--level", context.choices.level,
              "The level to take from an LDtk project with several: its name, or its number, from 1")};
}

// The option that chooses a part of a file whose format has no such parts, if one was given.
std::optional<std::string> option_without_use(const ImportChoices& choices, const Format& format) {
  const struct {
    bool is_given;
    std::string_view choice;
    const char* option;
  } rows[] = {{!choices.layer.empty(), "layer", "--layer"},
              {!choices.level.empty(), "level", "--level"},
              {choices.used_tiles, "used_tiles", "--tiles-used"},
              {choices.mapping.has_value(), "mapping", "--ldtk-map"}};
  for (const auto& row : rows) {
    const bool has_use =
        std::find(format.choices.begin(), format.choices.end(), row.choice) != format.choices.end();
    if (row.is_given && !has_use) return row.option;
  }
  return std::nullopt;
}

std::optional<LoadedLevel> load_file_or_fail(CommandContext& context, const std::string& file) {
  context.doing = "reading " + file;
  ImportChoices allowed = context.choices;
  allowed.outside = context.reads_outside
                        ? std::vector<std::string>{"/"}
                        : ReadPermissions(state_folder() + "/" + kReadPermissionsFile).folders_of(file);
  FormatResult<LoadedLevel> loaded = [&] {
    ProgressLine line(context.err, "reading " + file, is_terminal(context.err));
    return load_level(file, allowed, Progress([&](double share) { return line.at(share); }));
  }();
  if (!loaded) {
    say(context.err, to_string(loaded.error(), file));
    context.status = kExitBad;
    return std::nullopt;
  }
  if (const auto option = option_without_use(context.choices, *loaded->format)) {
    fail(context, file, "",
         "is read as \"" + std::string(loaded->format->label) + "\", for which " + *option +
             " has no meaning: leave it out");
    return std::nullopt;
  }
  for (const std::string& what : loaded->dropped)
    say(context.err, file + ": warning: not in the level: " + what);
  if (const std::size_t count = loaded->refused.size(); count > 0) {
    say(context.err, file + ": warning: names " + count_text(count, "file") +
                         " outside of its folder: --allow-outside reads " + (count == 1 ? "it" : "them"));
  }
  if (const auto ways = ways_to_ground(loaded->level))
    say(context.err, file + ": warning: nothing on this map is ground yet: " + *ways);
  if (!loaded->note.empty()) say(context.err, file + ": warning: " + loaded->note);
  context.doing = "working on " + file;
  context.inputs.insert(context.inputs.end(), {file, loaded->path, loaded->companion.path});
  context.inputs.insert(context.inputs.end(), loaded->linked.begin(), loaded->linked.end());
  return *std::move(loaded);
}

std::optional<Level> load_or_fail(CommandContext& context, const std::string& file) {
  auto loaded = load_file_or_fail(context, file);
  if (!loaded) return std::nullopt;
  return std::move(loaded->level);
}

std::vector<std::string> solver_names() {
  std::vector<std::string> names;
  for (const SolverKind solver : solver_kinds()) names.emplace_back(solver_name(solver));
  return names;
}

void add_physics_options(CLI::App& command, PhysicsOptions& options) {
  command
      .add_option("--solver", options.solver, "The solver; default: that of the level, or exact for a cart")
      ->check(CLI::IsMember(solver_names()));
  command.add_option("--set", options.settings, "Change a number of the tuning: --set fall_speed=3")
      ->type_name("KEY=VALUE")
      ->check([](const std::string& setting) {
        Tuning ignored;
        return apply_setting(setting, ignored);
      });
}

void apply_physics(const PhysicsOptions& options, Tuning& tuning) {
  if (!options.solver.empty()) tuning.solver = solver_of_name(options.solver).value();
  for (const std::string& setting : options.settings) apply_setting(setting, tuning);
}

}  // namespace talus
