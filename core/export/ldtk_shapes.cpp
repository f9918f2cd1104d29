#include "ldtk_shapes.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "../formats/text/append_number.h"

namespace talus {
namespace {

const char* color_of(const TileShape& shape) {
  if (shape.kind == TileShape::Kind::solid) return shape.one_way ? "#41A6F6" : "#94B0C2";
  if (shape.side == TileShape::Side::ceiling) return "#B13E53";
  return shape.one_way ? "#3B5DC9" : "#38B764";
}

// "slope_0_to_8", "one_way_ceiling_slope_8_to_2p5_over_3_tiles".
std::string shape_name(const TileShape& shape, int tile) {
  const bool is_ceiling = shape.side == TileShape::Side::ceiling;
  std::string name = std::string(shape.one_way ? "one_way_" : "") + (is_ceiling ? "ceiling_" : "");
  if (shape.kind == TileShape::Kind::profile) return name + "profile_of_tile_" + std::to_string(tile);
  if (has_parts(shape))
    return (shape.one_way ? "one_way_" : "") +
           std::string(shape.kind == TileShape::Kind::polygon ? "polygon" : "group") + "_of_tile_" +
           std::to_string(tile);
  name += "slope_";
  append_number(name, shape.heights[0]);
  append_number(name += "_to_", shape.heights[1]);
  if (shape.tiles > 1) name += "_over_" + std::to_string(shape.tiles) + "_tiles";
  std::replace(name.begin(), name.end(), '.', 'p');
  return ldtk_identifier(name);
}

// The height of the line `x` px to the right of its left end.
double height_at(const TileShape& shape, double x, TileSize tile) {
  const auto last = static_cast<double>(shape.heights.size() - 1);
  const double at = x / (shape.tiles * tile.width) * last;
  const double from = std::min(std::floor(at), last - 1);
  const double a = shape.heights[static_cast<std::size_t>(from)],
               b = shape.heights[static_cast<std::size_t>(from) + 1];
  return a + (b - a) * (at - from);
}

// The smallest and the largest height over a column of cells.
std::pair<double, double> range_of(const TileShape& shape, int column, TileSize tile) {
  const double left = column * tile.width, right = left + tile.width;
  auto [least, greatest] = std::minmax({height_at(shape, left, tile), height_at(shape, right, tile)});
  const auto last = static_cast<double>(shape.heights.size() - 1);
  for (std::size_t i = 0; i < shape.heights.size(); ++i) {
    const double x = shape.tiles * tile.width * (static_cast<double>(i) / last);
    if (x <= left || x >= right) continue;
    least = std::min(least, shape.heights[i]);
    greatest = std::max(greatest, shape.heights[i]);
  }
  return {least, greatest};
}

std::string part_name(const std::string& name, int column, int row) {
  std::string part = name + "_part_" + std::to_string(column + 1);
  if (row > 0) part += "_row_" + std::to_string(row + 1);
  return part;
}

}  // namespace

std::string ldtk_identifier(const std::string& name, const char* thing) {
  const bool is_digit_first = !name.empty() && name[0] >= '0' && name[0] <= '9';
  std::string id = name.empty() ? thing : is_digit_first ? std::string(thing) + "_" + name : name;
  std::replace_if(
      id.begin(), id.end(), [](unsigned char c) { return c > 127 || (std::isalnum(c) == 0 && c != '_'); },
      '_');
  return id;
}

LdtkShapes::LdtkShapes(const TerrainSource& ground) : tile_(ground.tile), index_(ground.shapes.size(), -1) {
  define({.kind = TileShape::Kind::solid}, "solid");
  define({.kind = TileShape::Kind::solid, .one_way = true}, "one_way");
  for (std::size_t tile = 0; tile < ground.shapes.size(); ++tile) {
    TileShape shape = ground.shapes[tile];
    if (shape.kind == TileShape::Kind::none) continue;
    if (shape.kind == TileShape::Kind::solid) shape = {.kind = shape.kind, .one_way = shape.one_way};
    auto known =
        std::find_if(shapes_.begin(), shapes_.end(), [&](const Shape& s) { return s.shape == shape; });
    if (known == shapes_.end()) {
      define(shape, shape_name(shape, static_cast<int>(tile)));
      known = shapes_.end() - 1;
    }
    index_[tile] = static_cast<int>(known - shapes_.begin());
  }
}

void LdtkShapes::define(const TileShape& shape, const std::string& name) {
  const auto add_value = [&](const std::string& of) {
    values_.push_back({of, color_of(shape)});
    return static_cast<std::uint16_t>(values_.size());
  };
  Shape defined{shape, add_value(name), {}};
  for (int column = 0; has_heights(shape) && column < shape.tiles; ++column) {
    const auto [least, greatest] = range_of(shape, column, tile_);
    for (int row = column == 0 ? 1 : 0; row * tile_.height < greatest; ++row) {
      const bool is_over_line = shape.one_way && least >= (row + 1) * tile_.height;
      if (!is_over_line) defined.parts.push_back({column, row, add_value(part_name(name, column, row))});
    }
  }
  shapes_.push_back(std::move(defined));
}

LdtkShapes::Grid LdtkShapes::grid_of(const TerrainSource& ground, const Progress& progress) const {
  Grid grid;
  grid.cells.reserve(ground.cells.size());
  for (const TileNumber tile : ground.cells)
    grid.cells.push_back(index_[tile] < 0 ? std::uint16_t{0} : of_tile(tile).value);
  const auto at = [&](Cell c) {
    return static_cast<std::size_t>(c.y) * static_cast<std::size_t>(ground.width) +
           static_cast<std::size_t>(c.x);
  };
  for (Cell c; c.y < ground.height && progress.at(c.y, ground.height); ++c.y) {
    for (c.x = 0; c.x < ground.width; ++c.x) {
      const TileNumber tile = ground.cells[at(c)];
      if (index_[tile] < 0) continue;
      const Shape& shape = of_tile(tile);
      const int up = shape.shape.side == TileShape::Side::floor ? -1 : 1;
      for (const Part& part : shape.parts) {
        const Cell reached{c.x + part.column, c.y + up * part.row};
        if (reached.x >= ground.width || reached.y < 0 || reached.y >= ground.height) continue;
        std::uint16_t& value = grid.cells[at(reached)];
        if (value == 0)
          value = part.value;
        else if (value != shapes_.front().value)  // nothing shows through a full tile
          ++grid.overlaps;
      }
    }
  }
  return grid;
}

}  // namespace talus
