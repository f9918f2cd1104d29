// Exact shapes are found edge by edge, the nearest ones by columns.
#include "tiled_shapes.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <numbers>
#include <sstream>
#include <utility>

#include <talus/collision/shape_forms.h>
#include "../text/append_number.h"
#include "tiled_objects.h"

namespace talus {
namespace {

constexpr double kSamePlace = 1.0 / 1024;  // px; numbers nearer than that count as equal
constexpr int kMaxParts = 512;             // of a nearest shape, whose parts are matched one by one

using Line = std::vector<Vec2>;  // from left to right

// px, how far shapes reach up from a tile's bottom, and right from its left side.
double highest_of(TileSize tile) { return kMaxShapeTiles * tile.height; }
double widest_of(TileSize tile) { return kMaxShapeTiles * tile.width; }

bool is_at(double a, double b) { return std::abs(a - b) <= kSamePlace; }

// Twice the area; positive if the points go clockwise on the screen.
double area_of(const Line& points) {
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

// Whole tiles from x 0 to an outline's right end.
double width_of(const Line& points, TileSize tile) {
  double right = 0;
  for (const Vec2 p : points) right = std::max(right, p.x);
  return std::clamp(std::ceil((right - kSamePlace) / tile.width), 1.0, double{kMaxShapeTiles}) * tile.width;
}

Line upside_down(Line points, TileSize tile) {
  for (Vec2& p : points) p.y = tile.height - p.y;
  return points;
}

// Drops the points that lie between two others on one line. The line goes to the right, so none of them turns
// back.
Line corners_of(const Line& line) {
  Line corners;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool is_end = i == 0 || i + 1 == line.size();
    if (!is_end) {
      const Vec2 from = corners.back(), to = line[i + 1];
      if (is_at(line[i].y, from.y + (to.y - from.y) * ((line[i].x - from.x) / (to.x - from.x)))) continue;
    }
    corners.push_back(line[i]);
  }
  return corners;
}

// The edges of an outline that go to the right, in order, if all other edges are level at the tile's
// bottom, or upright at x 0 and `width`. The outline must be clockwise. Empty if it is not like this.
Line upper_line(const Line& points, double width, TileSize tile) {
  const std::size_t count = points.size();
  const auto at = [&](std::size_t i) { return points[i % count]; };
  const auto goes_right = [&](std::size_t i) { return at(i + 1).x > at(i).x + kSamePlace; };
  std::size_t first = count;
  for (std::size_t i = 0; i < count; ++i) {
    if (goes_right(i) && (first == count || at(i).x < at(first).x)) first = i;
  }
  if (first == count) return {};
  Line line = {at(first)};
  for (std::size_t i = first; i < first + count; ++i) {
    const Vec2 from = at(i), to = at(i + 1);
    if (goes_right(i)) {
      if (!is_at(from.x, line.back().x) || !is_at(from.y, line.back().y)) return {};
      line.push_back(to);
    } else if (to.x < from.x - kSamePlace) {
      if (!is_at(from.y, tile.height) || !is_at(to.y, tile.height)) return {};
    } else if (!is_at(from.y, to.y) && !is_at(from.x, 0) && !is_at(from.x, width)) {
      return {};
    }
  }
  return line;
}

// Adds the parts at the bottom beside it, from x 0 to `width`. Empty if the line does not end there.
Line over_whole_tiles(Line line, double width, TileSize tile) {
  const double bottom = tile.height;
  if (line.empty() || line.front().x < -kSamePlace || line.back().x > width + kSamePlace) return {};
  if (line.front().x > kSamePlace) {
    if (!is_at(line.front().y, bottom)) return {};
    line.insert(line.begin(), {0, bottom});
  }
  if (line.back().x < width - kSamePlace) {
    if (!is_at(line.back().y, bottom)) return {};
    line.push_back({width, bottom});
  }
  return line;
}

// The heights of a line at the fewest equal distances that include all its corners; empty if there are none.
std::vector<double> heights_of(const Line& line, double width, TileSize tile) {
  for (int parts = 1; parts < max_shape_heights(tile); ++parts) {
    const double step = width / parts;
    const bool fits = std::all_of(line.begin(), line.end(),
                                  [&](Vec2 p) { return is_at(p.x, std::round(p.x / step) * step); });
    if (!fits) continue;
    std::vector<double> heights;
    std::size_t at = 0;
    for (int i = 0; i <= parts; ++i) {
      const double x = i * step;
      while (at + 2 < line.size() && line[at + 1].x < x - kSamePlace) ++at;
      const Vec2 from = line[at], to = line[at + 1];
      const double y = is_at(x, from.x) ? from.y
                       : is_at(x, to.x) ? to.y
                                        : from.y + (to.y - from.y) * ((x - from.x) / (to.x - from.x));
      heights.push_back(std::clamp(weld(tile.height - y), 0.0, highest_of(tile)));
    }
    return heights;
  }
  return {};
}

std::optional<TileShape> shape_under(const Line& line, double width, TileShape::Side side, TileSize tile) {
  if (line.empty()) return {};
  TileShape shape;
  shape.side = side;
  shape.tiles = static_cast<int>(std::lround(width / tile.width));
  shape.heights = heights_of(corners_of(line), width, tile);
  shape.kind = shape.heights.size() == 2 ? TileShape::Kind::slope : TileShape::Kind::profile;
  const bool in_range = std::all_of(line.begin(), line.end(), [&](Vec2 p) {
    return p.y <= tile.height + kSamePlace && p.y >= tile.height - highest_of(tile) - kSamePlace;
  });
  if (!in_range || problem_of(shape, tile)) return {};
  const bool is_full = shape.tiles == 1 && shape.heights == std::vector<double>(2, tile.height);
  return is_full ? TileShape{.kind = TileShape::Kind::solid} : shape;
}

// ---- The nearest ----

struct Stretch {  // of a column, from the upper y to the lower one
  double from, to;
  double length() const { return std::max(0.0, to - from); }
};

// The part of an upright line that is in the outline, from top to bottom, as far as shapes reach.
std::vector<Stretch> column_at(const Line& outline, double x, TileSize tile) {
  const double highest = highest_of(tile);
  std::vector<double> crossings;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    if ((a.x <= x) != (b.x <= x))
      crossings.push_back(std::clamp(a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)), -highest, 2 * highest));
  }
  std::sort(crossings.begin(), crossings.end());
  std::vector<Stretch> column;
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    if (crossings[i] < crossings[i + 1]) column.push_back({crossings[i], crossings[i + 1]});
  }
  return column;
}

