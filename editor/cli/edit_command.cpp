// talus [edit] [FILE]

#include "command.h"
#include "platform/app.h"

namespace talus {

void add_edit_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("edit", "Open the editor (the default)");
  auto file = std::make_shared<std::string>();
  command->add_option("FILE", *file, "Level or cart to open; without it, the demo level");
  command->callback([&context, file] { context.status = run_editor(*file); });
}

}  // namespace talus
