// The rules: what users of the article's convention get wrong. Only what is certainly wrong is an error.
#include "lint.h"

#include <algorithm>
#include <cmath>

#include "../collision/outline_compiler.h"

namespace talus {
namespace {

constexpr Vec2 kBallSize = {8, 8};  // px, of a ball tile's ball

std::string text_of(Cell cell) {
  return std::string("(")
      .append(std::to_string(cell.x))
      .append(", ")
      .append(std::to_string(cell.y))
      .append(")");
}

// A length or position in px, without the zeros of a whole number.
std::string text_of(double px) {
  std::string text = std::to_string(px);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

bool is_slope(TileRole role) { return role == TileRole::up_slope || role == TileRole::down_slope; }

std::string_view label_of(TileRole role) {
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (info.role == role) return info.label;
  }
  return "";
}

std::string with_article(TileRole role) {
  const std::string label(label_of(role));
  return (role == TileRole::up_slope ? "an " : "a ") + label;
}

class Linter {
 public:
  explicit Linter(const Level& level) : level_(level), tuning_(level.tuning.article) {
    for (int tile = 0; tile < kTileCount; ++tile) {
      roles_[tile] = role_of(level.tile_flags(static_cast<std::uint8_t>(tile)), level.roles);
      const TileShape shape = shape_of_tile(level, static_cast<std::uint8_t>(tile));
      solid_[tile] = shape.kind == TileShape::Kind::solid && !shape.one_way;
      if (!is_line_shape(shape) || problem_of(shape)) continue;
      // The neighbours that it touches are not covered by it.
      const std::array<Cell, 2> touched = cells_touched_by(shape, {0, 0});
      covered_[tile] = {Cell{touched[0].x + 1, touched[0].y + 1}, Cell{touched[1].x - 1, touched[1].y - 1}};
    }
  }

  std::vector<Problem> run() {
    check_roles();
    check_shapes();
    check_solver();
    for (int y = 0; y < level_.map.height(); ++y) {
      for (int x = 0; x < level_.map.width(); ++x) check_cell({x, y});
    }
    for (std::size_t i = 0; i < level_.spawns.size(); ++i) check_spawn(i);
    if (balls_ == 0 && level_.spawns.empty()) {
      add(Severity::warning, "no-balls",
          "no ball is on the map and none is placed by hand, so nothing will move");
    }
    if (left_out_ > 0) {
      problems_.push_back(
          {worst_left_out_, "more", std::to_string(left_out_) + " more problems are not listed", {}, -1});
    }
    std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
      const Cell none = {-1, -1};
      const Cell p = a.cell.value_or(none), q = b.cell.value_or(none);
      if (p.y != q.y) return p.y < q.y;
      return p.x != q.x ? p.x < q.x : a.code < b.code;
    });
    return std::move(problems_);
  }

 private:
  void add(Severity severity, std::string code, std::string message, std::optional<Cell> cell = {},
           int tile = -1) {
    if (problems_.size() == kMaxProblems) {
      ++left_out_;
      worst_left_out_ = std::max(worst_left_out_, severity);
      return;
    }
    problems_.push_back({severity, std::move(code), std::move(message), cell, tile});
  }

  TileRole role_at(Cell cell) const { return roles_[level_.map.at(cell)]; }
  bool is_solid(Cell cell) const { return solid_[level_.map.at(cell)]; }

  void check_roles() {
    const auto& infos = flag_role_infos();
    for (std::size_t i = 0; i < infos.size(); ++i) {
      for (std::size_t j = i + 1; j < infos.size(); ++j) {
        const int flag = level_.roles.*infos[i].flag;
        if (flag == FlagRoles::kUnused || flag != level_.roles.*infos[j].flag) continue;
        add(Severity::error, "shared-flag",
            "flag " + std::to_string(flag) + " stands for both " + std::string(infos[i].label) + " and " +
                std::string(infos[j].label));
      }
    }
  }

  void check_shapes() {
    for (int flag = 0; flag < kFlagCount; ++flag) {
      if (const auto problem = problem_of(level_.flag_shapes[flag]))
        add(Severity::error, "bad-shape", "the shape of flag " + std::to_string(flag) + " " + *problem);
    }
    for (int tile = 0; tile < kTileCount; ++tile) {
      if (const auto problem = problem_of(level_.tile_shapes[tile]))
        add(Severity::error, "bad-shape", "the shape of tile " + std::to_string(tile) + " " + *problem, {},
            tile);
    }
    for (std::size_t i = 0; i < level_.curves.size(); ++i) {
      const LevelCurve& curve = level_.curves[i];
      const std::string name = curve.name.empty() ? std::to_string(i) : "\"" + curve.name + "\"";
      if (const auto problem = problem_of(curve.curve, level_.map))
        add(Severity::error, "bad-curve", "curve " + name + " " + *problem);
      else if (leaves_map(curve.curve))
        add(Severity::warning, "curve-leaves-map", "curve " + name + " leaves the map between its ends");
    }
  }

