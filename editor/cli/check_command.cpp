// talus check FILE

#include <algorithm>
#include <array>
#include <ostream>

#include "command.h"
#include "formats/files/atomic_file.h"
#include "formats/native/hard_case_file.h"
#include "formats/native/unknown_keys.h"
#include "formats/text/json_text.h"
#include "level/lint/lint.h"

namespace talus {
namespace {

// tile_count: of the level; problems of the ground have other tiles, too.
std::string place_of(const Problem& problem, int tile_count) {
  if (problem.cell) return "cell " + std::to_string(problem.cell->x) + "," + std::to_string(problem.cell->y);
  if (problem.tile >= 0 && problem.tile < tile_count) return "tile " + std::to_string(problem.tile);
  return "";
}

void tell_unknown(CommandContext& context, const std::string& file, const std::vector<UnknownKey>& unknown) {
  for (const UnknownKey& key : unknown)
    say(context.out, file + ":key " + key.place + ": warning: " + key.problem + " [unknown-key]");
  if (unknown.size() == kMaxUnknownListed)
    say(context.out, file + ": warning: has as many unknown keys as are listed, or more [unknown-key]");
}

// What reading leaves alone: unknown keys, and the right answer of a hard case.
void check_keys(CommandContext& context, const std::string& file, const Level& level) {
  if (const auto hard = hard_case_of(level); !hard)
    fail(context, file, hard.error().place, hard.error().message);
  tell_unknown(context, file, unknown_keys(level));
}

// Of a file that is refused, with its error.
void check_refused(CommandContext& context, const std::string& file) {
  constexpr std::array<std::string_view, 1> kVersion = {"talus"};
  const auto bytes = read_file(file);
  if (bytes && (file.ends_with(".talus.json") || has_key(*bytes, kVersion)))
    tell_unknown(context, file, unknown_keys_of_file(*bytes));
}

void check(CommandContext& context, const std::string& file) {
  const auto loaded = load_file_or_fail(context, file);
  if (!loaded) return check_refused(context, file);
  fail_for_missing(context, file, *loaded);
  const Level& level = loaded->level;
  check_keys(context, file, level);
  for (const Problem& problem : lint(level)) {
    const bool is_error = problem.severity == Severity::error;
    const std::string place = place_of(problem, level.tile_count());
    say(context.out, file + (place.empty() ? "" : ":") + place + (is_error ? ": error: " : ": warning: ") +
                         problem.message + " [" + std::string(problem.rule->code) + "]");
    if (is_error) context.status = kExitBad;
  }
}

}  // namespace

void add_check_command(CLI::App& program, CommandContext& context) {
  CLI::App* command =
      program.add_subcommand("check", "List what is likely wrong in a level; exits 1 on errors");
  auto file = std::make_shared<std::string>();
  command->add_option("FILE", *file, "Level or cart")->required();
  add_part_options(*command, context);
  add_outside_option(*command, context);
  add_missing_option(*command, context);
  command->callback([&context, file] { check(context, *file); });
}

}  // namespace talus
