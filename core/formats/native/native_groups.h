// The groups of layers of native levels.
#pragma once

#include <talus/level/level.h>
#include "../text/json_text.h"

namespace talus {

FormatResult<LayerGroups> take_groups(Json& list);
// What is wrong with the groups that groups and layers of a level say they are in: an error with its place.
FormatResult<void> check_groups(const Level& level);
// The groups as a list, which is empty if there are none.
FormatResult<Json> json_of_groups(const Level& level);

}  // namespace talus
