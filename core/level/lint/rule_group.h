// The rules of the lint. A file *_rules.cpp holds rules that are checked together: their rows, their checks
// and their fixes.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lint_tiles.h"

namespace talus {

// What checks and fixes may look at.
struct LintContext {
  const Level& level;
  const LintTiles& tiles;
  // Whether the map has ball tiles; true until all of the map has been checked.
  bool has_balls = true;
};

// Rules that are checked together. Each check appends the problems that it finds, in any order. A check that
// the group does not need is null.
struct RuleGroup {
  std::span<const LintRule* const> rules;
  // Checks a tile, below tile_count(), wherever it is. Its problems have no cell; they get the first cell
  // with the tile.
  void (*check_tile)(const LintContext&, int tile, std::vector<Problem>& out) = nullptr;
  // Checks the cells from the first to the last one, both on the map. Its problems have a cell. They depend
  // on LintTiles and on cells within LintTiles::reach(), and on nothing else.
  void (*check_area)(const LintContext&, std::array<Cell, 2> area, std::vector<Problem>& out) = nullptr;
  // Checks the rest of a level: roles, shapes, curves, spawns, tuning.
  void (*check_level)(const LintContext&, std::vector<Problem>& out) = nullptr;
};

// All groups, from rule_list.cpp.
std::span<const RuleGroup* const> rule_groups();
const RuleGroup* group_of(const LintRule& rule);  // null: no group has the rule

// Appends a problem with the severity of the rule, and returns it. The other parameters are as in Problem.
Problem& report(std::vector<Problem>& out, const LintRule& rule, std::string message,
                std::optional<Cell> cell = {}, int tile = -1, int object = -1);

// Returns the cell of the map at a place in px, or the nearest one; empty if the map has no cells, or if the
// place is not a number.
std::optional<Cell> nearest_cell(const TileMap& map, Vec2 at);

// These run the checks of all groups, as in RuleGroup.
void check_tile(const LintContext& context, int tile, std::vector<Problem>& out);
void check_level(const LintContext& context, std::vector<Problem>& out);
void check_area(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out);

}  // namespace talus
