// The rules of the lint. A file *_rules.cpp holds those that are checked together: their rows, what checks
// them, and what fixes what they find.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lint_tiles.h"

namespace talus {

// What checks and fixes look at.
struct LintContext {
  const Level& level;
  const LintTiles& tiles;
  // Whether ball tiles are on the map; true while not all of the map has been looked at.
  bool has_balls = true;
};

// Rules that are checked together. Each check appends the problems that it finds, in any order; null: these
// rules have nothing of the sort.
struct RuleGroup {
  std::span<const LintRule* const> rules;
  // A tile wherever it is: 0..255. Its problems have no cell; they get that of the tile's first one.
  void (*check_tile)(const LintContext&, int tile, std::vector<Problem>& out) = nullptr;
  // The cells from the first to the last of the two, both on the map. Their problems have a cell, and depend
  // on no cell further away than LintTiles::reach(), and beside the map on LintTiles alone.
  void (*check_area)(const LintContext&, std::array<Cell, 2> area, std::vector<Problem>& out) = nullptr;
  // What else a level has: roles, shapes, curves, spawns, tuning.
  void (*check_level)(const LintContext&, std::vector<Problem>& out) = nullptr;
};

// All of them, in rule_list.cpp.
std::span<const RuleGroup* const> rule_groups();
const RuleGroup* group_of(const LintRule& rule);  // null: no group has it

// Appends a problem of the rule, with the rule's severity, and returns it. The rest is as in Problem.
Problem& report(std::vector<Problem>& out, const LintRule& rule, std::string message,
                std::optional<Cell> cell = {}, int tile = -1, int object = -1);

// The cell of the map where a place is, or that is nearest to it; nothing if the map has no cells, or the
// place is no number.
std::optional<Cell> nearest_cell(const TileMap& map, Vec2 at);

// The checks of all groups, as in RuleGroup.
void check_tile(const LintContext& context, int tile, std::vector<Problem>& out);
void check_level(const LintContext& context, std::vector<Problem>& out);
void check_area(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out);

}  // namespace talus
