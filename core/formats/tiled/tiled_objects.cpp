// Converts geometry between levels and Tiled.
#include "tiled_objects.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <talus/level/limits.h>
#include "../../collision/outline_compiler.h"
#include "../text/append_number.h"
#include "../text/xml_text.h"
#include "level/transform.h"

namespace talus {
namespace {

constexpr std::array<std::string_view, 3> kFaceWords = {"up", "down", "both"};
constexpr double kOnGrid = 1.0 / 1024;  // px; numbers nearer than that count as equal

bool is_near(double a, double b) { return std::abs(a - b) <= std::max(tiled_slack(a), tiled_slack(b)); }
bool is_near(Vec2 a, Vec2 b) { return is_near(a.x, b.x) && is_near(a.y, b.y); }

void add(TiledProperties& properties, std::string_view name, double value) {
  properties.push_back({std::string(name), value});
}

// The number of a property, whole or not; nothing if it has none.
std::optional<double> number_of(const TiledProperties& properties, std::string_view name) {
  if (const auto* real = find_property<double>(properties, name)) return *real;
  if (const auto* whole = find_property<std::int64_t>(properties, name)) return static_cast<double>(*whole);
  return std::nullopt;
}

// Of a curve: the sides that stop bodies, and how fast they go.
void take_sides(const TiledProperties& from, Curve& curve) {
  if (const auto* faces = find_property<std::string>(from, "faces")) {
    const auto word = std::find(kFaceWords.begin(), kFaceWords.end(), *faces);
    if (word != kFaceWords.end()) curve.faces = static_cast<Curve::Faces>(word - kFaceWords.begin());
  }
  curve.conveyor = conveyor_of(from, "conveyor").value_or(0);
}

struct CurveNumbers {
  TiledProperties& to;
  void ends(Vec2 from, Vec2 last) const {
    add(to, "x0", from.x), add(to, "y0", from.y), add(to, "x1", last.x), add(to, "y1", last.y);
  }
  void operator()(const Segment& s) const { ends(s.from, s.to); }
  void operator()(const Arc& a) const {
    add(to, "x", a.center.x), add(to, "y", a.center.y), add(to, "radius", a.radius);
    add(to, "x0", a.x0), add(to, "x1", a.x1);
    to.push_back({"upper", a.upper});
  }
  void operator()(const Parabola& p) const {
    ends(p.from, p.to);
    add(to, "control_y", p.control_y);
  }
  void operator()(const Cubic& c) const {
    ends(c.from, c.to);
    add(to, "slope0", c.from_slope), add(to, "slope1", c.to_slope);
  }
  void operator()(const Sine& s) const {
    add(to, "x0", s.x0), add(to, "x1", s.x1), add(to, "middle", s.middle), add(to, "amplitude", s.amplitude);
    add(to, "wavelength", s.wavelength), add(to, "origin", s.origin);
  }
  void operator()(const Polyline& p) const { add(to, "x0", p.x0), add(to, "x1", p.x1); }
};

constexpr std::array<std::string_view, 6> kCurveKinds = {"segment", "arc",  "parabola",
                                                         "cubic",   "sine", "polyline"};

// The form of a kind with the numbers of CurveNumbers, all of which must be there. line: its points.
class FormOfNumbers {
 public:
  FormOfNumbers(const TiledProperties& from, const std::vector<Vec2>& line) : from_(from), line_(line) {}

  std::optional<decltype(Curve::form)> form(std::string_view kind) {
    decltype(Curve::form) made;
    const auto* const upper = find_property<bool>(from_, "upper");
    if (kind == "segment")
      made = Segment{point("x0", "y0"), point("x1", "y1")};
    else if (kind == "arc")
      made = Arc{point("x", "y"), number("radius"), number("x0"), number("x1"), upper != nullptr && *upper};
    else if (kind == "parabola")
      made = Parabola{point("x0", "y0"), point("x1", "y1"), number("control_y")};
    else if (kind == "cubic")
      made = Cubic{point("x0", "y0"), point("x1", "y1"), number("slope0"), number("slope1")};
    else if (kind == "sine")
      made = Sine{number("x0"),        number("x1"),         number("middle"),
                  number("amplitude"), number("wavelength"), number("origin")};
    else if (kind == "polyline" && line_.size() >= 2)
      made = polyline();
    else
      return std::nullopt;
    return is_whole_ ? std::optional(made) : std::nullopt;
  }

