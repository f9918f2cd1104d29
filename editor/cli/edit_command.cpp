// talus [edit] [FILE...]

#include "command.h"
#include "platform/app.h"

namespace talus {

void add_edit_command(CLI::App& program, CommandContext& context) {
  CLI::App* command = program.add_subcommand("edit", "Open the editor (the default)");
  auto files = std::make_shared<std::vector<std::string>>();
  command->add_option("FILE", *files,
                      "Levels, carts or folders of maps to open; without it, the welcome page");
  command->callback([&context, files] { context.status = run_editor(*files); });
}

}  // namespace talus
