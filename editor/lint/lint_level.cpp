// What is wrong with roles, shapes, curves and the bodies placed by hand.
#include <algorithm>
#include <array>
#include <cmath>

#include <talus/level/ground.h>
#include "collision/ground_queries.h"
#include "level/curve_span.h"
#include "level/level_text.h"
#include "level/local_ground.h"
#include "lint_parts.h"

namespace talus {
namespace {

constexpr double kFastest = 4096;  // px/frame: what the solvers limit speeds to after a step

class LevelLinter {
 public:
  LevelLinter(const Level& level, const LintTiles& tiles, std::vector<Problem>& out)
      : level_(level), tiles_(tiles), out_(out) {}

  void run(bool has_balls) {
    check_roles();
    check_shapes();
    check_curves();
    check_article();
    if (const auto problem = ground_problem(level_))
      add(Severity::error, "too-much-ground", "the level " + *problem);
    for (int i = 0; i < static_cast<int>(level_.spawns.size()); ++i) check_spawn(i);
    if (!has_balls && level_.spawns.empty()) {
      add(Severity::warning, "no-balls",
          "no ball is on the map and none is placed by hand, so nothing will move");
    }
  }

 private:
  void add(Severity severity, const char* code, const std::string& message, std::optional<Cell> cell = {},
           int tile = -1, int object = -1) {
    out_.push_back({severity, code, message, cell, tile, object});
  }

  void check_roles() {
    const auto& infos = flag_role_infos();
    for (std::size_t i = 0; i < infos.size(); ++i) {
      for (std::size_t j = i + 1; j < infos.size(); ++j) {
        const int flag = level_.roles.*infos[i].flag;
        if (flag == FlagRoles::kUnused || flag != level_.roles.*infos[j].flag) continue;
        add(Severity::error, "shared-flag",
            "flag " + std::to_string(flag) + " stands for both " + std::string(infos[i].label) + " and " +
                std::string(infos[j].label),
            {}, -1, static_cast<int>(j));
      }
    }
  }

  void check_shapes() {
    for (int flag = 0; flag < kFlagCount; ++flag) {
      if (const auto problem = problem_of(level_.flag_shapes[static_cast<std::size_t>(flag)]))
        add(Severity::error, "bad-shape", "the shape of flag " + std::to_string(flag) + " " + *problem, {},
            -1, flag);
    }
    for (int tile = 0; tile < kTileCount; ++tile) {
      if (const auto problem = problem_of(level_.tile_shapes[static_cast<std::size_t>(tile)]))
        add(Severity::error, "bad-shape", "the shape of tile " + std::to_string(tile) + " " + *problem, {},
            tile);
    }
  }

  void check_curves() {
    for (std::size_t i = 0; i < level_.curves.size(); ++i) {
      const LevelCurve& curve = level_.curves[i];
      const std::string name = curve.name.empty() ? std::to_string(i) : "\"" + curve.name + "\"";
      const int number = static_cast<int>(i);
      const std::optional<Cell> cell = nearest_cell(span_of(curve.curve).from);
      if (const auto problem = problem_of(curve.curve, level_.map))
        add(Severity::error, "bad-curve", "curve " + name + " " + *problem, cell, -1, number);
      else if (leaves_map(curve.curve))
        add(Severity::warning, "curve-leaves-map", "curve " + name + " leaves the map between its ends", cell,
            -1, number);
    }
    if (level_.curves.empty() || level_.tuning.solver == SolverKind::exact) return;
    add(Severity::warning, "curves-need-exact",
        "curves and segments stop only bodies of the exact solver, but the level's solver is " +
            std::string(solver_name(level_.tuning.solver)));
  }