  void check_solver() {
    if (level_.curves.empty() || level_.tuning.solver == SolverKind::exact) return;
    add(Severity::warning, "curves-need-exact",
        "curves and segments stop bodies of the exact solver alone, and the level's is " +
            std::string(solver_name(level_.tuning.solver)));
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

  void check_cell(Cell cell) {
    const int tile = level_.map.at(cell);
    if (!seen_[tile]) check_flags(tile, cell);
    seen_[tile] = true;
    const TileRole role = roles_[tile];
    if (is_slope(role)) check_slope(cell, role);
    if (!is_slope(role) || has_own_shape(cell)) check_covered(cell);
    if (role != TileRole::ball) return;
    ++balls_;
    const Vec2 corner = {static_cast<double>(cell.x) * kTileSize, static_cast<double>(cell.y) * kTileSize};
    check_slopes_under(corner, kBallSize, "the ball at " + text_of(cell), cell, tile);
  }

  // One problem for a tile, at the first cell that shows it.
  void check_flags(int tile, Cell cell) {
    std::string labels;
    int count = 0, last_flag = FlagRoles::kUnused;
    for (const FlagRoleInfo& info : flag_role_infos()) {
      const int flag = level_.roles.*info.flag;
      const bool set = has_flag(level_.tile_flags(static_cast<std::uint8_t>(tile)), flag);
      if (!set || flag == last_flag || info.role == TileRole::none) continue;
      labels += (count == 0 ? "" : " and ") + std::string(info.label);
      last_flag = flag;
      ++count;
    }
    if (count < 2) return;
    add(Severity::error, "flags-conflict",
        "tile " + std::to_string(tile) + " has the flags of " + labels + "; only the first, " +
            std::string(label_of(roles_[tile])) + ", counts",
        cell, tile);
  }

  // The cells behind the first that a slope's box covers must show the rest of it.
  void check_slope(Cell cell, TileRole role) {
    const int cells = static_cast<int>(std::ceil(tuning_.slope_width / kTileSize));
    const std::string subject = "tile " + std::to_string(level_.map.at(cell)) + " at " + text_of(cell) +
                                " is " + with_article(role) + ", but ";
    for (int i = 1; i < cells; ++i) {
      const Cell right = {cell.x + i, cell.y};
      const std::string where =
          i == 1 ? "the tile to its right" : "the tile " + std::to_string(i) + " to its right";
      if (!level_.map.contains(right)) {
        return add(Severity::error, "slope-half-missing",
                   subject + "the map ends at its right: the rest of the slope is cut off", cell,
                   level_.map.at(cell));
      }
      const TileRole other = role_at(right);
      if (is_empty(level_.map.at(right))) {
        return add(Severity::error, "slope-half-missing",
                   subject + where + " is empty: half of the slope is not drawn", cell, level_.map.at(cell));
      }
      if (is_solid(right) || is_slope(other)) {
        const std::string why = is_solid(right)
                                    ? " is solid: it stands inside the slope's box"
                                    : " has a slope's flag too: a slope is flagged on its left tile alone";
        return add(Severity::error, "slope-overlap", subject + where + why, cell, level_.map.at(cell));
      }
    }
  }

  // Of a shape that its flags alone give, check_slope says it.
  void check_covered(Cell cell) {
    const int tile = level_.map.at(cell);
    const auto& [first, last] = covered_[tile];
    const std::string where = cell.x + last.x >= level_.map.width()    ? "right"
                              : cell.y + first.y < 0                   ? "upper"
                              : cell.y + last.y >= level_.map.height() ? "lower"
                                                                       : "";
    if (where.empty()) return;
    add(Severity::warning, "shape-leaves-map",
        "tile " + std::to_string(tile) + " at " + text_of(cell) + " reaches over the map's " + where +
            " edge, where it stops nothing",
        cell, tile);
  }

  bool is_empty(int tile) const {
    return roles_[tile] == TileRole::none && !solid_[tile] &&
           (tile == 0 || level_.sheet(SheetId::tiles).images[tile] == TileImage{});
  }

  void check_spawn(std::size_t index) {
    const Spawn& spawn = level_.spawns[index];
    const Vec2 corner = spawn.position, size = spawn.size;
    const std::string name = spawn.name.empty() ? std::to_string(index) : "\"" + spawn.name + "\"";
    const std::string subject =
        "spawn " + name + " at " + text_of(corner.x) + ", " + text_of(corner.y) + " px";
    const double width = level_.map.width() * kTileSize, height = level_.map.height() * kTileSize;
    const bool inside =
        corner.x >= 0 && corner.y >= 0 && corner.x + size.x <= width && corner.y + size.y <= height;
    // Farther away there are no tiles, and perhaps no int for the cell either.
    const bool touches = corner.x > -size.x && corner.y > -size.y && corner.x < width && corner.y < height;
    const Cell corner_cell = touches ? Cell{cell_of(corner.x), cell_of(corner.y)} : Cell{-1, -1};
    const std::optional<Cell> cell =
        level_.map.contains(corner_cell) ? std::optional(corner_cell) : std::nullopt;
    if (!inside) add(Severity::warning, "spawn-outside", subject + " is not wholly on the map", cell);
    if (!touches) return;
    if (!check_solids_under(corner, size, subject, cell)) check_slopes_under(corner, size, subject, cell, -1);
  }

  // Calls visit(cell) for the cells of the map from the one at `first` px to the one before `end` px.
  template <class Visit>
  void for_cells(Vec2 first, Vec2 end, Visit visit) const {
    const int x1 = std::min(level_.map.width(), static_cast<int>(std::ceil(end.x / kTileSize)));
    const int y1 = std::min(level_.map.height(), static_cast<int>(std::ceil(end.y / kTileSize)));
    for (int y = std::max(0, cell_of(first.y)); y < y1; ++y) {
      for (int x = std::max(0, cell_of(first.x)); x < x1; ++x) visit(Cell{x, y});
    }
  }

  // Reports the first solid tile that a body here overlaps; false when there is none.
  bool check_solids_under(Vec2 corner, Vec2 size, const std::string& subject, std::optional<Cell> cell) {
    bool found = false;
    for_cells(corner, corner + size, [&](Cell at) {
      if (found || !is_solid(at)) return;
      found = true;
      add(Severity::error, "spawn-in-solid", subject + " starts inside the solid tile at " + text_of(at),
          cell);
    });
    return found;
  }

  // Reports the first slope below whose floor, as the article computes it, a ball here would start.
  void check_slopes_under(Vec2 corner, Vec2 size, const std::string& subject, std::optional<Cell> cell,
                          int tile) {
    const Vec2 reach = {tuning_.slope_width, tuning_.slope_height};
    bool found = false;
    for_cells(corner - reach, corner + size, [&](Cell at) {
      if (found || !is_slope(role_at(at)) || has_own_shape(at)) return;
      const double depth = depth_in_slope(corner, size, at);
      if (!(depth > 0)) return;
      found = true;
      add(Severity::error, "spawn-in-slope",
          subject + " starts " + text_of(depth) + " px inside the " + std::string(label_of(role_at(at))) +
              " at " + text_of(at),
          cell, tile);
    });
  }

  bool has_own_shape(Cell at) const {
    return level_.tile_shapes[level_.map.at(at)].kind != TileShape::Kind::none;
  }

  // How far a body lies below a slope's floor at its centre; 0 when it is above, or beside the slope's box.
  double depth_in_slope(Vec2 corner, Vec2 size, Cell at) const {
    const double w = tuning_.slope_width, h = tuning_.slope_height;
    const Vec2 slope = {static_cast<double>(at.x) * kTileSize, static_cast<double>(at.y) * kTileSize};
    const bool overlaps = corner.x < slope.x + w && corner.x + size.x > slope.x && corner.y < slope.y + h &&
                          corner.y + size.y > slope.y;
    if (!overlaps) return 0;
    const double along = std::clamp(corner.x + size.x / 2 - slope.x, 0.0, w) / w;
    const double drop = role_at(at) == TileRole::up_slope ? h * (1 - along) : h * along;
    return std::max(0.0, corner.y - (slope.y - h + drop));
  }

  const Level& level_;
  const ArticleTuning& tuning_;
  std::array<TileRole, kTileCount> roles_{};
  std::array<bool, kTileCount> solid_{};  // by shape_of_tile, and from all sides
  // By shape_of_tile: the first and the last cell that a slope or the like reaches over, from its own.
  std::array<std::array<Cell, 2>, kTileCount> covered_{};
  std::array<bool, kTileCount> seen_{};
  int balls_ = 0;
  std::size_t left_out_ = 0;  // problems over kMaxProblems
  Severity worst_left_out_ = Severity::warning;
  std::vector<Problem> problems_;
};

}  // namespace

std::vector<Problem> lint(const Level& level) { return Linter(level).run(); }

}  // namespace talus
