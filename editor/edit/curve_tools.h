// Tools for the curves of a level, free of the grid. Each makes an Edit and changes nothing itself.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "level/edit.h"

namespace talus {

enum class CurveKind { segment, arc, parabola, cubic, sine, polyline };  // in the order of Curve::form
inline constexpr int kCurveKindCount = 6;

inline CurveKind kind_of(const Curve& curve) { return static_cast<CurveKind>(curve.form.index()); }
std::string_view label_of(CurveKind kind);  // "parabola"
std::string with_article(CurveKind kind);   // "an arc"
// The name on screen: its name, or its kind and its number from 0, "arc 2".
std::string title_of(const Level& level, int curve);

// A curve of this kind for a drag from a to b, px. It stops bodies on the left of the drag: drawn to the
// right it is a floor, to the left a ceiling. A segment is straight, an arc and a parabola bulge up, a sine
// makes one wave, a polyline has a height at every tile of this size. The curve may be invalid.
Curve curve_between(CurveKind kind, Vec2 a, Vec2 b, TileSize tile);
// Appends a curve to the level. The error is one sentence without a full stop.
tl::expected<Edit, std::string> add_curve(const Level& level, LevelCurve curve);
tl::expected<Edit, std::string> add_curve(const Level& level, CurveKind kind, Vec2 a, Vec2 b);
// curve, here and below: an index of Level::curves (asserted).
tl::expected<Edit, std::string> change_curve(const Level& level, int curve, LevelCurve changed,
                                             std::string label);
Edit remove_curve(const Level& level, int curve);
// Copies a curve one tile further to the right and down or, if the map ends there, to the left and up. The
// copy is the last curve of the level then.
tl::expected<Edit, std::string> duplicate_curve(const Level& level, int curve);

// The handles of a curve: its first end, its last end, then those that bend it. A polyline has a handle at
// each of its points, from left to right; a sine has one where it crosses its middle and one at its first
// crest.
std::vector<Vec2> handles_of(const Curve& curve);
bool is_end_handle(const Curve& curve, int handle);  // false: it bends the curve
// Pairs of indices of handles to join by a thin line, to show what a handle bends.
std::vector<std::pair<int, int>> handle_lines(const Curve& curve);
// The curve with one of its handles as near to `to` as possible. It may be invalid then.
Curve with_handle(const Curve& curve, int handle, Vec2 to);

// The first and last end of a good curve.
std::pair<Vec2, Vec2> ends_of_curve(const Curve& curve);
// Points of a good curve's line from left to right, for a drawing between two x in px: `parts` + 1 of them,
// or fewer where the line is straight. Empty if the curve is elsewhere.
std::vector<Vec2> points_of(const Curve& curve, double x0, double x1, int parts);
// Returns the curve whose line is nearest to a point, within `reach`, px; -1 if there is none. Unusable
// curves do not count.
int curve_at(const Level& level, Vec2 at, double reach);

}  // namespace talus
