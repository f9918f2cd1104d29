// Finds curves that are invalid, or that leave the map between their ends.
#include <algorithm>

#include <talus/level/ground.h>
#include "../curve_span.h"
#include "../level_text.h"
#include "fix_parts.h"
#include "rule_group.h"

namespace talus {
namespace {

LintFix fix_curve;

constexpr LintRule kBadCurve{.code = "bad-curve",
                             .label = "curve that cannot be used",
                             .by_hand = "Drag the ends of the curve, or delete it.",
                             .severity = Severity::error,
                             .fix = fix_curve};
constexpr LintRule kCurveLeavesMap{.code = "curve-leaves-map",
                                   .label = "curve that leaves the map",
                                   .by_hand = "Drag the handles of the curve until all of it is on the map.",
                                   .fix = fix_curve};

std::string curve_name(const Level& level, int index) {
  const std::string& name = level.curves[static_cast<std::size_t>(index)].name;
  return "curve " + (name.empty() ? std::to_string(index) : "\"" + name + "\"");
}

// Whether a curve whose ends are on the map goes above or below it. Each piece rises or falls throughout.
bool leaves_map(const Curve& curve, const TileMap& map) {
  const auto is_off_map = [&](double y) {
    return y < -kCurveEndSlack || y > map.px_height() + kCurveEndSlack;
  };
  const std::vector<Piece<double>> pieces = cut_curves({&curve, 1}).pieces;
  return std::any_of(pieces.begin(), pieces.end(), [&](const Piece<double>& piece) {
    return is_off_map(piece.y0) || is_off_map(piece.y1);
  });
}

void check_curves(const LintContext& context, std::vector<Problem>& out) {
  const Level& level = context.level;
  for (int i = 0; i < static_cast<int>(level.curves.size()); ++i) {
    const Curve& curve = level.curves[static_cast<std::size_t>(i)].curve;
    const std::optional<Cell> cell = nearest_cell(level.map, span_of(curve).from);
    if (const auto problem = problem_of(curve, level.map))
      report(out, kBadCurve, curve_name(level, i) + " " + *problem, cell, -1, i);
    else if (leaves_map(curve, level.map))
      report(out, kCurveLeavesMap, curve_name(level, i) + " leaves the map between its ends", cell, -1, i);
  }
}

void fix_curve(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  if (problem.object < 0 || static_cast<std::size_t>(problem.object) >= level.curves.size()) return;
  std::vector<LevelCurve> curves = level.curves;
  curves.erase(curves.begin() + problem.object);
  out.push_back(single_change("Remove " + curve_name(level, problem.object),
                              CurvesChange{level.curves, std::move(curves)}));
}

}  // namespace

const RuleGroup& curve_rules() {
  static constexpr const LintRule* kRules[] = {&kBadCurve, &kCurveLeavesMap};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_level = check_curves};
  return kGroup;
}

}  // namespace talus