// The upper line at x; the bottom if nothing is there.
double top_at(const Line& outline, double x, TileSize tile) {
  const double bottom = tile.height;
  const std::vector<Stretch> column = column_at(outline, x, tile);
  return column.empty() ? bottom : std::clamp(column.front().from, bottom - highest_of(tile), bottom);
}

struct Candidate {
  TileShape shape;
  double both = 0, more = 0, less = 0;  // px², see NearestShape
  bool is_mostly_air() const { return more > (both + less) / 2; }
};

// A floor along the upper line, with corners as near to one another as a profile can have them.
std::optional<Candidate> nearest_floor(const Line& outline, TileSize tile) {
  const int count = std::min(max_shape_heights(tile) - 1, kMaxParts);
  constexpr double kBeside = 1.0 / 4096;  // px, to either side of a corner
  const double width = width_of(outline, tile), step = width / count;
  Line line;
  for (int i = 0; i <= count; ++i) {
    const double x = i * step;
    const double left = top_at(outline, i == 0 ? kBeside : x - kBeside, tile);
    const double right = top_at(outline, i == count ? width - kBeside : x + kBeside, tile);
    line.push_back({x, weld(std::min(left, right))});
  }
  auto shape = shape_under(line, width, TileShape::Side::floor, tile);
  if (!shape) return {};
  Candidate nearest{*std::move(shape)};
  constexpr int kSamples = 4;  // for each part
  const double thickness = step / kSamples;
  for (int i = 0; i < count * kSamples; ++i) {
    const std::size_t part = static_cast<std::size_t>(i / kSamples);
    const double along = (i % kSamples + 0.5) / kSamples;
    const Stretch ground{line[part].y + (line[part + 1].y - line[part].y) * along, 1.0 * tile.height};
    double both = 0, there = 0;
    for (const Stretch& s : column_at(outline, (i + 0.5) * thickness, tile)) {
      there += s.length();
      both += Stretch{std::max(s.from, ground.from), std::min(s.to, ground.to)}.length();
    }
    nearest.both += both * thickness;
    nearest.more += (ground.length() - both) * thickness;
    nearest.less += (there - both) * thickness;
  }
  for (double x = -widest_of(tile) + 0.25; x < 0; x += 0.5) {  // left of the tile
    for (const Stretch& s : column_at(outline, x, tile)) nearest.less += s.length() / 2;
  }
  return nearest;
}

