// Finds slopes that lack a half, a flag or a picture, or that overlap other tiles.
#include "../level_text.h"
#include "fix_parts.h"
#include "rule_group.h"
#include "slope_fault.h"

namespace talus {
namespace {

LintFix fix_missing_half, fix_missing_left, fix_overlap, fix_unflagged;

constexpr LintRule kHalfMissing{
    .code = "slope-half-missing",
    .label = "slope without its right half",
    .by_hand = "Place the tile that shows the rest of the slope beside it, or take the slope away.",
    .severity = Severity::error,
    .fix = fix_missing_half};
constexpr LintRule kLeftMissing{
    .code = "slope-left-missing",
    .label = "slope without its left half",
    .by_hand = "Place the slope's left half at its left and ground at its right, or take the tile away.",
    .fix = fix_missing_left};
constexpr LintRule kOverlap{
    .code = "slope-overlap",
    .label = "slope and tile in one place",
    .by_hand =
        "Put the slope's right half, without a slope's flag, in the place of that tile, or move the slope.",
    .severity = Severity::error,
    .fix = fix_overlap};
constexpr LintRule kUnflagged{
    .code = "slope-unflagged",
    .label = "slope without a flag",
    .by_hand = "Set the slope's flag in the flags panel, and lay ground where the slope ends.",
    .fix = fix_unflagged};

std::string tile_at_text(const LintTiles& tiles, int tile, Cell cell) {
  return tiles.text_of(tile) + " at " + cell_text(cell);
}

// Returns the cells on the map that need a tile to draw the rest of the shape in a cell, from left to right.
// The list is empty if the cell has no shape, if flags make it a slope, or if its own tile is not drawn
// either.
std::vector<Cell> undrawn_cells(const Level& level, const LintTiles& tiles, Cell cell) {
  const TileNumber number = level.map.tile_at(cell);
  const LintTiles::Tile& tile = tiles[number];
  std::vector<Cell> undrawn;
  if (!tile.line || tile.blank || tiles.is_slope(number)) return undrawn;
  for (const Cell by : tile.to_draw) {
    const Cell at{cell.x + by.x, cell.y + by.y};
    if (level.map.contains(at) && tiles.is_empty(level.map.tile_at(at))) undrawn.push_back(at);
  }
  return undrawn;
}

void check_slope(const LintContext& context, Cell cell, int tile, std::vector<Problem>& out) {
  const auto fault = slope_fault_at(context.level, context.tiles, cell);
  if (!fault) return;
  report(out, *fault->rule,
         tile_at_text(context.tiles, tile, cell) + " is " +
             role_with_article(context.tiles[static_cast<std::size_t>(tile)].role) + ", but " + fault->text,
         cell, tile);
}

// Checks the same for a shape of its own, in all its columns and rows.
void check_drawn(const LintContext& context, Cell cell, int tile, std::vector<Problem>& out) {
  const std::vector<Cell> undrawn = undrawn_cells(context.level, context.tiles, cell);
  if (undrawn.empty()) return;
  const std::size_t more = undrawn.size() - 1;
  const SheetLayout sheet = context.level.sheet(SheetId::tiles).layout();
  const bool sheet_ends = sheet.place_of(tile).x + undrawn.back().x - cell.x >= sheet.columns;
  report(out, kHalfMissing,
         tile_at_text(context.tiles, tile, cell) + " has a shape that also covers " +
             cell_text(undrawn.front()) +
             (more == 0 ? "" : " and " + std::to_string(more) + (more == 1 ? " more cell" : " more cells")) +
             ", where no tile shows it" +
             (sheet_ends ? ": it is wider than what the sheet has at the tile's right" : ""),
         cell, tile)
      .severity = Severity::warning;  // only the picture is wrong
}

// A tile drawn as the right half of a slope needs the flagged tile to its left.
void check_right_half(const LintContext& context, Cell cell, int tile, std::vector<Problem>& out) {
  const auto& [level, tiles, has_balls] = context;
  const int half_of = tiles[static_cast<std::size_t>(tile)].half_of;
  const Cell left{cell.x - 1, cell.y};
  if (half_of < 0 || (level.map.contains(left) && tiles.is_slope(level.map.tile_at(left)))) return;
  report(out, kLeftMissing,
         tile_at_text(tiles, tile, cell) + " is drawn as the right half of " + tile_text(half_of) + ", " +
             role_with_article(tiles[static_cast<std::size_t>(half_of)].role) +
             ", but no slope is at its left: bodies fall through it",
         cell, tile);
}

void check_slopes(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out) {
  for (Cell cell = area[0]; cell.y <= area[1].y; ++cell.y) {
    for (cell.x = area[0].x; cell.x <= area[1].x; ++cell.x) {
      const TileNumber tile = context.level.map.tile_at(cell);
      if (context.tiles.is_slope(tile))
        check_slope(context, cell, tile, out);
      else if (context.tiles[tile].line)
        check_drawn(context, cell, tile, out);
      check_right_half(context, cell, tile, out);
    }
  }
}

void check_flag(const LintContext& context, int tile, std::vector<Problem>& out) {
  const int like = context.tiles[static_cast<std::size_t>(tile)].like;
  if (like < 0) return;
  report(out, kUnflagged,
         context.tiles.text_of(tile) + " is drawn like " + tile_text(like) + ", " +
             role_with_article(context.tiles[static_cast<std::size_t>(like)].role) +
             ", but nothing makes it one",
         {}, tile);
}

void fix_right_half(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const LintTiles& tiles = context.tiles;
  const Cell cell = *problem.cell;
  for (int i = 1; i < tiles.slope_cells(); ++i) {
    const Cell right{cell.x + i, cell.y};
    if (!level.map.contains(right)) {
      out.push_back(put_tile(level, cell, 0,
                             "Take " + tile_text(problem.tile) + " away from " + cell_text(cell) +
                                 ", where the map cuts it off"));
      return;
    }
    if (!tiles.is_empty(level.map.tile_at(right))) continue;
    const auto half = beside(level, problem.tile, i);
    if (!half || tiles[*half].blank || tiles[*half].solid || tiles.is_slope(*half)) return;
    out.push_back(put_tile(level, right, *half,
                           "Place " + tile_text(*half) + ", the slope's right half, at " + cell_text(right)));
    return;
  }
}

// Adds the fix that puts the tiles beside the shape's tile on the sheet into its cells on the map. Adds
// nothing if one of them is not drawn, or is ground itself.
void fix_undrawn_shape(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const LintTiles& tiles = context.tiles;
  const Cell cell = *problem.cell;
  Edit edit;
  for (const Cell at : undrawn_cells(level, tiles, cell)) {
    const auto tile = beside(level, problem.tile, at.x - cell.x, at.y - cell.y);
    if (!tile || tiles[*tile].blank || !tiles[*tile].shapeless) return;
    edit.changes.emplace_back(CellChange{at, level.map.tile_at(at), *tile});
  }
  const auto& first = std::get<CellChange>(edit.changes.front());
  const bool is_one = edit.changes.size() == 1;
  edit.label = "Place " +
               (is_one ? tile_text(first.after.tile) : std::to_string(edit.changes.size()) + " tiles") +
               ", the rest of " + tile_text(problem.tile) + "'s shape, at " + cell_text(first.cell) +
               (is_one ? "" : " and on");
  out.push_back(std::move(edit));
}

void fix_overlap(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const LintTiles& tiles = context.tiles;
  for (int i = 1; i < tiles.slope_cells(); ++i) {
    const Cell right{problem.cell->x + i, problem.cell->y};
    if (!level.map.contains(right)) return;
    const TileNumber tile = level.map.tile_at(right);
    if (!tiles[tile].solid && !tiles.is_slope(tile)) continue;
    const auto half = beside(level, problem.tile, i);
    if (tiles.is_slope(tile) && half == tile) {
      const TileRole role = tiles[tile].role;
      const int flag = role == TileRole::up_slope ? level.roles.up_slope : level.roles.down_slope;
      const FlagSet flags = level.tile_flags(tile);
      out.push_back(single_change(
          "Clear the " + role_label(role) + " flag of " + tile_text(tile) + ", the slope's right half",
          FlagsChange{SheetId::tiles, tile, flags, flags & ~flag_bit(flag)}));
    } else if (half && !tiles[*half].blank && !tiles[*half].solid && !tiles.is_slope(*half)) {
      out.push_back(put_tile(level, right, *half,
                             "Put " + tile_text(*half) + ", the slope's right half, in the place of " +
                                 tile_text(tile) + " at " + cell_text(right)));
    }
    return;
  }
}

void fix_missing_left(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const LintTiles& tiles = context.tiles;
  const Cell cell = *problem.cell, left{cell.x - 1, cell.y};
  const int half_of = tiles[static_cast<std::size_t>(problem.tile)].half_of;
  if (level.map.contains(left) && tiles.is_empty(level.map.tile_at(left))) {
    out.push_back(put_tile(level, left, static_cast<TileNumber>(half_of),
                           "Place " + tile_text(half_of) + ", the slope's left half, at " + cell_text(left)));
  }
  out.push_back(
      put_tile(level, cell, 0, "Take " + tile_text(problem.tile) + " away from " + cell_text(cell)));
}

void fix_unflagged(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const LintTiles& tiles = context.tiles;
  const int like = tiles[static_cast<std::size_t>(problem.tile)].like;
  const auto tile = static_cast<TileNumber>(problem.tile);
  const TileRole role = tiles[static_cast<std::size_t>(like)].role;
  const int flag = role == TileRole::up_slope ? level.roles.up_slope : level.roles.down_slope;
  const FlagSet flags = level.tile_flags(tile);
  out.push_back(
      single_change("Set flag " + std::to_string(flag) + ", " + role_label(role) + ", of " + tile_text(tile),
                    FlagsChange{SheetId::tiles, tile, flags, flags | flag_bit(flag)}));
}

void fix_missing_half(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const bool is_flagged = context.tiles.is_slope(static_cast<std::size_t>(problem.tile));
  (is_flagged ? fix_right_half : fix_undrawn_shape)(context, problem, out);
}

}  // namespace

// The other cells that a slope's box covers must show the rest of it.
std::optional<SlopeFault> slope_fault_at(const Level& level, const LintTiles& tiles, Cell cell) {
  if (!tiles.is_slope(level.map.tile_at(cell))) return std::nullopt;
  for (int i = 1; i < tiles.slope_cells(); ++i) {
    const Cell right = {cell.x + i, cell.y};
    const std::string where =
        i == 1 ? "the tile to its right" : "the tile " + std::to_string(i) + " to its right";
    if (!level.map.contains(right))
      return SlopeFault{&kHalfMissing, "the map ends at its right: the rest of the slope is cut off"};
    const TileNumber other = level.map.tile_at(right);
    if (tiles.is_empty(other))
      return SlopeFault{&kHalfMissing, where + " is empty: half of the slope is not drawn"};
    if (tiles[other].solid)
      return SlopeFault{&kOverlap, where + " is solid: it stands inside the slope's box"};
    if (tiles.is_slope(other)) {
      return SlopeFault{&kOverlap,
                        where + " has a slope's flag too: only the left tile of a slope may be flagged"};
    }
  }
  return std::nullopt;
}

const RuleGroup& slope_rules() {
  static constexpr const LintRule* kRules[] = {&kHalfMissing, &kLeftMissing, &kOverlap, &kUnflagged};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_tile = check_flag, .check_area = check_slopes};
  return kGroup;
}

}  // namespace talus
