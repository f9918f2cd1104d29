// Describes an entry of the history in a few words.
#pragma once

#include <string>

#include "level/edit.h"

namespace talus {

// The edit's label, with what it changed and where: "Paint 12 tiles at (12, 9)", "Change fall speed".
std::string describe(const Edit& edit);

}  // namespace talus
