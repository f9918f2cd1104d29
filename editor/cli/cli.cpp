#include "cli.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "command.h"
#include "formats/format.h"

namespace talus {
namespace {

constexpr std::array kAddCommands = {add_edit_command,   add_sim_command,    add_replay_command,
                                     add_import_command, add_export_command, add_check_command,
                                     add_shot_command,   add_bench_command};

// `talus FILE` and `talus` alone mean `talus edit`.
std::vector<std::string> with_command(const CLI::App& program, std::vector<std::string> arguments) {
  const bool is_option = !arguments.empty() && arguments[0].size() > 1 && arguments[0][0] == '-';
  const auto is_first = [&](const CLI::App* command) { return command->get_name() == arguments[0]; };
  const bool is_command = !arguments.empty() && !program.get_subcommands(is_first).empty();
  if (!is_option && !is_command) arguments.insert(arguments.begin(), "edit");
  return arguments;
}

}  // namespace

int run_cli(const std::vector<std::string>& arguments, std::ostream& out, std::ostream& err) {
  CommandContext context{out, err};
  CLI::App program("Talus: a level editor and physics debugger for tile games with slopes", "talus");
  program.require_subcommand(1);
  program.set_help_all_flag("--help-all", "Print the help of every command and exit");
  for (const auto add : kAddCommands) add(program, context);

  std::vector<std::string> remaining = with_command(program, arguments);
  std::reverse(remaining.begin(), remaining.end());  // CLI11 takes them last first
  try {
    program.parse(remaining);
  } catch (const CLI::ParseError& error) {
    const bool was_help = program.exit(error, out, err) == static_cast<int>(CLI::ExitCodes::Success);
    return was_help ? kExitGood : kExitUsage;
  }
  return context.status;
}

void fail(CommandContext& context, const std::string& file, const std::string& place,
          const std::string& message) {
  context.err << to_string(FormatError{place, message}, file) << '\n';
  context.status = kExitBad;
}

std::optional<Level> load_or_fail(CommandContext& context, const std::string& file) {
  FormatResult<LoadedLevel> loaded = load_level(file);
  if (!loaded) {
    fail(context, file, loaded.error().place, loaded.error().message);
    return std::nullopt;
  }
  return std::move(loaded->level);
}

void add_physics_options(CLI::App& command, PhysicsOptions& options) {
  command.add_option("--solver", options.solver, "The solver; without it, the level's own")
      ->check(CLI::IsMember({std::string(solver_name(SolverKind::article))}));
  command.add_option("--set", options.settings, "Change a number of the tuning: --set fall_speed=3")
      ->type_name("KEY=VALUE");
}

bool apply_physics(CommandContext& context, const PhysicsOptions& options, Tuning& tuning) {
  if (!options.solver.empty()) tuning.solver = SolverKind::article;
  for (const std::string& setting : options.settings) {
    const std::size_t equals = setting.find('=');
    const std::string key = setting.substr(0, equals);
    const auto fields = tuning_fields();
    const auto field =
        std::find_if(fields.begin(), fields.end(), [&](const TuningField& f) { return f.key == key; });
    if (equals == std::string::npos || field == fields.end()) {
      fail(context, "--set", setting, "there is no number of the tuning called \"" + key + "\"");
      return false;
    }
    double value = 0;
    const char* end = setting.data() + setting.size();
    const auto [rest, code] = std::from_chars(setting.data() + equals + 1, end, value);
    if (code != std::errc() || rest != end || !(value >= field->min && value <= field->max)) {
      fail(context, "--set", setting,
           "the value must be a number from " + CLI::detail::to_string(field->min) + " to " +
               CLI::detail::to_string(field->max));
      return false;
    }
    tuning.article.*field->value = value;
  }
  return true;
}

}  // namespace talus
