// Runs the rules one after the other, and checks a whole level at once.
#include "lint.h"

#include <algorithm>
#include <cmath>

#include "../ground_level.h"
#include "layer_rules.h"
#include "lint_cache.h"
#include "rule_group.h"

namespace talus {

std::span<const LintRule* const> lint_rules() {
  static const std::vector<const LintRule*> kRules = [] {
    std::vector<const LintRule*> rules;
    for (const RuleGroup* group : rule_groups())
      rules.insert(rules.end(), group->rules.begin(), group->rules.end());
    return rules;
  }();
  return kRules;
}

std::vector<Problem> lint(const Level& level, const LintOptions& options) {
  LintCache cache;
  if (has_plain_ground(level)) {
    cache.finish(level, options);
  } else {
    GroundNames names;
    const Level ground = linted_level(level, &names);
    cache.finish(ground, options, names);
  }
  return cache.problems();
}

Problem& report(std::vector<Problem>& out, const LintRule& rule, std::string message,
                std::optional<Cell> cell, int tile, int object) {
  return out.emplace_back(Problem{&rule, rule.severity, std::move(message), cell, tile, object});
}

std::optional<Cell> nearest_cell(const TileMap& map, Vec2 at) {
  const int width = map.width(), height = map.height();
  if (width == 0 || height == 0 || std::isnan(at.x) || std::isnan(at.y)) return std::nullopt;
  const auto clamped = [](double px, int side, int cells) {  // a far place may not fit into an int
    return static_cast<int>(std::clamp(std::floor(px / side), 0.0, cells - 1.0));
  };
  const TileSize tile = map.tile_size();
  return Cell{clamped(at.x, tile.width, width), clamped(at.y, tile.height, height)};
}

void check_tile(const LintContext& context, int tile, std::vector<Problem>& out) {
  for (const RuleGroup* group : rule_groups())
    if (group->check_tile != nullptr) group->check_tile(context, tile, out);
}

void check_level(const LintContext& context, std::vector<Problem>& out) {
  for (const RuleGroup* group : rule_groups())
    if (group->check_level != nullptr) group->check_level(context, out);
}

void check_area(const LintContext& context, std::array<Cell, 2> area, std::vector<Problem>& out) {
  for (const RuleGroup* group : rule_groups())
    if (group->check_area != nullptr) group->check_area(context, area, out);
}

const RuleGroup* group_of(const LintRule& rule) {
  const auto groups = rule_groups();
  const auto found = std::find_if(groups.begin(), groups.end(), [&](const RuleGroup* group) {
    return std::find(group->rules.begin(), group->rules.end(), &rule) != group->rules.end();
  });
  return found == groups.end() ? nullptr : *found;
}

}  // namespace talus