 private:
  double number(std::string_view name) {
    if (const auto* real = find_property<double>(from_, name)) return *real;
    if (const auto* whole = find_property<std::int64_t>(from_, name)) return static_cast<double>(*whole);
    is_whole_ = false;
    return 0;
  }
  Vec2 point(std::string_view x, std::string_view y) { return {number(x), number(y)}; }
  Polyline polyline() {
    Polyline made{number("x0"), number("x1"), {}};
    for (const Vec2 p : line_) made.ys.push_back(p.y);
    return made;
  }

  const TiledProperties& from_;
  const std::vector<Vec2>& line_;
  bool is_whole_ = true;
};

constexpr std::array<std::string_view, 18> kCurveProperties = {
    "kind",  "faces",     "x",      "y",      "x0",     "y0",        "x1",         "y1",     "radius",
    "upper", "control_y", "slope0", "slope1", "middle", "amplitude", "wavelength", "origin", "conveyor"};

// A stretch bends to one side only, so no point of it is more than twice as far from the chord as the middle
// one.
void append_stretch(const CurveStretch<double>& stretch, Vec2 from, Vec2 to, int depth,
                    std::vector<Vec2>& points) {
  const double x = from.x + (to.x - from.x) / 2;
  const Vec2 middle = {x, stretch.y_at(x)};
  if (depth > 0 && std::abs(middle.y - (from.y + to.y) / 2) > kTiledTolerance / 2) {
    append_stretch(stretch, from, middle, depth - 1, points);
    append_stretch(stretch, middle, to, depth - 1, points);
  } else {
    points.push_back(to);
  }
}

std::vector<Vec2> points_along(Curve curve) {
  if (const auto* line = std::get_if<Segment>(&curve.form)) return {line->from, line->to};
  std::vector<Vec2> points;
  if (const auto* line = std::get_if<Polyline>(&curve.form)) {
    const auto last = static_cast<double>(line->ys.size() - 1);
    for (std::size_t i = 0; i < line->ys.size(); ++i)
      points.push_back({line->x0 + (line->x1 - line->x0) * (static_cast<double>(i) / last), line->ys[i]});
    return points;
  }
  curve.faces = Curve::Faces::up;  // one piece for each stretch
  constexpr int kMaxDepth = 12;
  const CurveOutline outline = cut_curves({&curve, 1});
  for (const Piece<double>& piece : outline.pieces) {
    if (piece.stretch == 0) continue;
    const Vec2 from = {piece.x0, piece.y0}, to = {piece.x1, piece.y1};
    if (points.empty()) points.push_back(from);
    append_stretch(outline.stretches[piece.stretch - 1], from, to, kMaxDepth, points);
  }
  return points;
}

// The ends in the order that a curve needs.
Segment segment_between(Vec2 a, Vec2 b) {
  if (a.x > b.x || (a.x == b.x && a.y > b.y)) std::swap(a, b);
  return {a, b};
}

// By how much a program moved a point, to whole px if that may be: it wrote few digits.
double shift_between(double from, double to) {
  if (is_near(from, to)) return 0;
  const double whole = std::round(to - from);
  return is_near(from + whole, to) ? whole : to - from;
}
Vec2 shift_between(Vec2 from, Vec2 to) { return {shift_between(from.x, to.x), shift_between(from.y, to.y)}; }

bool goes_in_equal_steps(const std::vector<Vec2>& points) {
  const double step = (points.back().x - points.front().x) / static_cast<double>(points.size() - 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!is_near(points[i].x, points.front().x + step * static_cast<double>(i))) return false;
  }
  return step > 2 * kOnGrid;
}

}  // namespace

