// What the sub-commands share: each is one file that adds itself to the program.
#pragma once

#include <CLI/CLI.hpp>
#include <array>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <talus/formats/format.h>
#include "cli.h"

namespace talus {

struct CommandContext {
  std::ostream& out;
  std::ostream& err;
  int status = kExitGood;  // set by the command that ran
  // What the command is doing, for an unexpected error: "reading cave.tmx". Empty: only the command is known.
  std::string doing = {};
  // The files that it has read a level from: the named ones, and those that these name. Commands never
  // overwrite them.
  std::vector<std::string> inputs = {};
  // Whether files that a map names are read wherever they lie: see add_outside_option().
  bool reads_outside = false;
  // Whether a level is taken without the files that it names and that cannot be read: see
  // add_missing_option().
  bool allows_missing = false;
  ImportChoices choices =
      {};  // what is taken of a file that has several levels or layers: see add_part_options()
};

// To add a sub-command: write its file, declare it here, and list it in cli.cpp.
void add_edit_command(CLI::App& program, CommandContext& context);
void add_sim_command(CLI::App& program, CommandContext& context);
void add_replay_command(CLI::App& program, CommandContext& context);
void add_import_command(CLI::App& program, CommandContext& context);
void add_new_command(CLI::App& program, CommandContext& context);
void add_export_command(CLI::App& program, CommandContext& context);
void add_check_command(CLI::App& program, CommandContext& context);
void add_prove_command(CLI::App& program, CommandContext& context);
void add_shot_command(CLI::App& program, CommandContext& context);
void add_bench_command(CLI::App& program, CommandContext& context);
void add_report_command(CLI::App& program, CommandContext& context);

// Writes one line. Characters that a terminal or a log would not show as text are escaped: see
// printable_line.
void say(std::ostream& stream, const std::string& line);

// Reports "FILE:PLACE: error: MESSAGE" (without ":PLACE" when it is empty) and sets the status to kExitBad.
void fail(CommandContext& context, const std::string& file, const std::string& place,
          const std::string& message);

// --allow-outside, for a command that reads a level: reads_outside.
void add_outside_option(CLI::App& command, CommandContext& context);

// --allow-missing, for a command whose result is wrong without the files that a level names: allows_missing.
void add_missing_option(CLI::App& command, CommandContext& context);
// Reports the files that a level names and that could not be read, unless that option allows them. Returns
// whether it did.
bool fail_for_missing(CommandContext& context, const std::string& file, const LoadedLevel& loaded);

// --layer and --level, for a command that reads a level: choices. Returns both.
std::array<CLI::Option*, 2> add_part_options(CLI::App& command, CommandContext& context);

// Returns the content of a file, or nothing after a reported failure. Files outside of its folder are read if
// the option or the user, in the window, has allowed that; else they are reported. Warns about what the level
// does not have, and about a companion that does not fit.
std::optional<LoadedLevel> load_file_or_fail(CommandContext& context, const std::string& file);
// Returns only the level in it.
std::optional<Level> load_or_fail(CommandContext& context, const std::string& file);

// The options that choose the physics, shared by sim and bench.
struct PhysicsOptions {
  std::string solver;                 // a solver's name; empty: the level's own
  std::vector<std::string> settings;  // "key=value" of tuning_fields()
};
std::vector<std::string> solver_names();
void add_physics_options(CLI::App& command, PhysicsOptions& options);
void apply_physics(const PhysicsOptions& options, Tuning& tuning);

}  // namespace talus
