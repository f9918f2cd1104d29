// Tools for the curves of a level, free of the grid. Each makes an Edit and changes nothing itself.
#pragma once

#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

#include "edit.h"

namespace talus {

enum class CurveKind { segment, arc, parabola, cubic, sine, polyline };  // in the order of Curve::form
inline constexpr int kCurveKindCount = 6;

inline CurveKind kind_of(const Curve& curve) { return static_cast<CurveKind>(curve.form.index()); }
std::string_view label_of(CurveKind kind);  // "parabola"
std::string with_article(CurveKind kind);   // "an arc"
// What it is called on screen: its name, or its kind and its number, from 0: "arc 2".
std::string title_of(const Level& level, int curve);

// A curve of this kind between two points, px, as a drag from a to b means it: it stops bodies on the left of
// the way, so that drawn to the right it is a floor, to the left a ceiling. A segment goes straight, an arc
// and a parabola bulge up, a sine makes one wave, a polyline has a height every tile. May be unusable.
Curve curve_between(CurveKind kind, Vec2 a, Vec2 b);
// Appends a curve to the level. The error is one clear sentence, without a full stop.
tl::expected<Edit, std::string> add_curve(const Level& level, LevelCurve curve);
tl::expected<Edit, std::string> add_curve(const Level& level, CurveKind kind, Vec2 a, Vec2 b);
// curve, here and below: an index of Level::curves (asserted).
tl::expected<Edit, std::string> change_curve(const Level& level, int curve, LevelCurve changed,
                                             std::string label);
Edit remove_curve(const Level& level, int curve);
// A copy a tile further to the right and down, or, where the map ends, to the left and up; the last curve of
// the level then.
tl::expected<Edit, std::string> duplicate_curve(const Level& level, int curve);

// The points by which a curve is held: its first end, its last end, then those that bend it. Those of a
// polyline are its points, from left to right; a sine has where it crosses its middle and its first crest.
std::vector<Vec2> handles_of(const Curve& curve);
bool is_end_handle(const Curve& curve, int handle);  // or one that bends it
// Handles that only show where the curve's own line is not: pairs of indices to join by a thin line.
std::vector<std::pair<int, int>> handle_lines(const Curve& curve);
// The curve with one of its handles as near to `to` as may be; it may be unusable then.
Curve with_handle(const Curve& curve, int handle, Vec2 to);

// The first and last end of a good curve.
std::pair<Vec2, Vec2> ends_of_curve(const Curve& curve);
// Points of a good curve's line from left to right, for a drawing of what lies between two x in px: as many
// as `parts` and one, or, where it is straight in between, no more than it needs. None: it is elsewhere.
std::vector<Vec2> points_of(const Curve& curve, double x0, double x1, int parts);
// The curve whose line is nearest to a point, within `reach`, px; -1: none. Unusable ones are left out.
int curve_at(const Level& level, Vec2 at, double reach);

}  // namespace talus
