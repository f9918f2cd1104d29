// Slopes whose other half is missing, shapes over the map's edge, balls inside of slopes.
#include <algorithm>
#include <tuple>

#include "level/level_text.h"
#include "lint_parts.h"

namespace talus {
namespace {

constexpr Vec2 kBallSize = {8, 8};  // px, of a ball tile's ball

class CellLinter {
 public:
  CellLinter(const Level& level, const LintTiles& tiles, std::vector<Problem>& out)
      : level_(level), tiles_(tiles), out_(out) {
    for (std::size_t i = 0; i < kTileCount; ++i) {
      const LintTiles::Tile& tile = tiles[i];
      matters_[i] = tiles.is_slope(i) || tile.role == TileRole::ball || tile.line || tile.half_of >= 0;
    }
  }

  void check(Cell cell) {
    const std::uint8_t tile = level_.map.at(cell);
    if (!matters_[tile]) return;
    if (tiles_.is_slope(tile))
      check_slope(cell, tile);
    else
      check_drawn(cell, tile);
    if (!tiles_.is_slope(tile) || tiles_[tile].own_shape) check_covered(cell, tile);
    if (tiles_[tile].half_of >= 0) check_right_half(cell, tile);
    if (tiles_[tile].role == TileRole::ball) check_ball(cell, tile);
  }

 private:
  void add(Severity severity, const char* code, const std::string& message, Cell cell, int tile) {
    out_.push_back({severity, code, message, cell, tile, -1});
  }

  void check_slope(Cell cell, int tile) {
    const auto fault = slope_fault_at(level_, tiles_, cell);
    if (!fault) return;
    add(Severity::error, fault->code,
        "tile " + std::to_string(tile) + " at " + cell_text(cell) + " is " +
            role_with_article(tiles_[static_cast<std::size_t>(tile)].role) + ", but " + fault->text,
        cell, tile);
  }

  // The same of a shape of its own, in all its columns and rows.
  void check_drawn(Cell cell, int tile) {
    const std::vector<Cell> undrawn = undrawn_cells(level_, tiles_, cell);
    if (undrawn.empty()) return;
    const std::size_t more = undrawn.size() - 1;
    const bool sheet_ends = tile % kSheetColumns + undrawn.back().x - cell.x >= kSheetColumns;
    add(Severity::warning, "slope-half-missing",
        "tile " + std::to_string(tile) + " at " + cell_text(cell) + " has a shape that goes on over " +
            cell_text(undrawn.front()) +
            (more == 0 ? "" : " and " + std::to_string(more) + (more == 1 ? " cell more" : " cells more")) +
            ", where nothing shows it" +
            (sheet_ends ? ": it is wider than what the sheet has at the tile's right" : ""),
        cell, tile);
  }

  // What is drawn as the right half of a slope needs the flagged tile at its left.
  void check_right_half(Cell cell, int tile) {
    const int half_of = tiles_[static_cast<std::size_t>(tile)].half_of;
    const Cell left{cell.x - 1, cell.y};
    if (level_.map.contains(left) && tiles_.is_slope(level_.map.at(left))) return;
    add(Severity::warning, "slope-left-missing",
        "tile " + std::to_string(tile) + " at " + cell_text(cell) + " is drawn as the right half of tile " +
            std::to_string(half_of) + ", " +
            role_with_article(tiles_[static_cast<std::size_t>(half_of)].role) +
            ", but no slope is at its left: bodies fall through it",
        cell, tile);
  }

  // Of a shape that its flags alone give, check_slope says it.
  void check_covered(Cell cell, int tile) {
    const auto& [first, last] = tiles_[static_cast<std::size_t>(tile)].covered;
    const std::string where = cell.x + last.x >= level_.map.width()    ? "right"
                              : cell.y + first.y < 0                   ? "upper"
                              : cell.y + last.y >= level_.map.height() ? "lower"
                                                                       : "";
    if (where.empty()) return;
    add(Severity::warning, "shape-leaves-map",
        "tile " + std::to_string(tile) + " at " + cell_text(cell) + " reaches over the map's " + where +
            " edge, where it stops nothing",
        cell, tile);
  }

