#include <talus/sim/scene.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <talus/level/ground.h>
#include "../level/bump_boxes.h"
#include "../level/ground_cells.h"
#include "../level/object_ground.h"

namespace talus {
namespace {

// The boxes that one tile makes, relative to its cell.
struct TileBoxes {
  struct Part {
    TileRole role = TileRole::solid;
    Rect box;
    std::optional<GroundLine> line = {};
    BodyKind kind = BodyKind::ball;  // of a body
  };
  std::vector<Part> parts;
  void add(TileRole role, const Rect& box, std::optional<GroundLine> line = {},
           BodyKind kind = BodyKind::ball) {
    if (box.h > 0) parts.push_back({role, box, line, kind});
  }
};

TileRole role_of_line(double h0, double h1) {
  if (h0 == h1) return TileRole::solid;
  return h1 > h0 ? TileRole::up_slope : TileRole::down_slope;
}

std::optional<GroundLine> ground_line(const std::optional<BumpLine>& line) {
  if (!line) return {};
  return GroundLine{line->h1 > line->h0, std::min(line->h0, line->h1), line->is_ceiling, line->one_way};
}

TileRole role_of_box(const BumpBox& box) {
  return box.line ? role_of_line(box.line->h0, box.line->h1) : TileRole::solid;
}

// Of a polygon or a group. The article knows full boxes and floors.
TileBoxes boxes_of_parts(const TileShape& shape, TileSize size, SolverKind solver) {
  TileBoxes boxes;
  if (problem_of(shape, size)) return boxes;
  for (const BumpBox& box : bump_boxes(shape, size)) {
    const bool is_plain = !box.line || (!box.line->is_ceiling && !box.line->one_way);
    if (solver != SolverKind::bump && !is_plain) continue;
    boxes.add(role_of_box(box), box.box, is_plain ? std::nullopt : ground_line(box.line));
  }
  return boxes;
}

// A straight floor is a slope's box on a solid one. The article does not know other shapes.
TileBoxes boxes_of(const TileShape& shape, TileSize size, SolverKind solver) {
  if (shape.kind == TileShape::Kind::none) return {};
  if (has_parts(shape)) return boxes_of_parts(shape, size, solver);
  const bool is_known = !shape.one_way && shape.kind != TileShape::Kind::profile &&
                        (shape.kind == TileShape::Kind::solid || shape.side == TileShape::Side::floor);
  if (solver != SolverKind::bump && !is_known) return {};
  const bool is_straight_floor =
      shape.heights.size() == 2 && shape.side == TileShape::Side::floor && !shape.one_way;
  TileBoxes boxes;
  for (const BumpBox& box : bump_boxes(shape, size)) {
    boxes.add(role_of_box(box), box.box, is_straight_floor ? std::nullopt : ground_line(box.line));
  }
  return boxes;
}

TileBoxes boxes_of(const Level& level, MapCell cell) {
  const SolverKind solver = level.tuning.solver;
  const TileSize size = level.map.tile_size();
  const TileNumber tile = cell.tile;
  const TileShape shape = shape_of_cell(level, cell);
  const TileRole role = level.tile_shapes[tile].kind != TileShape::Kind::none
                            ? TileRole::none
                            : role_of(level.tile_flags(tile), level.roles);
  const bool is_plain = !shape.one_way && shape.side == TileShape::Side::floor;
  const std::optional<BodyKind> body = body_kind_of(role);
  const bool is_turned = (solver == SolverKind::bump && !is_plain) || cell.turn != TileTurn::none;
  if (role == TileRole::none || (is_turned && !body && !problem_of(shape, size)))
    return boxes_of(shape, size, solver);
  TileBoxes boxes;
  const SharedTuning& tuning = level.tuning.shared;
  const bool is_slope = role == TileRole::up_slope || role == TileRole::down_slope;
  const Rect whole{0, 0, 1.0 * size.width, 1.0 * size.height};
  if (body)
    boxes.add(TileRole::ball, whole, {}, *body);
  else
    boxes.add(role, is_slope ? Rect{0, 0, tuning.slope_width, tuning.slope_height} : whole);
  return boxes;
}

// Of all tiles that a number stands for.
TileBoxes boxes_of(const Level& level, std::span<const TileStack> stacks, TileNumber number) {
  TileBoxes all;
  for (const MapCell cell : tiles_of(number, stacks, level.tile_count())) {
    TileBoxes boxes = boxes_of(level, cell);
    std::move(boxes.parts.begin(), boxes.parts.end(), std::back_inserter(all.parts));
  }
  return all;
}

// By number, so that a map is compiled with one look-up a cell.
std::vector<TileBoxes> boxes_by_number(const Level& level, std::span<const TileStack> stacks) {
  std::vector<TileBoxes> boxes(static_cast<std::size_t>(level.tile_count()) + stacks.size());
  for (std::size_t number = 0; number < boxes.size(); ++number)
    boxes[number] = boxes_of(level, stacks, static_cast<TileNumber>(number));
  return boxes;
}

SceneItem item_at(const TileMap& map, Cell cell, const TileBoxes::Part& part) {
  SceneItem item{.role = part.role, .box = part.box, .cell = cell, .velocity = {}, .spawn = -1};
  item.box.x += map.x_of(cell.x);
  item.box.y += map.y_of(cell.y);
  item.line = part.line;
  item.kind = part.kind;
  item.foot = traits_of(part.kind).foot;
  return item;
}

// The ball alone, for a solver that has the ground in another form.
TileBoxes body_of(const TileBoxes& tile) {
  TileBoxes body;
  for (const TileBoxes::Part& part : tile.parts) {
    if (part.role == TileRole::ball) body.add(part.role, part.box, {}, part.kind);
  }
  return body;
}

void note_bodies(Scene& scene) {
  const auto is_player = [](const SceneItem& item) { return traits_of(item.kind).takes_keys; };
  const auto bodies = std::count_if(scene.items.begin(), scene.items.end(),
                                    [](const SceneItem& i) { return i.role == TileRole::ball; });
  scene.features.players = std::any_of(scene.items.begin(), scene.items.end(), is_player);
  scene.features.meets =
      scene.tuning.solver == SolverKind::exact && scene.tuning.shared.pairs() == BodyPairs::meet &&
      std::any_of(scene.items.begin(), scene.items.end(),
                  [&](const SceneItem& item) { return item.role == TileRole::ball && !is_player(item); });
  scene.features.pairs = scene.tuning.shared.pairs() != BodyPairs::pass && bodies > 1;
}

void compile_ground(const Level& level, const GroundCells& ground,
                    const std::function<bool(double)>& progress, Scene& scene) {
  TerrainSource source = ground_of(level, ground);
  source.progress = progress;
  scene.ground_lines = ground_lines(level, ground);
  if (scene.ground_lines > kMaxGroundLines) source.shapes.assign(source.shapes.size(), {});
  if (level.tuning.exact.single_precision != 0 && level.tuning.shared.pairs() != BodyPairs::meet) {
    scene.single_ground = std::make_shared<const BasicTerrain<float>>(source);
  } else {
    scene.ground = std::make_shared<const Terrain>(source);
  }
  for (const LevelCurve& curve : level.curves) {  // as ground_of leaves some out
    if (!problem_of(curve.curve, level.map)) scene.curve_names.push_back(curve.name);
  }
}

// A cell of an edited level, and the number of what its ground has there.
struct NumberedCell {
  Cell cell;
  TileNumber number;
};

// The cells in map order, each once; nothing if one has a stack of tiles that the scene does not know.
std::optional<std::vector<NumberedCell>> numbered(const Scene& scene, const Level& edited,
                                                  std::span<const Cell> changed) {
  std::vector<NumberedCell> cells;
  for (const Cell cell : changed) {
    const auto number = ground_number(edited, scene.stacks, cell);
    if (!number) return std::nullopt;
    cells.push_back({cell, *number});
  }
  const auto key = [](const NumberedCell& c) { return std::pair(c.cell.x, c.cell.y); };
  std::sort(cells.begin(), cells.end(), [&](const auto& a, const auto& b) { return key(a) < key(b); });
  const auto same = [](const NumberedCell& a, const NumberedCell& b) { return a.cell == b.cell; };
  cells.erase(std::unique(cells.begin(), cells.end(), same), cells.end());
  return cells;
}

template <class Ground>
std::shared_ptr<const Ground> with_cells(const Ground& ground, std::span<const NumberedCell> changed) {
  auto next = std::make_shared<Ground>(ground);
  for (const NumberedCell& c : changed) next->set_cell(c.cell, c.number);
  return next;
}

// Scene::ground_lines of an edited level, which differs from the scene's in these cells, each there once.
std::size_t lines_after(const Scene& scene, const Level& edited, std::span<const NumberedCell> changed) {
  std::size_t lines = scene.ground_lines;
  const auto lines_of = [&](TileNumber number) {
    return ground_lines(shape_of_number(edited, scene.stacks, number), edited.map.tile_size());
  };
  for (const NumberedCell& c : changed) {
    lines += lines_of(c.number);
    lines -= lines_of(scene.ground ? scene.ground->tile_at(c.cell) : scene.single_ground->tile_at(c.cell));
  }
  return lines;
}

void add_spawns(const Level& level, std::vector<SceneItem>& items) {
  for (std::size_t i = 0; i < level.spawns.size(); ++i) {
    const Spawn& spawn = level.spawns[i];
    items.push_back({.role = TileRole::ball,
                     .box = {spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y},
                     .cell = {},
                     .velocity = spawn.velocity,
                     .spawn = static_cast<int>(i),
                     .kind = spawn.kind,
                     .foot = spawn.used_foot()});
  }
}

Scene make_scene(const Level& level, const std::function<bool(double)>& progress) {
  if (has_object_ground(level)) return make_scene(with_object_tiles(level), progress);
  const GroundCells ground = ground_cells(level);
  if (ground.overflow > 0) return make_scene(without_tiles(level), progress);
  std::vector<TileBoxes> boxes = boxes_by_number(level, ground.stacks);
  if (level.tuning.solver == SolverKind::exact || ground_problem(level, ground)) {
    for (TileBoxes& tile : boxes) tile = body_of(tile);
  }
  const TileMap& map = level.map;
  const auto at = [&](Cell cell) { return static_cast<std::size_t>(cell.y) * map.width() + cell.x; };

  // A counting sort by column: the map is read row by row, as it lies in memory, and comes out in map order.
  std::vector<std::size_t> next(static_cast<std::size_t>(map.width()) + 1, 0);
  for (Cell cell{0, 0}; cell.y < map.height(); ++cell.y) {
    for (cell.x = 0; cell.x < map.width(); ++cell.x) {
      next[cell.x + 1] += boxes[ground.cells[at(cell)]].parts.size();
    }
  }
  for (std::size_t column = 1; column < next.size(); ++column) next[column] += next[column - 1];

  Scene scene;
  scene.stacks = ground.stacks;
  scene.tuning = level.tuning;
  scene.tile_size = map.tile_size();
  if (level.tuning.solver == SolverKind::exact) compile_ground(level, ground, progress, scene);
  scene.items.resize(next.back());
  for (Cell cell{0, 0}; cell.y < map.height(); ++cell.y) {
    for (cell.x = 0; cell.x < map.width(); ++cell.x) {
      for (const TileBoxes::Part& part : boxes[ground.cells[at(cell)]].parts)
        scene.items[next[cell.x]++] = item_at(map, cell, part);
    }
  }

  add_spawns(level, scene.items);
  note_bodies(scene);
  return scene;
}

}  // namespace

Scene compile_scene(const Level& level) { return make_scene(level, {}); }

std::optional<Scene> compile_scene(const Level& level, const std::function<bool(double)>& progress) {
  bool goes_on = true;
  const auto ask = [&](double done) { return goes_on = goes_on && progress(done); };
  Scene scene = make_scene(level, ask);
  if (!goes_on) return std::nullopt;
  return scene;
}

bool is_same_ground(const Tuning& a, const Tuning& b) {
  return a.solver == b.solver && a.exact.single_precision == b.exact.single_precision &&
         a.shared.slope_width == b.shared.slope_width && a.shared.slope_height == b.shared.slope_height;
}

Scene recompile_scene(const Scene& scene, const Level& edited, std::span<const Cell> changed) {
  if (edited.tuning.solver != SolverKind::exact || !is_same_ground(scene.tuning, edited.tuning))
    return compile_scene(edited);
  if (has_object_ground(edited)) return recompile_scene(scene, with_object_tiles(edited), changed);
  const auto cells = numbered(scene, edited, changed);
  if (!cells) return compile_scene(edited);
  const std::size_t lines = lines_after(scene, edited, *cells);
  if (std::max(lines, scene.ground_lines) > kMaxGroundLines) return compile_scene(edited);

  Scene next = scene;
  next.tuning = edited.tuning;
  next.ground_lines = lines;
  if (scene.ground) next.ground = with_cells(*scene.ground, *cells);
  if (scene.single_ground) next.single_ground = with_cells(*scene.single_ground, *cells);

  const auto in_map_order = [](Cell a, Cell b) { return a.x != b.x ? a.x < b.x : a.y < b.y; };
  const auto is_changed = [&](Cell cell) {
    const auto found =
        std::lower_bound(cells->begin(), cells->end(), cell,
                         [&](const NumberedCell& c, Cell at) { return in_map_order(c.cell, at); });
    return found != cells->end() && found->cell == cell;
  };
  std::erase_if(next.items, [&](const SceneItem& item) { return item.spawn >= 0 || is_changed(item.cell); });
  std::vector<SceneItem> added;
  for (const NumberedCell& c : *cells) {
    const TileBoxes boxes = body_of(boxes_of(edited, scene.stacks, c.number));
    for (const TileBoxes::Part& part : boxes.parts) added.push_back(item_at(edited.map, c.cell, part));
  }
  const auto middle = next.items.insert(next.items.end(), added.begin(), added.end());
  std::inplace_merge(next.items.begin(), middle, next.items.end(),
                     [&](const SceneItem& a, const SceneItem& b) { return in_map_order(a.cell, b.cell); });
  add_spawns(edited, next.items);
  note_bodies(next);
  return next;
}

bool operator==(const Scene& a, const Scene& b) {
  const auto same = [](const auto& x, const auto& y) { return x == y || (x && y && *x == *y); };
  return a.items == b.items && a.tuning == b.tuning && a.features == b.features &&
         a.tile_size == b.tile_size && a.curve_names == b.curve_names && same(a.ground, b.ground) &&
         same(a.single_ground, b.single_ground);
}

}  // namespace talus