std::string area_text(double area) {
  std::string text;
  append_number(text, std::round(area * 10) / 10);
  return text + " px\u00b2";
}

}  // namespace

std::vector<Vec2> outline_of(const TiledObject& object) {
  Line points = object.points;
  if (object.form == TiledObject::Form::box)
    points = {{0, 0}, {object.size.x, 0}, object.size, {0, object.size.y}};
  else if (object.form == TiledObject::Form::ellipse)
    points = polygon_of_ellipse({0, 0, object.size.x, object.size.y}).points;
  else if (object.form != TiledObject::Form::polygon)
    return {};
  const double angle = object.rotation * std::numbers::pi / 180;
  const Vec2 right = object.rotation == 0 ? Vec2{1, 0} : Vec2{std::cos(angle), std::sin(angle)};
  for (Vec2& p : points)
    p = object.position + Vec2{p.x * right.x - p.y * right.y, p.x * right.y + p.y * right.x};
  return points;
}

std::optional<TileShape> tile_shape_of(const std::vector<Vec2>& outline, bool one_way, TileSize tile) {
  Line points = outline;
  const double area = area_of(points), width = width_of(points, tile);
  if (std::abs(area) < kSamePlace) return {};
  if (area < 0) std::reverse(points.begin(), points.end());
  for (const auto side : {TileShape::Side::floor, TileShape::Side::ceiling}) {
    if (side == TileShape::Side::ceiling) {
      points = upside_down(points, tile);
      std::reverse(points.begin(), points.end());  // clockwise again
    }
    const Line upper = upper_line(points, width, tile), line = over_whole_tiles(upper, width, tile);
    // The line of a one-way tile stops bodies at the bottom, too.
    if (one_way && line.size() != upper.size()) continue;
    if (auto shape = shape_under(line, width, side, tile)) {
      shape->one_way = one_way;
      return shape;
    }
  }
  return {};
}

std::optional<TileShape> polygon_of(const std::vector<Vec2>& outline, bool one_way, TileSize tile) {
  TileShape shape;
  shape.kind = TileShape::Kind::polygon;
  shape.one_way = one_way;
  for (const Vec2 point : outline) {
    if (shape.points.empty() || weld(point) != shape.points.back()) shape.points.push_back(weld(point));
  }
  while (shape.points.size() > 1 && shape.points.front() == shape.points.back()) shape.points.pop_back();
  if (problem_of(shape, tile)) return {};
  return shape;
}

TiledProperty polygon_word() { return {"shape", std::string("polygon")}; }

bool says_polygon(const TiledObject& object) {
  return std::find(object.properties.begin(), object.properties.end(), polygon_word()) !=
         object.properties.end();
}

std::optional<TileShape> shape_of_object(const TiledObject& object, const std::vector<Vec2>& outline,
                                         bool one_way, bool is_ceiling, TileSize tile) {
  auto of_line = says_polygon(object) ? std::nullopt : tile_shape_of(outline, one_way, tile);
  // A one-way plank at the top of its tile looks like a ceiling, but bodies stand on it.
  if (of_line && (!one_way || is_ceiling || of_line->side == TileShape::Side::floor)) return of_line;
  return polygon_of(outline, one_way, tile);
}