  // The article has full tiles and floors alone; the tiles of the map that it lets everything through.
  void check_article() {
    if (level_.tuning.solver != SolverKind::article) return;
    std::array<bool, kTileCount> used{};
    for (const std::uint8_t tile : level_.map.cells()) used[tile] = true;
    std::string tiles;
    int count = 0, first = -1;
    for (int tile = 0; tile < kTileCount; ++tile) {
      const TileShape shape = shape_of_tile(level_, static_cast<std::uint8_t>(tile));
      const bool has_role =
          level_.tile_shapes[static_cast<std::size_t>(tile)].kind == TileShape::Kind::none &&
          role_of(level_.tile_flags(static_cast<std::uint8_t>(tile)), level_.roles) != TileRole::none;
      const bool is_line = shape.kind == TileShape::Kind::slope || shape.kind == TileShape::Kind::profile;
      const bool is_unknown = shape.one_way || shape.kind == TileShape::Kind::profile ||
                              (is_line && shape.side == TileShape::Side::ceiling);
      if (!used[static_cast<std::size_t>(tile)] || shape.kind == TileShape::Kind::none || has_role ||
          !is_unknown)
        continue;
      if (count == 0) first = tile;
      if (++count <= 3) tiles += (count > 1 ? ", " : "") + std::to_string(tile);
    }
    if (count == 0) return;
    if (count > 3) tiles += " and " + std::to_string(count - 3) + " more";
    add(Severity::warning, "ground-not-in-article",
        "bodies pass through tile" + std::string(count == 1 ? " " : "s ") + tiles +
            ": the article's solver does not know one-way ground, ceilings and profiles; bump and exact do",
        {}, first);
  }

  // Whether a curve with its ends on the map goes above or below it. Its pieces rise or fall throughout.
  bool leaves_map(const Curve& curve) const {
    const auto is_off_map = [&](double y) {
      return y < -kCurveEndSlack || y > level_.map.height() * kTileSize + kCurveEndSlack;
    };
    const std::vector<Piece<double>> pieces = cut_curves({&curve, 1}).pieces;
    return std::any_of(pieces.begin(), pieces.end(), [&](const Piece<double>& piece) {
      return is_off_map(piece.y0) || is_off_map(piece.y1);
    });
  }

  // The cell of the map where a place is, or that is nearest to it; nothing if the map has no cells, or the
  // place is no number.
  std::optional<Cell> nearest_cell(Vec2 at) const {
    const int width = level_.map.width(), height = level_.map.height();
    if (width == 0 || height == 0 || std::isnan(at.x) || std::isnan(at.y)) return std::nullopt;
    const auto clamped = [](double px, int cells) {  // far away it may be no int
      return static_cast<int>(std::clamp(std::floor(px / kTileSize), 0.0, cells - 1.0));
    };
    return Cell{clamped(at.x, width), clamped(at.y, height)};
  }

  void check_spawn(int index) {
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    const Vec2 corner = spawn.position, size = spawn.size;
    const std::string subject =
        spawn_name(level_, index) + " at " + px_text(corner.x) + ", " + px_text(corner.y) + " px";
    const double width = level_.map.width() * kTileSize, height = level_.map.height() * kTileSize;
    const bool inside =
        corner.x >= 0 && corner.y >= 0 && corner.x + size.x <= width && corner.y + size.y <= height;
    // Farther away there are no tiles, and perhaps no int for the cell either.
    const bool touches = corner.x > -size.x && corner.y > -size.y && corner.x < width && corner.y < height;
    const std::optional<Cell> cell = nearest_cell(corner);
    if (!inside)
      add(Severity::warning, "spawn-outside", subject + " is not wholly on the map", cell, -1, index);
    const double speed = std::max(std::abs(spawn.velocity.x), std::abs(spawn.velocity.y));
    if (speed > kFastest)
      add(Severity::warning, "spawn-too-fast",
          subject + " starts with " + px_text(speed) + " px/frame; after the first step speeds are cut to " +
              px_text(kFastest) + " px/frame",
          cell, -1, index);
    if (touches && !check_solids(index, subject, cell) && !check_slopes(index, subject, cell))
      check_shapes_at(index, subject, cell);
  }

