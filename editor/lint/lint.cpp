// The rules by name: what users of the article's convention get wrong. Only what is certainly wrong is an
// error.
#include "lint.h"

#include <algorithm>
#include <array>

#include "lint_cache.h"

namespace talus {

std::span<const LintRule> lint_rules() {
  static constexpr std::array<LintRule, 25> kRules = {{
      {"slope-half-missing", "slope without its right half"},
      {"slope-left-missing", "slope without its left half"},
      {"slope-overlap", "slope and tile in one place"},
      {"slope-unflagged", "slope without a flag"},
      {"seam", "floor that jumps"},
      {"seam-ceiling", "ceiling that jumps"},
      {"interior-edge", "edge inside the ground"},
      {"too-steep", "floor too steep"},
      {"gap-too-small", "gap too small for a player"},
      {"flags-conflict", "flags that contradict each other"},
      {"flag-idle", "flag that changes nothing"},
      {"invisible", "tile without a picture"},
      {"spawn-in-solid", "body inside a tile"},
      {"spawn-in-slope", "body inside a slope"},
      {"spawn-outside", "body off the map"},
      {"no-balls", "nothing to move"},
      {"shape-leaves-map", "shape over the map's edge"},
      {"bad-shape", "shape that cannot be used"},
      {"bad-curve", "curve that cannot be used"},
      {"curve-leaves-map", "curve that leaves the map"},
      {"curves-need-exact", "curves without their solver"},
      {"ground-not-in-article", "ground that the article does not know"},
      {"too-much-ground", "too much ground for its solver"},
      {"spawn-too-fast", "body that is too fast"},
      {"shared-flag", "flag with two meanings"},
  }};
  return kRules;
}

std::string_view rule_label(std::string_view code) {
  for (const LintRule& rule : lint_rules()) {
    if (rule.code == code) return rule.label;
  }
  return code;
}

std::vector<Problem> lint(const Level& level, const LintOptions& options) {
  LintCache cache;
  cache.finish(level, options);
  return cache.problems();
}

}  // namespace talus
