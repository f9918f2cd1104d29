// Curves by kind: how a drag makes one, and how its handles bend it.
#include "curve_tools.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "distance_to_line.h"
#include "level/transform.h"
#include "shape_tools.h"

namespace talus {
namespace {

constexpr std::array<std::string_view, kCurveKindCount> kLabels = {"segment", "arc",  "parabola",
                                                                   "cubic",   "sine", "polyline"};
constexpr double kLeastBulge = 0.25;  // px, between the middles of an arc and of its chord

// The ends in the order that the form needs. faces: of the way from a to b.
Curve segment_along(Vec2 a, Vec2 b, bool both) {
  const bool forwards = a.x != b.x ? a.x < b.x : b.y < a.y;
  const bool in_order = a.x != b.x ? a.x < b.x : a.y < b.y;
  Curve curve;
  curve.form = in_order ? Segment{a, b} : Segment{b, a};
  curve.faces = both ? Curve::Faces::both : forwards ? Curve::Faces::up : Curve::Faces::down;
  return curve;
}

// The arc from a to b, a.x < b.x, whose middle is `bulge` px above (or below) that of its chord, at most a
// half circle.
Arc arc_through(Vec2 a, Vec2 b, double bulge) {
  const Vec2 chord = b - a, middle = (a + b) * 0.5;
  const double length = std::hypot(chord.x, chord.y);
  const Vec2 up{chord.y / length, -chord.x / length};
  const double steepness = std::atan(std::abs(chord.y) / chord.x);
  const double most = length / 2 * std::tan((std::numbers::pi / 2 - steepness) / 2);
  const double s = std::clamp(std::abs(bulge), std::min(kLeastBulge, most), most);
  const bool upper = bulge >= 0;
  const double exact_radius = (length * length / 4 + s * s) / (2 * s), below = exact_radius - s;
  Arc arc{.center = weld(middle - up * (upper ? below : -below)),
          .radius = weld(exact_radius),
          .x0 = a.x,
          .x1 = b.x,
          .upper = upper};
  arc.x0 = std::max(arc.x0, arc.center.x - arc.radius);
  arc.x1 = std::min(arc.x1, arc.center.x + arc.radius);
  return arc;
}

double height_of(const Segment& s, double x) {
  return s.to.x == s.from.x ? s.from.y : std::lerp(s.from.y, s.to.y, (x - s.from.x) / (s.to.x - s.from.x));
}
double height_of(const Arc& a, double x) {
  const double u = x - a.center.x, height = std::sqrt(std::max(0.0, (a.radius - u) * (a.radius + u)));
  return a.center.y + (a.upper ? -height : height);
}
double height_of(const Parabola& p, double x) {
  const double t = (x - p.from.x) / (p.to.x - p.from.x);
  return std::lerp(std::lerp(p.from.y, p.control_y, t), std::lerp(p.control_y, p.to.y, t), t);
}
double height_of(const Cubic& c, double x) {
  const double width = c.to.x - c.from.x, t = (x - c.from.x) / width, u = 1 - t;
  return (1 + 2 * t) * u * u * c.from.y + t * u * u * width * c.from_slope + t * t * (3 - 2 * t) * c.to.y -
         t * t * u * width * c.to_slope;
}
double height_of(const Sine& s, double x) {
  return s.middle + s.amplitude * std::sin(2 * std::numbers::pi * std::remainder(x - s.origin, s.wavelength) /
                                           s.wavelength);
}
double height_of(const Polyline& p, double x) {
  const double parts = static_cast<double>(p.ys.size() - 1);
  const double at = std::clamp((x - p.x0) / (p.x1 - p.x0) * parts, 0.0, parts);
  const auto left = std::min(static_cast<std::size_t>(at), p.ys.size() - 2);
  return std::lerp(p.ys[left], p.ys[left + 1], at - static_cast<double>(left));
}

struct Extent {
  double x0, x1;
};
Extent extent_of(const Segment& s) { return {s.from.x, s.to.x}; }
Extent extent_of(const Parabola& p) { return {p.from.x, p.to.x}; }
Extent extent_of(const Cubic& c) { return {c.from.x, c.to.x}; }
template <class Form>
Extent extent_of(const Form& form) {
  return {form.x0, form.x1};
}

// Where a sine first crosses its middle, within its ends or just behind them.
double first_origin(const Sine& s) {
  return s.origin + std::ceil((s.x0 - s.origin) / s.wavelength - 1e-9) * s.wavelength;
}

// The handles that bend a curve, without its ends.
void add_handles(const Segment&, std::vector<Vec2>&) {}
void add_handles(const Arc& a, std::vector<Vec2>& handles) {
  const Vec2 out = (handles[0] + handles[1]) * 0.5 - a.center;
  const double length = std::hypot(out.x, out.y);
  handles.push_back(length > 0 ? a.center + out * (a.radius / length)
                               : a.center + Vec2{0, a.upper ? -a.radius : a.radius});
}
void add_handles(const Parabola& p, std::vector<Vec2>& handles) {
  handles.push_back({(p.from.x + p.to.x) / 2, p.control_y});
}
void add_handles(const Cubic& c, std::vector<Vec2>& handles) {
  const double third = (c.to.x - c.from.x) / 3;
  handles.push_back({c.from.x + third, c.from.y + c.from_slope * third});
  handles.push_back({c.to.x - third, c.to.y - c.to_slope * third});
}
void add_handles(const Sine& s, std::vector<Vec2>& handles) {
  const double origin = first_origin(s);
  handles.push_back({origin, s.middle});
  handles.push_back({origin + s.wavelength / 4, s.middle + s.amplitude});
}
void add_handles(const Polyline& p, std::vector<Vec2>& handles) {
  handles.clear();
  const double parts = static_cast<double>(p.ys.size() - 1);
  for (std::size_t i = 0; i < p.ys.size(); ++i)
    handles.push_back({std::lerp(p.x0, p.x1, static_cast<double>(i) / parts), p.ys[i]});
}

// A form with a handle moved.
Arc bent(const Arc& a, int handle, Vec2 to) {
  Vec2 left{a.x0, height_of(a, a.x0)}, right{a.x1, height_of(a, a.x1)};
  const Vec2 before = right - left;
  const double length = std::hypot(before.x, before.y);
  if (handle == 2) {
    const Vec2 up{before.y / length, -before.x / length};
    return arc_through(left, right, dot(to - (left + right) * 0.5, up));
  }
  (handle == 0 ? left : right) = to;
  // the curve is invalid, which is reported
  if (!(left.x < right.x)) return {a.center, a.radius, left.x, right.x, a.upper};
  const double half = std::asin(std::min(1.0, length / 2 / a.radius));  // half of its angle
  const double bulge = std::hypot(right.x - left.x, right.y - left.y) / 2 * std::tan(half / 2);
  return arc_through(left, right, a.upper ? bulge : -bulge);
}
Parabola bent(Parabola p, int handle, Vec2 to) {
  if (handle == 2)
    p.control_y = to.y;
  else
    (handle == 0 ? p.from : p.to) = to;
  return p;
}
Cubic bent(Cubic c, int handle, Vec2 to) {
  const double third = (c.to.x - c.from.x) / 3;
  if (handle == 0) c.from = to;
  if (handle == 1) c.to = to;
  if (handle == 2) c.from_slope = (to.y - c.from.y) / third;
  if (handle == 3) c.to_slope = (c.to.y - to.y) / third;
  return c;
}
Sine bent(Sine s, int handle, Vec2 to) {
  if (handle == 0) s.x0 = to.x;
  if (handle == 1) s.x1 = to.x;
  if (handle == 2) {
    s.origin = to.x;
    s.middle = to.y;
  }
  if (handle == 3) {
    s.origin = first_origin(s);
    s.wavelength = 4 * (to.x - s.origin);
    s.amplitude = to.y - s.middle;
  }
  return s;
}
Polyline bent(Polyline p, int handle, Vec2 to) {
  const auto point = static_cast<std::size_t>(handle);
  if (point == 0) p.x0 = to.x;
  if (point + 1 == p.ys.size()) p.x1 = to.x;
  p.ys[point] = to.y;
  return p;
}

// A segment may be turned past the vertical: it keeps stopping bodies on the same side.
Curve bent_segment(const Curve& curve, int handle, Vec2 to) {
  const auto& s = std::get<Segment>(curve.form);
  const bool both = curve.faces == Curve::Faces::both;
  const bool turned = (s.from.x == s.to.x) != (curve.faces == Curve::Faces::down);
  Vec2 ends[] = {s.from, s.to};
  ends[handle] = to;
  return turned && !both ? segment_along(ends[1], ends[0], both) : segment_along(ends[0], ends[1], both);
}

// Distance of a point from a good curve's line where that is within `reach` in x; infinite elsewhere.
double distance_to(const Curve& curve, Vec2 p, double reach) {
  if (const auto* segment = std::get_if<Segment>(&curve.form))
    return distance_to_line(segment->from, segment->to, p);
  return std::visit(
      [&](const auto& form) {
        constexpr int kParts = 16;
        const Extent whole = extent_of(form);
        const double x0 = std::max(whole.x0, p.x - reach), x1 = std::min(whole.x1, p.x + reach);
        double least = std::numeric_limits<double>::infinity();
        if (x0 > x1) return least;
        Vec2 last{x0, height_of(form, x0)};
        for (int i = 1; i <= kParts; ++i) {
          const double x = std::lerp(x0, x1, static_cast<double>(i) / kParts);
          const Vec2 next{x, height_of(form, x)};
          least = std::min(least, distance_to_line(last, next, p));
          last = next;
        }
        return least;
      },
      curve.form);
}

std::optional<std::string> refusal(const Level& level, const Curve& curve) {
  const auto problem = problem_of(curve, level.map);
  if (!problem) return std::nullopt;
  return "the " + std::string(label_of(kind_of(curve))) + " " + *problem;
}

}  // namespace

std::string_view label_of(CurveKind kind) { return kLabels[static_cast<std::size_t>(kind)]; }

std::string with_article(CurveKind kind) {
  return (kind == CurveKind::arc ? "an " : "a ") + std::string(label_of(kind));
}

std::string title_of(const Level& level, int curve) {
  const LevelCurve& titled = level.curves[static_cast<std::size_t>(curve)];
  if (!titled.name.empty()) return titled.name;
  return std::string(label_of(kind_of(titled.curve))) + " " + std::to_string(curve);
}

Curve curve_between(CurveKind kind, Vec2 a, Vec2 b, TileSize tile) {
  if (kind == CurveKind::segment) return segment_along(a, b, false);
  Curve curve;
  curve.faces = a.x <= b.x ? Curve::Faces::up : Curve::Faces::down;
  if (a.x > b.x) std::swap(a, b);
  const double width = b.x - a.x;
  switch (kind) {
    case CurveKind::arc:
      curve.form = width > 0 ? arc_through(a, b, std::hypot(width, b.y - a.y) / 4)
                             : Arc{.center = a, .radius = 1, .x0 = a.x, .x1 = b.x};
      break;
    case CurveKind::parabola:
      curve.form = Parabola{a, b, std::round((a.y + b.y - width) / 2)};
      break;
    case CurveKind::cubic: {  // an S; or a hill between ends of one height, which would make a line
      const double slope = a.y == b.y ? 1 : 0;
      curve.form = Cubic{a, b, -slope, slope};
      break;
    }
    case CurveKind::sine:
      curve.form = Sine{.x0 = a.x,
                        .x1 = b.x,
                        .middle = a.y,
                        .amplitude = a.y == b.y ? -std::round(width / 8) : b.y - a.y,
                        .wavelength = width,
                        .origin = a.x};
      break;
    default: {
      Polyline line{.x0 = a.x, .x1 = b.x, .ys = {}};
      const int parts = std::max(1, static_cast<int>(std::round(width / tile.width)));
      for (int i = 0; i <= parts; ++i)
        line.ys.push_back(weld(std::lerp(a.y, b.y, static_cast<double>(i) / parts)));
      curve.form = std::move(line);
      break;
    }
  }
  return curve;
}

tl::expected<Edit, std::string> add_curve(const Level& level, LevelCurve curve) {
  if (auto why = refusal(level, curve.curve)) return tl::unexpected(*std::move(why));
  std::string label = "Add " + with_article(kind_of(curve.curve));
  std::vector<LevelCurve> curves = level.curves;
  curves.push_back(std::move(curve));
  return set_curves(level, std::move(curves), std::move(label));
}

tl::expected<Edit, std::string> add_curve(const Level& level, CurveKind kind, Vec2 a, Vec2 b) {
  if (a == b) return tl::unexpected<std::string>(kNoLength);
  return add_curve(level,
                   {.name = {}, .curve = curve_between(kind, a, b, level.map.tile_size()), .extra = {}});
}

tl::expected<Edit, std::string> change_curve(const Level& level, int curve, LevelCurve changed,
                                             std::string label) {
  assert(curve >= 0 && static_cast<std::size_t>(curve) < level.curves.size());
  if (auto why = refusal(level, changed.curve)) return tl::unexpected(*std::move(why));
  std::vector<LevelCurve> curves = level.curves;
  curves[static_cast<std::size_t>(curve)] = std::move(changed);
  return set_curves(level, std::move(curves), std::move(label));
}

Edit remove_curve(const Level& level, int curve) {
  assert(curve >= 0 && static_cast<std::size_t>(curve) < level.curves.size());
  std::vector<LevelCurve> curves = level.curves;
  const std::string label = "Remove " + with_article(kind_of(curves[curve].curve));
  curves.erase(curves.begin() + curve);
  return set_curves(level, std::move(curves), label);
}

tl::expected<Edit, std::string> duplicate_curve(const Level& level, int curve) {
  assert(curve >= 0 && static_cast<std::size_t>(curve) < level.curves.size());
  LevelCurve copy = level.curves[static_cast<std::size_t>(curve)];
  const Curve original = copy.curve;
  for (const Cell by : {Cell{1, 1}, Cell{1, -1}, Cell{-1, 1}, Cell{-1, -1}}) {
    copy.curve = moved(original, level.map.corner_of(by));
    if (!problem_of(copy.curve, level.map)) break;
  }
  return add_curve(level, std::move(copy));
}

std::vector<Vec2> handles_of(const Curve& curve) {
  const auto [first, last] = ends_of_curve(curve);
  std::vector<Vec2> handles = {first, last};
  std::visit([&](const auto& form) { add_handles(form, handles); }, curve.form);
  return handles;
}

bool is_end_handle(const Curve& curve, int handle) {
  const auto* line = std::get_if<Polyline>(&curve.form);
  if (line == nullptr) return handle < 2;
  return handle == 0 || handle + 1 == static_cast<int>(line->ys.size());
}

std::vector<std::pair<int, int>> handle_lines(const Curve& curve) {
  switch (kind_of(curve)) {
    case CurveKind::parabola:
      return {{0, 2}, {2, 1}};
    case CurveKind::cubic:
      return {{0, 2}, {1, 3}};
    case CurveKind::sine:
      return {{2, 3}};
    default:
      return {};
  }
}

Curve with_handle(const Curve& curve, int handle, Vec2 to) {
  if (std::holds_alternative<Segment>(curve.form)) return bent_segment(curve, handle, to);
  Curve result = curve;
  std::visit(
      [&](const auto& form) {
        using Form = std::decay_t<decltype(form)>;
        if constexpr (!std::is_same_v<Form, Segment>) result.form = bent(form, handle, to);
      },
      curve.form);
  return result;
}

std::pair<Vec2, Vec2> ends_of_curve(const Curve& curve) {
  if (const auto* segment = std::get_if<Segment>(&curve.form)) return {segment->from, segment->to};
  return std::visit(
      [](const auto& form) {
        const Extent span = extent_of(form);
        return std::pair(Vec2{span.x0, height_of(form, span.x0)}, Vec2{span.x1, height_of(form, span.x1)});
      },
      curve.form);
}

std::vector<Vec2> points_of(const Curve& curve, double x0, double x1, int parts) {
  const auto [first, last] = ends_of_curve(curve);
  x0 = std::max(x0, first.x);
  x1 = std::min(x1, last.x);
  if (x0 > x1) return {};
  if (kind_of(curve) == CurveKind::segment) return {first, last};
  std::vector<Vec2> points;
  if (const auto* line = std::get_if<Polyline>(&curve.form)) {
    const auto part = [&, count = static_cast<double>(line->ys.size() - 1)](double x) {
      return (x - line->x0) / (line->x1 - line->x0) * count;
    };
    const auto from = static_cast<std::size_t>(part(x0)), to = static_cast<std::size_t>(std::ceil(part(x1)));
    const std::vector<Vec2> all = handles_of(curve);
    points.assign(all.begin() + static_cast<std::ptrdiff_t>(from),
                  all.begin() + static_cast<std::ptrdiff_t>(std::min(to + 1, all.size())));
    return points;
  }
  for (int i = 0; i <= parts; ++i) {
    const double x = std::lerp(x0, x1, static_cast<double>(i) / parts);
    points.push_back({x, std::visit([x](const auto& form) { return height_of(form, x); }, curve.form)});
  }
  return points;
}

int curve_at(const Level& level, Vec2 at, double reach) {
  int found = -1;
  double least = reach;
  for (std::size_t i = 0; i < level.curves.size(); ++i) {
    const Curve& curve = level.curves[i].curve;
    if (problem_of(curve, level.map)) continue;
    const double distance = distance_to(curve, at, reach);
    if (distance > least) continue;
    least = distance;
    found = static_cast<int>(i);
  }
  return found;
}

}  // namespace talus
