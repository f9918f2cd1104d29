#include "object_ground.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <talus/level/ground.h>
#include <talus/level/limits.h>
#include "object_cells.h"

namespace talus {
namespace {

// The part of a line on the map; nothing if it is too short.
std::optional<Segment> on_map(Vec2 a, Vec2 b, const TileMap& map) {
  const Vec2 size{map.x_of(map.width()), map.y_of(map.height())};
  double from = 0, to = 1;
  const auto cut = [&](double start, double step, double most) {
    if (step == 0) {
      if (start < 0 || start > most) to = -1;
      return;
    }
    const double t0 = (0 - start) / step, t1 = (most - start) / step;
    from = std::max(from, std::min(t0, t1));
    to = std::min(to, std::max(t0, t1));
  };
  cut(a.x, b.x - a.x, size.x);
  cut(a.y, b.y - a.y, size.y);
  if (!(from < to)) return {};
  const Vec2 start = from == 0 ? a : a + (b - a) * from, end = to == 1 ? b : a + (b - a) * to;
  Segment segment{weld(start), weld(end)};
  if (segment.from == segment.to) return {};
  const bool is_backward =
      segment.from.x > segment.to.x || (segment.from.x == segment.to.x && segment.from.y > segment.to.y);
  if (is_backward) std::swap(segment.from, segment.to);
  return segment;
}

// Twice the area; positive if the points go clockwise on the screen.
double area_of(const std::vector<Vec2>& points) {
  double area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2 a = points[i], b = points[(i + 1) % points.size()];
    area += a.x * b.y - a.y * b.x;
  }
  return area;
}

class ObjectGround {
 public:
  explicit ObjectGround(const Level& level) : level_(level), cells_(level.map) {
    for (const ObjectLayer& layer : level.objects) {
      if (!layer.is_ground) continue;
      const Vec2 offset = shown_looks(level.layers.groups, layer).offset;
      for (MapObject object : layer.objects) {
        object.position = object.position + offset;
        add(object);
      }
    }
    for (const auto& [cell, polygons] : cells_.parts()) add_shape(cell, polygons);
    if (problem_.empty() && level.curves.size() + curves_.size() > kMaxCurves)
      fail("have lines and one-way sides of more than " + std::to_string(kMaxCurves) + " pieces");
    if (problem_.empty() && count() > kMaxTiles) fail("have parts of too many different shapes in its cells");
  }

  std::optional<std::string> problem() const {
    if (problem_.empty()) return std::nullopt;
    return "has objects of ground that " + problem_ + ": it has no ground";
  }
  std::vector<LevelCurve> take_curves() { return std::move(curves_); }
  // The empty tile, the full one, and the shapes.
  int count() const { return level_.tile_count() + 2 + static_cast<int>(shapes_.size()); }
  std::vector<TileShape> shapes() const {
    std::vector<TileShape> all = {{}, {.kind = TileShape::Kind::solid}};
    all.insert(all.end(), shapes_.begin(), shapes_.end());
    return all;
  }
  TileMap map() const {
    TileMap map(level_.map.width(), level_.map.height(), level_.map.tile_size());
    const auto first = static_cast<TileNumber>(level_.tile_count());
    std::size_t at = 0;
    for (Cell cell; cell.y < map.height(); ++cell.y) {
      for (cell.x = 0; cell.x < map.width(); ++cell.x, ++at)
        map.set(cell, static_cast<TileNumber>(cells_.full()[at] ? first + 1 : first));
    }
    for (const auto& [index, number] : numbers_) {
      const auto width = static_cast<std::size_t>(map.width());
      const Cell cell{static_cast<int>(index % width), static_cast<int>(index / width)};
      map.set(cell, static_cast<TileNumber>(first + 2 + number));
    }
    return map;
  }

 private:
  void fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

  void add(const MapObject& object) {
    const std::vector<Vec2> line = line_of(object);
    for (std::size_t i = 1; i < line.size(); ++i)
      add_line(object, line[i - 1], line[i], object.one_way ? Curve::Faces::up : Curve::Faces::both);
    std::vector<Vec2> outline = outline_of(object);
    if (object.one_way) {
      const bool is_clockwise = area_of(outline) > 0;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        if (is_clockwise ? a.x < b.x : b.x < a.x) add_line(object, a, b, Curve::Faces::up);
      }
    } else if (!outline.empty() && !cells_.add(std::move(outline))) {
      const std::string name = object.name.empty() ? "one without a name" : "\"" + object.name + "\"";
      fail("are too large: " + name + " has more than 1024 points, or covers too many cells");
    }
  }

