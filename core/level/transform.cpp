#include "transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <talus/collision/shape_forms.h>

namespace talus {
namespace {

// x of the mirror image of a point.
struct Mirror {
  double width;  // px of the map
  Vec2 operator()(Vec2 p) const { return {width - p.x, p.y}; }

  Segment operator()(const Segment& s) const {
    if (s.from.x == s.to.x) return {(*this)(s.from), (*this)(s.to)};
    return {(*this)(s.to), (*this)(s.from)};
  }
  Arc operator()(const Arc& a) const {
    return {(*this)(a.center), a.radius, width - a.x1, width - a.x0, a.upper};
  }
  Parabola operator()(const Parabola& p) const { return {(*this)(p.to), (*this)(p.from), p.control_y}; }
  Cubic operator()(const Cubic& c) const {
    return {(*this)(c.to), (*this)(c.from), -c.to_slope, -c.from_slope};
  }
  Sine operator()(const Sine& s) const {
    return {width - s.x1, width - s.x0, s.middle, -s.amplitude, s.wavelength, width - s.origin};
  }
  Polyline operator()(const Polyline& p) const {
    return {width - p.x1, width - p.x0, {p.ys.rbegin(), p.ys.rend()}};
  }
};

struct Shift {
  Vec2 by;  // px
  Segment operator()(const Segment& s) const { return {s.from + by, s.to + by}; }
  Arc operator()(const Arc& a) const { return {a.center + by, a.radius, a.x0 + by.x, a.x1 + by.x, a.upper}; }
  Parabola operator()(const Parabola& p) const { return {p.from + by, p.to + by, p.control_y + by.y}; }
  Cubic operator()(const Cubic& c) const { return {c.from + by, c.to + by, c.from_slope, c.to_slope}; }
  Sine operator()(const Sine& s) const {
    return {s.x0 + by.x, s.x1 + by.x, s.middle + by.y, s.amplitude, s.wavelength, s.origin + by.x};
  }
  Polyline operator()(Polyline p) const {
    for (double& y : p.ys) y += by.y;
    return {p.x0 + by.x, p.x1 + by.x, std::move(p.ys)};
  }
};

struct Scale {
  double by;
  Segment operator()(const Segment& s) const { return {s.from * by, s.to * by}; }
  Arc operator()(const Arc& a) const { return {a.center * by, a.radius * by, a.x0 * by, a.x1 * by, a.upper}; }
  Parabola operator()(const Parabola& p) const { return {p.from * by, p.to * by, p.control_y * by}; }
  Cubic operator()(const Cubic& c) const { return {c.from * by, c.to * by, c.from_slope, c.to_slope}; }
  Sine operator()(const Sine& s) const {
    return {s.x0 * by, s.x1 * by, s.middle * by, s.amplitude * by, s.wavelength * by, s.origin * by};
  }
  Polyline operator()(Polyline p) const {
    for (double& y : p.ys) y *= by;
    return {p.x0 * by, p.x1 * by, std::move(p.ys)};
  }
};

template <class Change>
void change_form(Curve& curve, const Change& change) {
  curve.form = std::visit([&](const auto& form) { return decltype(Curve::form)(change(form)); }, curve.form);
}
template <class Change>
void change_curves(Level& level, const Change& change) {
  for (LevelCurve& curve : level.curves) change_form(curve.curve, change);
}

// The mirror image of a vertical segment faces the other way.
void turn_faces(Curve& curve) {
  const auto* segment = std::get_if<Segment>(&curve.form);
  if (segment == nullptr || segment->from.x != segment->to.x || curve.faces == Curve::Faces::both) return;
  curve.faces = curve.faces == Curve::Faces::up ? Curve::Faces::down : Curve::Faces::up;
}

bool is_physical(const Level& level, TileNumber tile) {
  return shape_of_tile(level, tile).kind != TileShape::Kind::none ||
         body_kind_of(role_of(level.tile_flags(tile), level.roles)).has_value();
}

// A slope belongs to the cell at its left end, whichever way it is turned.
// A turned tile has the mirror image of its turn, as the shape of the tile itself is mirrored.
MapCells mirrored_cells(const Level& level, const MapCells& cells) {
  TileMap image(level.map.width(), level.map.height());
  std::size_t i = 0;
  for (Cell cell{0, 0}; cell.y < image.height(); ++cell.y) {
    for (cell.x = 0; cell.x < image.width(); ++cell.x, ++i) {
      const MapCell from = cells[i];
      if (!is_physical(level, from.tile)) continue;
      const int tiles = has_heights(shape_of_cell(level, from)) ? shape_of_tile(level, from.tile).tiles : 1;
      const Cell to{image.width() - cell.x - tiles, cell.y};
      const bool is_diagonal = has_flip(from.turn, TileTurn::diagonal);
      const TileTurn turn = is_diagonal ? after_turn(from.turn, turn_of(false, true, true)) : from.turn;
      if (image.contains(to)) image.set(to, {from.tile, turn});
    }
  }
  return std::move(image.cells());
}

MapCells moved_cells(const TileMap& map, const MapCells& cells, int columns, int rows) {
  TileMap image(map.width() + columns, map.height() + rows);
  std::size_t i = 0;
  for (Cell cell{0, 0}; cell.y < map.height(); ++cell.y)
    for (cell.x = 0; cell.x < map.width(); ++cell.x, ++i)
      image.set({cell.x + columns, cell.y + rows}, cells[i]);
  return std::move(image.cells());
}

// Replaces the cells of each layer by change(cells), as many as a map of this size has.
template <class Change>
void change_layers(Level& level, int width, int height, const Change& change) {
  for (int layer = 0; layer < level.layers.count(); ++layer) {
    auto& cells = level.layers.list[static_cast<std::size_t>(layer)].cells;
    if (cells != nullptr) cells = std::make_shared<const MapCells>(change(*cells));
  }
  MapCells chosen = change(level.map.cells());
  level.map = TileMap(width, height, level.map.tile_size());
  level.map.cells() = std::move(chosen);
}

void scale_conveyor(double& speed, int factor) {
  speed = std::clamp(speed * factor, -kMaxConveyor, kMaxConveyor);
}

void scale_shape(TileShape& shape, int factor) {
  for (double& height : shape.heights) height *= factor;
  for (Vec2& point : shape.points) point = point * factor;
  for (TileShape& part : shape.parts) scale_shape(part, factor);
  scale_conveyor(shape.conveyor, factor);
}

template <class Change>
void change_objects(Level& level, const Change& change) {
  for (ObjectLayer& layer : level.objects) std::for_each(layer.objects.begin(), layer.objects.end(), change);
}

// Where its position is on its left, it is on its right then.
void mirror_object(MapObject& object, double width) {
  constexpr double kHalfTurn = 180;
  const double angle = object.rotation * std::numbers::pi / kHalfTurn;
  const double across = object.size.x * (1 - 2 * object.anchor.x);
  object.position = object.position + Vec2{std::cos(angle), std::sin(angle)} * across;
  if (object.form == MapObject::Form::tile) object.picture.mirrors_x = !object.picture.mirrors_x;
  object.position.x = width - object.position.x;
  object.rotation = -object.rotation;
  for (Vec2& point : object.points) point.x = -point.x;
}

void scale_object(MapObject& object, double factor) {
  object.position = object.position * factor;
  object.size = object.size * factor;
  for (Vec2& point : object.points) point = point * factor;
}

}  // namespace

Level mirrored(const Level& level) {
  Level image = level;
  const double width = level.map.px_width();
  change_layers(image, level.map.width(), level.map.height(),
                [&](const auto& cells) { return mirrored_cells(level, cells); });
  std::swap(image.roles.up_slope, image.roles.down_slope);
  const TileSize tile = level.map.tile_size();
  for (TileShape& shape : image.tile_shapes) shape = mirrored(shape, tile, ShapeMirror::left_right);
  for (TileShape& shape : image.flag_shapes) shape = mirrored(shape, tile, ShapeMirror::left_right);
  change_curves(image, Mirror{width});
  for (LevelCurve& curve : image.curves) {
    turn_faces(curve.curve);
    curve.curve.conveyor = 0 - curve.curve.conveyor;
  }
  change_objects(image, [width](MapObject& object) { mirror_object(object, width); });
  for (ObjectLayer& layer : image.objects) layer.offset.x = -layer.offset.x;
  for (LayerGroup& group : image.layers.groups) group.offset.x = -group.offset.x;
  for (Spawn& spawn : image.spawns) {
    spawn.position.x = width - spawn.position.x - spawn.size.x;
    spawn.velocity.x = -spawn.velocity.x;
  }
  image.tuning.shared.drift_speed = -level.tuning.shared.drift_speed;
  return image;
}

Level moved(const Level& level, int columns, int rows) {
  Level image = level;
  change_layers(image, level.map.width() + columns, level.map.height() + rows,
                [&](const auto& cells) { return moved_cells(level.map, cells, columns, rows); });
  const Vec2 by = level.map.corner_of({columns, rows});
  change_curves(image, Shift{by});
  change_objects(image, [by](MapObject& object) { object.position = object.position + by; });
  for (Spawn& spawn : image.spawns) spawn.position = spawn.position + by;
  return image;
}

Curve moved(const Curve& curve, Vec2 by) {
  Curve image = curve;
  change_form(image, Shift{by});
  return image;
}

Level scaled(const Level& level, int factor) {
  Level image = level;
  const auto [width, height] = level.map.tile_size();
  image.map = TileMap(level.map.width(), level.map.height(), {width * factor, height * factor});
  image.map.cells() = level.map.cells();
  const auto scale = [factor](TileShape& shape) { scale_shape(shape, factor); };
  std::for_each(image.tile_shapes.begin(), image.tile_shapes.end(), scale);
  std::for_each(image.flag_shapes.begin(), image.flag_shapes.end(), scale);
  change_curves(image, Scale{1.0 * factor});
  for (LevelCurve& curve : image.curves) scale_conveyor(curve.curve.conveyor, factor);
  change_objects(image, [factor](MapObject& object) { scale_object(object, factor); });
  for (ObjectLayer& layer : image.objects) layer.offset = layer.offset * factor;
  for (LayerGroup& group : image.layers.groups) group.offset = group.offset * factor;
  for (Spawn& spawn : image.spawns) {
    spawn.position = spawn.position * factor;
    spawn.velocity = spawn.velocity * factor;
    spawn.size = spawn.size * factor;
  }
  for (const TuningField& field : tuning_fields()) {
    if (field.unit.starts_with("px")) field.in(image.tuning) *= factor;
  }
  return image;
}

Curve scaled(const Curve& curve, int factor) {
  Curve image = curve;
  change_form(image, Scale{1.0 * factor});
  return image;
}

}  // namespace talus
