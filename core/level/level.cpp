#include <talus/level/level.h>

#include <algorithm>
#include <cmath>

#include <talus/level/tile_turns.h>
#include "curve_span.h"

namespace talus {
namespace {

TileShape article_slope(const SharedTuning& tuning, TileSize tile, bool rises) {
  TileShape shape;
  shape.kind = TileShape::Kind::slope;
  shape.tiles =
      static_cast<int>(std::clamp(std::ceil(tuning.slope_width / tile.width), 1.0, 1.0 * kMaxShapeTiles));
  const double high = tile.height, low = std::max(0.0, high - tuning.slope_height);
  shape.heights = {low, high};
  if (!rises) std::swap(shape.heights[0], shape.heights[1]);
  return shape;
}

TileShape shape_before_modifiers(const Level& level, FlagSet flags) {
  switch (role_of(flags, level.roles)) {
    case TileRole::solid:
      return {.kind = TileShape::Kind::solid};
    case TileRole::up_slope:
      return article_slope(level.tuning.shared, level.map.tile_size(), true);
    case TileRole::down_slope:
      return article_slope(level.tuning.shared, level.map.tile_size(), false);
    case TileRole::ball:
      return {};
    case TileRole::none:
      break;
  }
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    const TileShape& shape = level.flag_shapes[flag];
    if (has_flag(flags, flag) && shape.kind != TileShape::Kind::none) return shape;
  }
  return {};
}

bool same_layers(const Level& a, const Level& b) {
  if (a.layers.chosen == b.layers.chosen) return a.layers == b.layers && a.map == b.map;
  if (a.layers.count() != b.layers.count()) return false;
  Level other = a;
  other.choose_layer(b.layers.chosen);
  return other.layers == b.layers && other.map == b.map;
}

}  // namespace

bool operator==(const Level& a, const Level& b) {
  const bool same_cart = a.cart == b.cart || (a.cart && b.cart && *a.cart == *b.cart);
  return same_cart && a.sheets == b.sheets && a.palette == b.palette && a.background == b.background &&
         a.flag_names == b.flag_names && a.flag_fields == b.flag_fields && a.roles == b.roles &&
         a.tile_shapes == b.tile_shapes && a.flag_shapes == b.flag_shapes && a.tilesets == b.tilesets &&
         a.animations == b.animations && a.tile_notes == b.tile_notes && a.large_tiles == b.large_tiles &&
         same_layers(a, b) && a.curves == b.curves && a.objects == b.objects && a.tuning == b.tuning &&
         a.spawns == b.spawns && a.brushes == b.brushes && a.auto_tiles == b.auto_tiles &&
         a.exports == b.exports && a.extra == b.extra;
}

Rgba background_of(const Level& level) {
  const auto [r, g, b] = level.palette[0];
  return level.background.value_or(Rgba{r, g, b, 255});
}

void Level::set_tile_layout(const SheetLayout& layout) {
  const auto count = static_cast<std::size_t>(layout.count);
  Sheet& tiles = sheet(SheetId::tiles);
  if (layout != tiles.layout()) tiles.picture = nullptr;
  if (layout.columns != tiles.columns) tilesets.clear();
  tiles.columns = layout.columns;
  tiles.images.resize(count);
  tiles.flags.resize(count);
  tile_shapes.resize(count);
  if (problem_of(tilesets, layout)) tilesets.clear();
  std::erase_if(large_tiles, [&](const auto& tile) { return tile.first >= layout.count; });
  std::erase_if(animations, [&](const auto& animation) {
    return problem_of(TileAnimations{animation}, layout.count).has_value();
  });
  std::erase_if(tile_notes, [&](const auto& note) { return note.first >= layout.count; });
}

const MapCells& Level::cells_of(int layer) const {
  const auto& cells = layers.list[static_cast<std::size_t>(layer)].cells;
  return cells != nullptr ? *cells : map.cells();
}

void Level::choose_layer(int layer) {
  if (layer == layers.chosen) return;
  TileLayer& next = layers.list[static_cast<std::size_t>(layer)];
  MapCells cells = *next.cells;
  std::swap(cells, map.cells());
  layers.list[static_cast<std::size_t>(layers.chosen)].cells =
      std::make_shared<const MapCells>(std::move(cells));
  next.cells = nullptr;
  layers.chosen = layer;
}

TileShape shape_of_tile(const Level& level, TileNumber tile) {
  const TileShape& own = level.tile_shapes[tile];
  return own.kind != TileShape::Kind::none ? own : shape_of_flags(level, level.tile_flags(tile));
}

TileShape shape_of_cell(const Level& level, MapCell cell) {
  TileShape shape = shape_of_tile(level, cell.tile);
  if (cell.turn == TileTurn::none || problem_of(shape, level.map.tile_size())) return shape;
  return turned(shape, cell.turn, level.map.tile_size());
}

TileShape shape_of_flags(const Level& level, FlagSet flags) {
  TileShape shape = shape_before_modifiers(level, flags);
  if (shape.kind == TileShape::Kind::none) return shape;
  using Side = TileShape::Side;
  const auto modify = [&](TileShape& part) {
    if (has_flag(flags, level.roles.one_way)) part.one_way = true;
    if (has_flag(flags, level.roles.ceiling))
      part.side = part.side == Side::floor ? Side::ceiling : Side::floor;
  };
  modify(shape);
  std::for_each(shape.parts.begin(), shape.parts.end(), modify);
  return shape;
}

FlagSet used_flags(const Level& level) {
  FlagSet used = 0;
  for (const Sheet& sheet : level.sheets)
    for (const FlagSet flags : sheet.flags) used |= flags;
  for (const FlagField& field : level.flag_fields)
    if (!problem_of(field)) used |= field.mask();
  for (int flag = 0; flag < kMaxFlags; ++flag) {
    const auto& infos = flag_role_infos();
    const bool has_role = std::any_of(
        infos.begin(), infos.end(), [&](const FlagRoleInfo& role) { return level.roles.*role.flag == flag; });
    const auto at = static_cast<std::size_t>(flag);
    if (has_role || !level.flag_names[at].empty() || level.flag_shapes[at].kind != TileShape::Kind::none)
      used |= flag_bit(flag);
  }
  return used;
}

std::optional<BodyKind> body_kind_of_tile(const Level& level, TileNumber tile) {
  if (level.tile_shapes[tile].kind != TileShape::Kind::none) return std::nullopt;
  return body_kind_of(role_of(level.tile_flags(tile), level.roles));
}

bool is_ball_tile(const Level& level, TileNumber tile) { return body_kind_of_tile(level, tile).has_value(); }

std::optional<std::string> problem_of(const Curve& curve, const TileMap& map) {
  if (auto problem = problem_of(curve)) return problem;
  const auto is_on_map = [&](Vec2 p) {
    return p.x >= -kCurveEndSlack && p.y >= -kCurveEndSlack && p.x <= map.px_width() + kCurveEndSlack &&
           p.y <= map.px_height() + kCurveEndSlack;
  };
  const CurveSpan ends = span_of(curve);
  if (!is_on_map(ends.from)) return "has its first end off the map";
  if (!is_on_map(ends.to)) return "has its last end off the map";
  return {};
}

}  // namespace talus