  // Calls visit(cell) for the cells of the map from the one at `first` px to the one before `end` px, until
  // it returns true; whether it did.
  template <class Visit>
  bool any_cell(Vec2 first, Vec2 end, Visit visit) const {
    const int x1 = std::min(level_.map.width(), static_cast<int>(std::ceil(end.x / kTileSize)));
    const int y1 = std::min(level_.map.height(), static_cast<int>(std::ceil(end.y / kTileSize)));
    for (int y = std::max(0, cell_of(first.y)); y < y1; ++y) {
      for (int x = std::max(0, cell_of(first.x)); x < x1; ++x) {
        if (visit(Cell{x, y})) return true;
      }
    }
    return false;
  }

  // Reports the first solid tile that the body overlaps; false when there is none.
  bool check_solids(int index, const std::string& subject, std::optional<Cell> cell) {
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    return any_cell(spawn.position, spawn.position + spawn.size, [&](Cell at) {
      if (!tiles_[level_.map.at(at)].solid) return false;
      add(Severity::error, "spawn-in-solid", subject + " starts inside the solid tile at " + cell_text(at),
          cell, -1, index);
      return true;
    });
  }

  // The same of the first slope below whose floor, as the article computes it, it would start.
  bool check_slopes(int index, const std::string& subject, std::optional<Cell> cell) {
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    const Vec2 reach = {level_.tuning.shared.slope_width, level_.tuning.shared.slope_height};
    return any_cell(spawn.position - reach, spawn.position + spawn.size, [&](Cell at) {
      const std::uint8_t tile = level_.map.at(at);
      if (!tiles_.is_slope(tile) || tiles_[tile].own_shape) return false;
      const double depth = depth_in_slope(level_, spawn.position, spawn.size, at);
      if (!(depth > 0)) return false;
      add(Severity::error, "spawn-in-slope",
          subject + " starts " + px_text(depth) + " px inside the " + role_label(tiles_[tile].role) + " at " +
              cell_text(at),
          cell, -1, index);
      return true;
    });
  }

  // The same of slopes and profiles that flags and roles do not tell, where the level's solver has them.
  void check_shapes_at(int index, const std::string& subject, std::optional<Cell> cell) {
    if (level_.tuning.solver != SolverKind::exact) return;
    const Spawn& spawn = level_.spawns[static_cast<std::size_t>(index)];
    const Vec2 reach = {kMaxShapeTiles * kTileSize, kMaxShapeTiles * kTileSize};
    const Vec2 end = spawn.position + spawn.size;
    const bool is_covered = any_cell(spawn.position - reach, end + reach, [&](Cell at) {
      const LintTiles::Tile& tile = tiles_[level_.map.at(at)];
      if (!tile.line || (tiles_.is_slope(level_.map.at(at)) && !tile.own_shape)) return false;
      return any_cell(spawn.position, end, [&](Cell c) {
        return c.x >= at.x + tile.covered[0].x && c.x <= at.x + tile.covered[1].x &&
               c.y >= at.y + tile.covered[0].y && c.y <= at.y + tile.covered[1].y;
      });
    });
    if (!is_covered) return;
    const Rect box{spawn.position.x, spawn.position.y, spawn.size.x, spawn.size.y};
    const LocalGround ground = ground_around(level_, box, 0);
    if (!overlaps_ground(ground.terrain, ground.to_local(box), spawn.used_foot())) return;
    const auto out = way_out(ground.terrain, ground.to_local(box), spawn.used_foot());
    add(Severity::error, "spawn-in-slope",
        subject + " starts " + (out ? px_text(std::abs(out->x) + std::abs(out->y)) + " px " : "") +
            "inside the shape of a tile",
        cell, -1, index);
  }

  const Level& level_;
  const LintTiles& tiles_;
  std::vector<Problem>& out_;
};

}  // namespace

void lint_level(const Level& level, const LintTiles& tiles, bool has_balls, std::vector<Problem>& out) {
  LevelLinter(level, tiles, out).run(has_balls);
}

}  // namespace talus
