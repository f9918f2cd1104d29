// Writing a level in a game's format, for the commands that do.
#pragma once

#include "command.h"
#include "export/exporter.h"

namespace talus {

// `input`: where the level is from, for errors of its content. "-" as output: standard output. Says on the
// error stream what could not be held.
void write_export(CommandContext& context, const Exporter& exporter, const Level& level,
                  const std::string& input, const std::string& output);

}  // namespace talus
