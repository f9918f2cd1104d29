// talus replay SCENARIO.json

#include <ostream>

#include "command.h"
#include "formats/files/atomic_file.h"
#include "formats/last_catch.h"
#include "formats/native/replay.h"

namespace talus {
namespace {

void replay(CommandContext& context, const std::string& file) {
  const auto bytes = read_file(file);
  if (!bytes) return fail(context, file, bytes.error().place, bytes.error().message);
  context.doing = "replaying " + file;
  const auto write = [&](std::string_view line) { return static_cast<bool>(context.out << line << '\n'); };
  const auto replayed = read_guarded([&] { return replay_scenario(*bytes, write); });
  if (!replayed) fail(context, file, replayed.error().place, replayed.error().message);
}

}  // namespace

void add_replay_command(CLI::App& program, CommandContext& context) {
  CLI::App* command =
      program.add_subcommand("replay", "Run a collision scenario: one JSON line for each operation");
  auto file = std::make_shared<std::string>();
  command->add_option("SCENARIO", *file, "Scenario file (JSON)")->required();
  command->callback([&context, file] { replay(context, *file); });
}

}  // namespace talus
