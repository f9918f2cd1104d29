// The controls of one shape of the ground.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "panels/ui/number_field.h"
#include "panels/ui/ui.h"
#include "session/session.h"

namespace talus {

// A shape is made of such a kind, or is a group of them.
inline constexpr std::array<TileShape::Kind, 4> kPartKinds = {
    TileShape::Kind::solid, TileShape::Kind::slope, TileShape::Kind::profile, TileShape::Kind::polygon};

// The list of kinds, which shows `shown` while it is closed. Returns the new choice, if it is not `now`.
std::optional<TileShape::Kind> choose_shape_kind(std::string_view name, TileShape::Kind now,
                                                 const std::string& shown, Ui& ui);
// The fields of its kind, with names that begin with `name`; no fields for no shape. Returns the shape after
// a change by the user; nothing while it does not change. A typed number that no shape can have is refused by
// a message; a drag does not reach it. edit: kept between frames; its stroke is 0 unless there is a drag.
std::optional<TileShape> draw_shape_fields(std::string_view name, const TileShape& shape,
                                           const Session& session, NumberEdit& edit, Actions& actions,
                                           Ui& ui);
std::string_view kind_label(const TileShape& shape);  // "slope"
std::string_view kind_label(TileShape::Kind kind);    // the same

}  // namespace talus