std::vector<TiledObject> tiled_objects(const TileShape& shape, TileSize tile) {
  if (shape.kind == TileShape::Kind::none || problem_of(shape, tile)) return {};
  if (shape.kind == TileShape::Kind::group) {
    std::vector<TiledObject> objects;
    for (const TileShape& part : shape.parts) {
      for (TiledObject& object : tiled_objects(part, tile)) objects.push_back(std::move(object));
    }
    return objects;
  }
  TiledObject object;
  if (shape.one_way) object.properties.push_back({"one_way", true});
  if (shape.kind == TileShape::Kind::solid) {
    object.size = {1.0 * tile.width, 1.0 * tile.height};
    return {object};
  }
  object.form = TiledObject::Form::polygon;
  if (shape.kind == TileShape::Kind::polygon) {
    object.points = shape.points;
    return {object};
  }
  const double width = shape.tiles * tile.width;
  const bool is_floor = shape.side == TileShape::Side::floor;
  const double base = is_floor ? tile.height : 0;
  const auto last = static_cast<double>(shape.heights.size() - 1);
  for (std::size_t i = 0; i < shape.heights.size(); ++i) {
    const double h = shape.heights[i];
    object.points.push_back({width * (static_cast<double>(i) / last), is_floor ? base - h : h});
  }
  if (object.points.back().y != base) object.points.push_back({width, base});
  if (object.points.front().y != base) object.points.push_back({0, base});
  if (object.points.size() < 3) return {};  // without a height it has no ground
  return {object};
}

TiledProperties tiled_properties(const TileShape& shape) {
  if (shape.kind == TileShape::Kind::none) return {};
  constexpr std::array<const char*, 6> kKinds = {"", "solid", "slope", "profile", "polygon", "group"};
  TiledProperties properties = {{"shape", std::string(kKinds[static_cast<std::size_t>(shape.kind)])}};
  std::string heights;
  for (const double height : shape.heights) {
    if (!heights.empty()) heights += ' ';
    append_number(heights, height);
  }
  if (has_heights(shape)) properties.push_back({"shape_heights", heights});
  if (shape.one_way) properties.push_back({"shape_one_way", true});
  if (shape.side == TileShape::Side::ceiling) properties.push_back({"shape_side", std::string("ceiling")});
  if (shape.conveyor != 0) properties.push_back({std::string(kTiledConveyor), shape.conveyor});
  return properties;
}

TiledObject tiled_object(const Spawn& spawn) {
  TiledObject object;
  object.name = spawn.name;
  object.type = traits_of(spawn.kind).word;
  object.position = spawn.position;
  object.size = spawn.size;
  add(object.properties, "vx", spawn.velocity.x);
  add(object.properties, "vy", spawn.velocity.y);
  object.properties.push_back({"foot", std::string(spawn.used_foot() == Foot::centre ? "centre" : "box")});
  return object;
}

Vec2 tiled_position(const Spawn& spawn, const TiledObject& object, Vec2 anchor) {
  if (object.form != TiledObject::Form::tile) return spawn.position;
  return spawn.position + Vec2{anchor.x * spawn.size.x, anchor.y * spawn.size.y};
}

std::optional<Spawn> spawn_of(const TiledObject& object, std::string_view type, TileSize tile, Vec2 anchor) {
  const std::optional<BodyKind> kind = find_body_kind(type);
  const bool is_tile = object.form == TiledObject::Form::tile;
  if ((object.form != TiledObject::Form::box && !is_tile) || !kind) return {};
  Spawn spawn;
  spawn.name = object.name;
  spawn.kind = *kind;
  spawn.position = object.position;
  spawn.size = object.size != Vec2{0, 0} ? object.size : new_body_size(*kind, tile);
  if (is_tile) spawn.position = spawn.position - Vec2{anchor.x * spawn.size.x, anchor.y * spawn.size.y};
  spawn.velocity.x = number_of(object.properties, "vx").value_or(0);
  spawn.velocity.y = number_of(object.properties, "vy").value_or(0);
  if (const auto* foot = find_property<std::string>(object.properties, "foot")) {
    if (*foot == "box") spawn.foot = Foot::box;
    if (*foot == "centre") spawn.foot = Foot::centre;
  }
  return spawn;
}

