// The controls of one shape of the ground.
#pragma once

#include <optional>
#include <string_view>

#include "session/session.h"
#include "ui.h"

namespace talus {

// Draws them under names that begin with `name`. The shape as the user has just made it; nothing while it
// stays. stroke: kept between frames; the number of the edit's stroke, 0 when it is no drag.
std::optional<TileShape> draw_shape(std::string_view name, const TileShape& shape, const Session& session,
                                    int& stroke, Ui& ui);
std::string_view kind_label(const TileShape& shape);  // "slope"

}  // namespace talus
