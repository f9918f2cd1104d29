// Starts other programs on a level's file, by command lines that the user has written. No shell is involved,
// so the name of a file cannot do harm.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "open_copies.h"
#include "panels/window/programs.h"
#include "session/session.h"

namespace talus {

// Splits a command line into arguments. "..." and '...' keep blanks. Then {file} and {folder} are replaced by
// the file and its folder, with their blanks and quotes. The error for an empty line, an open quote or
// another word in braces is one sentence.
// folder: replaces {folder}; empty: the folder of the file.
tl::expected<std::vector<std::string>, std::string> split_command(std::string_view line,
                                                                  const std::string& file,
                                                                  const std::string& folder = {});

// Starts a program of its own: it goes on when this program ends, and its output is not read. The error, if
// there is no such program, is one sentence.
tl::expected<void, std::string> start_detached(const std::vector<std::string>& arguments);

// Whether the program's command line is valid; a message says what is wrong with it.
bool can_open(Session& session, ProgramId program, const ProgramCommands& commands);

// Opens the level in the program, with absolute paths, which no program takes for options. It saves the level
// to its own file if the program reads that format; if not, it writes a copy, which `copies` keeps up to
// date. LÖVE gets the folder of the level's file. A message says what was done, or what went wrong.
void open_in_program(Session& session, ProgramId program, const ProgramCommands& commands,
                     OpenCopies& copies);

// Runs the game in a folder in LÖVE. A message says what was done, or what went wrong.
void run_game(Session& session, const ProgramCommands& commands, const std::string& folder);

}  // namespace talus
