// What levels the window can show.
#pragma once

#include <optional>
#include <string>

#include <talus/formats/format.h>

namespace talus {

// Why the window cannot show a level, the end of a sentence: it draws tiles of 8x8 px only. Nothing if it
// can.
std::optional<std::string> window_problem(const Level& level);
// load_level() for the window: a level that it cannot show is an error.
FormatResult<LoadedLevel> load_for_window(const std::string& path, const ImportChoices& choices = {},
                                          const Progress& progress = {});

}  // namespace talus
