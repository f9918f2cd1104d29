// Starts programs of others on a level's file, by command lines that the user has written. No shell ever sees
// them, so that no file's name can do harm.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "open_copies.h"
#include "panels/window/programs.h"
#include "session/session.h"

namespace talus {

// The arguments of a command line: words, where "..." and '...' keep blanks, and then {file} and {folder}
// stand for the file and its folder, blanks and quotes in them included. An error in one sentence for an
// empty line, an open quote or another word in braces.
// folder: what {folder} stands for; empty: the folder of the file.
tl::expected<std::vector<std::string>, std::string> split_command(std::string_view line,
                                                                  const std::string& file,
                                                                  const std::string& folder = {});

// Starts it on its own: it goes on when this program ends, and cannot be heard. An error in one sentence when
// there is no such program.
tl::expected<void, std::string> start_detached(const std::vector<std::string>& arguments);

// Whether the program's command line can be understood; a message tells what is wrong with it.
bool can_open(Session& session, ProgramId program, const ProgramCommands& commands);

// Opens the level in the program, its files by whole paths, which no program takes for an option: saves it to
// its own file when that is one of the program's format, or else has a copy of it written, which `copies`
// keeps up to it. LÖVE gets the folder that the level's game is exported to, or else that of the level's
// file. A message tells what was done, or what went wrong.
void open_in_program(Session& session, ProgramId program, const ProgramCommands& commands,
                     OpenCopies& copies);

}  // namespace talus