std::optional<double> conveyor_of(const TiledProperties& properties, std::string_view name) {
  const auto speed = number_of(properties, name);
  return speed && std::abs(*speed) <= kMaxConveyor ? speed : std::nullopt;
}

std::optional<TiledObject> tiled_object(const LevelCurve& level_curve) {
  const Curve& curve = level_curve.curve;
  if (problem_of(curve)) return {};
  std::vector<Vec2> points = points_along(curve);
  if (points.size() < 2) return {};
  TiledObject object;
  object.form = TiledObject::Form::polyline;
  object.name = level_curve.name;
  object.type = kTiledCurveType;
  object.position = points.front();
  for (const Vec2 p : points) object.points.push_back(p - object.position);
  object.properties.push_back({"kind", std::string(kCurveKinds[curve.form.index()])});
  object.properties.push_back({"faces", std::string(kFaceWords[static_cast<std::size_t>(curve.faces)])});
  if (curve.conveyor != 0) add(object.properties, "conveyor", curve.conveyor);
  std::visit(CurveNumbers{object.properties}, curve.form);
  return object;
}

std::vector<Curve> curves_of(const TiledObject& object) {
  if (object.form != TiledObject::Form::polyline || object.rotation != 0 || object.points.size() < 2)
    return {};
  std::vector<Vec2> points;
  for (const Vec2 p : object.points) points.push_back(weld(object.position + p));
  Curve made;
  take_sides(object.properties, made);
  if (points.size() > 2 && goes_in_equal_steps(points)) {
    Polyline line{points.front().x, points.back().x, {}};
    for (const Vec2 p : points) line.ys.push_back(p.y);
    made.form = std::move(line);
    return {made};
  }
  std::vector<Curve> curves;
  for (std::size_t i = 1; i < points.size() && curves.size() <= kMaxCurves; ++i) {
    made.form = segment_between(points[i - 1], points[i]);
    curves.push_back(made);
  }
  return curves;
}

std::optional<Curve> curve_of_numbers(const TiledObject& object) {
  const auto* const kind = find_property<std::string>(object.properties, "kind");
  if (kind == nullptr || object.form != TiledObject::Form::polyline) return {};
  std::vector<Vec2> line;
  line.reserve(object.points.size());
  for (const Vec2 p : object.points) line.push_back(object.position + p);
  const auto form = FormOfNumbers(object.properties, line).form(*kind);
  if (!form) return {};
  Curve curve{*form, Curve::Faces::up};
  take_sides(object.properties, curve);
  auto along = tiled_object(LevelCurve{"", curve, ""});
  if (!along) return {};
  const Vec2 by = shift_between(along->position, object.position);
  along->position = object.position;
  return is_same_outline(*along, object) ? std::optional(moved(curve, by)) : std::nullopt;
}

std::span<const std::string_view> curve_properties() { return kCurveProperties; }

double tiled_slack(double number) { return std::max(kOnGrid, 1e-5 * std::abs(number)); }

bool is_same_outline(const TiledObject& a, const TiledObject& b) {
  if (a.form != b.form || a.rotation != b.rotation || a.points.size() != b.points.size()) return false;
  if (!is_near(a.position, b.position) || !is_near(a.size, b.size)) return false;
  return std::equal(a.points.begin(), a.points.end(), b.points.begin(),
                    [](Vec2 p, Vec2 q) { return is_near(p, q); });
}

}  // namespace talus
