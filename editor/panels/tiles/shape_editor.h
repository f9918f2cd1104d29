// The controls of one shape of the ground.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "panels/ui/number_field.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// The list of kinds, which is `shown` while it is closed. The one that has just been chosen instead of `now`.
std::optional<TileShape::Kind> choose_shape_kind(std::string_view name, TileShape::Kind now,
                                                 const std::string& shown, Ui& ui);
// The fields of its kind, under names that begin with `name`; none of no shape. The shape as the user has
// just made it; nothing while it stays. A number that no shape can have is refused in a message when it is
// typed, and not reached by a drag. edit: kept between frames; its stroke is 0 when it is no drag.
std::optional<TileShape> draw_shape_fields(std::string_view name, const TileShape& shape,
                                           const Session& session, NumberEdit& edit, Actions& actions,
                                           Ui& ui);
std::string_view kind_label(const TileShape& shape);  // "slope"

}  // namespace talus