  void add_line(const MapObject& object, Vec2 a, Vec2 b, Curve::Faces faces) {
    const auto segment = on_map(a, b, level_.map);
    if (!segment || (faces == Curve::Faces::up && segment->from.x == segment->to.x)) return;
    Curve curve{*segment, faces};
    if (!problem_of(curve, level_.map)) curves_.push_back({object.name, std::move(curve), ""});
  }

  void add_shape(std::size_t cell, const std::vector<ObjectCells::Part>& polygons) {
    TileShape shape{.kind = TileShape::Kind::group};
    for (const ObjectCells::Part& polygon : polygons) {
      TileShape part{.kind = TileShape::Kind::polygon};
      part.points = polygon.points;
      part.lines = polygon.lines;
      if (!problem_of(part, level_.map.tile_size())) shape.parts.push_back(std::move(part));
    }
    if (shape.parts.empty()) return;
    if (problem_of(shape, level_.map.tile_size()))
      return fail("have more than 64 parts, or more than 1024 points, in one cell");
    if (shape.parts.size() == 1) shape = TileShape(shape.parts.front());
    std::vector<double> key;
    for (const TileShape& part : shape.parts) add_key(part, key);
    add_key(shape, key);
    const auto [known, is_new] = known_.try_emplace(std::move(key), shapes_.size());
    if (is_new) shapes_.push_back(std::move(shape));
    numbers_[cell] = known->second;
  }

  static void add_key(const TileShape& shape, std::vector<double>& key) {
    key.push_back(static_cast<double>(shape.points.size()));
    for (const Vec2 point : shape.points) key.insert(key.end(), {point.x, point.y});
    for (const auto& [from, to] : shape.lines) key.insert(key.end(), {from.x, from.y, to.x, to.y});
  }

  const Level& level_;
  ObjectCells cells_;
  std::vector<LevelCurve> curves_;
  std::vector<TileShape> shapes_;                     // each once
  std::map<std::vector<double>, std::size_t> known_;  // index of a shape, by its points
  std::map<std::size_t, std::size_t> numbers_;        // index of the shape, by cell
  std::string problem_;
};

void add_tiles(const std::vector<TileShape>& shapes, bool keep_picture, Level& level) {
  const Sheet& sheet = level.sheet(SheetId::tiles);
  const int first = level.tile_count(), count = first + static_cast<int>(shapes.size());
  const auto picture = keep_picture ? sheet.picture : nullptr;
  const int columns = std::max(sheet.columns, (count + kMaxSheetSide - 1) / kMaxSheetSide);
  const bool is_as_wide = columns == sheet.columns;
  level.set_tile_layout({columns, count});
  std::copy(shapes.begin(), shapes.end(), level.tile_shapes.begin() + first);
  if (picture == nullptr || !is_as_wide) return;
  SheetPicture larger = *picture;
  larger.height = sheet.layout().rows() * level.map.tile_size().height;
  larger.rgba.resize(static_cast<std::size_t>(4) * static_cast<std::size_t>(larger.width) *
                     static_cast<std::size_t>(larger.height));
  level.sheet(SheetId::tiles).picture = std::make_shared<const SheetPicture>(std::move(larger));
}

}  // namespace

bool has_object_ground(const Level& level) {
  return std::any_of(level.objects.begin(), level.objects.end(),
                     [](const ObjectLayer& layer) { return layer.is_ground && !layer.objects.empty(); });
}

Level with_object_tiles(const Level& level, bool keep_picture, std::optional<std::string>* problem) {
  ObjectGround ground(level);
  Level all = level;
  all.objects.clear();
  if (auto found = ground.problem()) {
    if (problem != nullptr) *problem = std::move(found);
    for (TileLayer& layer : all.layers.list) layer.is_ground = false;
    return all;
  }
  for (LevelCurve& curve : ground.take_curves()) all.curves.push_back(std::move(curve));
  add_tiles(ground.shapes(), keep_picture, all);
  TileLayer layer;
  layer.visible = false;
  TileMap map = ground.map();
  layer.cells = std::make_shared<const MapCells>(std::move(map.cells()));
  all.layers.list.push_back(std::move(layer));
  return all;
}

}  // namespace talus