std::optional<NearestShape> nearest_tile_shape(const std::vector<Vec2>& outline, TileSize tile) {
  const bool is_in_reach = std::all_of(outline.begin(), outline.end(), [](Vec2 p) {
    return std::abs(p.x) <= kMaxCoordinate && std::abs(p.y) <= kMaxCoordinate;
  });
  if (!is_in_reach) return {};
  auto floor = nearest_floor(outline, tile), ceiling = nearest_floor(upside_down(outline, tile), tile);
  if (!floor || !ceiling || floor->both + ceiling->both < kSamePlace) return {};
  if (floor->is_mostly_air() && ceiling->is_mostly_air()) {
    floor->shape.one_way = true;
    return NearestShape{std::move(floor->shape), 0, floor->both + floor->less};
  }
  const bool is_floor = floor->more + floor->less <= ceiling->more + ceiling->less;
  Candidate& best = is_floor ? *floor : *ceiling;
  if (!is_floor && best.shape.kind != TileShape::Kind::solid) best.shape.side = TileShape::Side::ceiling;
  return NearestShape{std::move(best.shape), best.more, best.less};
}

std::string difference_text(const NearestShape& nearest) {
  const TileShape& shape = nearest.shape;
  if (shape.one_way) return "which hangs in the air: its upper line is kept, as a one-way floor";
  const bool is_floor = shape.side == TileShape::Side::floor;
  const bool is_full = shape.kind == TileShape::Kind::solid;
  std::string text = "which is not a floor or ceiling of a level: ";
  text += is_full ? "a whole tile" : is_floor ? "the nearest floor" : "the nearest ceiling";
  constexpr double kSeen = 0.05;  // px²
  if (nearest.more < kSeen && nearest.less < kSeen)
    return text + " stands for it, off by less than 0.1 px\u00b2";
  text += " stands for it, with ";
  if (nearest.more >= kSeen) text += area_text(nearest.more) + " of ground more";
  if (nearest.less < kSeen) return text;
  return text + (nearest.more >= kSeen ? " and " : "") + area_text(nearest.less) + " less";
}

TileShape as_in_words(const TileShape& shape, const TiledTile& tile, TileSize size) {
  const auto* const text = find_property<std::string>(tile.properties, "shape_heights");
  if (text == nullptr || shape.heights.empty()) return shape;
  TileShape said = shape;
  said.heights.clear();
  std::istringstream words(*text);
  words.imbue(std::locale::classic());
  for (double height = 0; words >> height;) said.heights.push_back(height);
  said.kind = said.heights.size() == 2 ? TileShape::Kind::slope : TileShape::Kind::profile;
  const std::vector<TiledObject> outline = tiled_objects(said, size);
  if (outline.empty()) return shape;
  return tile_shape_of(outline_of(outline.front()), shape.one_way, size) == shape ? said : shape;
}

TiledObject turned(const TiledObject& object, std::uint32_t turn, TileSize tile) {
  TiledObject result;
  result.form = TiledObject::Form::polygon;
  result.properties = object.properties;
  result.points = outline_of(object);
  if (turn == 0 || result.points.empty()) return object;
  if (turn & kTiledFlipXY) std::swap(tile.width, tile.height);  // the others mirror what it has turned
  for (Vec2& p : result.points) {
    if (turn & kTiledFlipXY) std::swap(p.x, p.y);
    if (turn & kTiledFlipX) p.x = tile.width - p.x;
    if (turn & kTiledFlipY) p.y = tile.height - p.y;
  }
  return result;
}

TiledObject stretched(const TiledObject& object, Vec2 by) {
  TiledObject result;
  result.form = TiledObject::Form::polygon;
  result.properties = object.properties;
  result.points = outline_of(object);
  if (result.points.empty()) return object;
  for (Vec2& p : result.points) p = {p.x * by.x, p.y * by.y};
  return result;
}

}  // namespace talus