  void check_ball(Cell cell, int tile) {
    const Vec2 corner = {static_cast<double>(cell.x) * kTileSize, static_cast<double>(cell.y) * kTileSize};
    const int left = std::max(0, cell.x - tiles_.slope_cells());
    const int up = std::max(0, cell.y - tiles_.slope_rows());
    for (Cell at{left, up}; at.y <= cell.y; ++at.y) {
      for (at.x = left; at.x <= cell.x; ++at.x) {
        const std::uint8_t slope = level_.map.at(at);
        if (!tiles_.is_slope(slope) || tiles_[slope].own_shape) continue;
        const double depth = depth_in_slope(level_, corner, kBallSize, at);
        if (!(depth > 0)) continue;
        return add(Severity::error, "spawn-in-slope",
                   "the ball at " + cell_text(cell) + " starts " + px_text(depth) + " px inside the " +
                       role_label(tiles_[slope].role) + " at " + cell_text(at),
                   cell, tile);
      }
    }
  }

  const Level& level_;
  const LintTiles& tiles_;
  std::vector<Problem>& out_;
  std::array<bool, kTileCount> matters_{};
};

}  // namespace

void lint_cells(const Level& level, const LintTiles& tiles, std::array<Cell, 2> area,
                std::vector<Problem>& out) {
  CellLinter linter(level, tiles, out);
  for (Cell c = area[0]; c.y <= area[1].y; ++c.y) {
    for (c.x = area[0].x; c.x <= area[1].x; ++c.x) linter.check(c);
  }
  lint_seams(level, tiles, area, out);
  lint_gaps(level, tiles, area, out);
}

// The cells behind the first that a slope's box covers must show the rest of it.
std::optional<SlopeFault> slope_fault_at(const Level& level, const LintTiles& tiles, Cell cell) {
  if (!tiles.is_slope(level.map.at(cell))) return std::nullopt;
  for (int i = 1; i < tiles.slope_cells(); ++i) {
    const Cell right = {cell.x + i, cell.y};
    const std::string where =
        i == 1 ? "the tile to its right" : "the tile " + std::to_string(i) + " to its right";
    if (!level.map.contains(right))
      return SlopeFault{"slope-half-missing", "the map ends at its right: the rest of the slope is cut off"};
    const std::uint8_t other = level.map.at(right);
    if (tiles.is_empty(other))
      return SlopeFault{"slope-half-missing", where + " is empty: half of the slope is not drawn"};
    if (tiles[other].solid)
      return SlopeFault{"slope-overlap", where + " is solid: it stands inside the slope's box"};
    if (tiles.is_slope(other)) {
      return SlopeFault{"slope-overlap",
                        where + " has a slope's flag too: only the left tile of a slope may be flagged"};
    }
  }
  return std::nullopt;
}

std::vector<Cell> undrawn_cells(const Level& level, const LintTiles& tiles, Cell cell) {
  const std::uint8_t number = level.map.at(cell);
  const LintTiles::Tile& tile = tiles[number];
  std::vector<Cell> undrawn;
  if (!tile.line || tile.blank || tiles.is_slope(number)) return undrawn;
  for (const Cell by : tile.to_draw) {
    const Cell at{cell.x + by.x, cell.y + by.y};
    if (level.map.contains(at) && tiles.is_empty(level.map.at(at))) undrawn.push_back(at);
  }
  return undrawn;
}

double depth_in_slope(const Level& level, Vec2 corner, Vec2 size, Cell at) {
  const double w = level.tuning.shared.slope_width, h = level.tuning.shared.slope_height;
  const Vec2 slope = {static_cast<double>(at.x) * kTileSize, static_cast<double>(at.y) * kTileSize};
  const bool overlaps = corner.x < slope.x + w && corner.x + size.x > slope.x && corner.y < slope.y + h &&
                        corner.y + size.y > slope.y;
  if (!overlaps) return 0;
  const double along = std::clamp(corner.x + size.x / 2 - slope.x, 0.0, w) / w;
  const double drop = level.role_at(at) == TileRole::up_slope ? h * (1 - along) : h * along;
  return std::max(0.0, corner.y - (slope.y - h + drop));
}

bool is_before(const Problem& a, const Problem& b) {
  const Cell none = {-1, -1};
  const Cell p = a.cell.value_or(none), q = b.cell.value_or(none);
  return std::tie(p.y, p.x, a.code) < std::tie(q.y, q.x, b.code);
}

}  // namespace talus
