// Finds ground and bodies that the level's solver does not know, and too much ground.
#include <algorithm>
#include <utility>
#include <vector>

#include <talus/level/ground.h>
#include "../bump_boxes.h"
#include "../level_text.h"
#include "fix_parts.h"
#include "rule_group.h"

namespace talus {
namespace {

LintFix fix_solver, fix_meet;

constexpr LintRule kCurvesNeedExact{.code = "curves-need-exact",
                                    .label = "curves without their solver",
                                    .by_hand = "Choose the solver exact in Tuning, or delete the curves.",
                                    .fix = fix_solver};
constexpr LintRule kConveyorsNeedExact{.code = "conveyors-need-exact",
                                       .label = "conveyors without their solver",
                                       .by_hand = "Choose the solver exact in Tuning.",
                                       .fix = fix_solver};
constexpr LintRule kNotInArticle{
    .code = "ground-not-in-article",
    .label = "ground that the article does not know",
    .by_hand = "Choose the solver exact or bump in Tuning, or give the tiles other shapes."};
constexpr LintRule kNotInBump{
    .code = "ground-not-in-bump",
    .label = "ground that bump does not know",
    .by_hand = "Choose the solver exact in Tuning, or give the tiles other shapes."};
constexpr LintRule kNeedsMeet{.code = "needs-meet",
                              .label = "bodies that do not meet",
                              .by_hand = "Choose the solver exact, and meet for bodies, in Tuning.",
                              .fix = fix_meet};
constexpr LintRule kTooMuchGround{.code = "too-much-ground",
                                  .label = "too much ground for its solver",
                                  .by_hand = "Take ground away, or choose another solver in Tuning.",
                                  .severity = Severity::error};

bool is_unknown_to_article(const TileShape& shape, TileSize tile) {
  if (has_parts(shape)) return !article_takes_all_of(shape, tile);
  return shape.one_way || shape.kind == TileShape::Kind::profile ||
         (has_heights(shape) && shape.side == TileShape::Side::ceiling);
}

// The article knows only full tiles and floors; bump knows no ground between two slopes without a level line
// between them. This finds the tiles on the map that the level's solver lets bodies through.
void check_tiles(const Level& level, const GroundNames& names, std::vector<Problem>& out) {
  const SolverKind solver = level.tuning.solver;
  if (solver == SolverKind::exact) return;
  const bool is_bump = solver == SolverKind::bump;
  const TileSize size = level.map.tile_size();
  std::vector<bool> used(static_cast<std::size_t>(level.tile_count()));
  for (const TileNumber tile : level.map.cells().tiles()) used[tile] = true;
  std::string numbers, tiles;  // of the first ones; the tiles by their names
  bool has_numbers = true;     // whether the numbers tell which tiles they are
  int count = 0, first = -1;
  for (int tile = 0; tile < level.tile_count(); ++tile) {
    if (!used[static_cast<std::size_t>(tile)]) continue;
    const TileShape shape = shape_of_tile(level, static_cast<TileNumber>(tile));
    const bool has_role =
        level.tile_shapes[static_cast<std::size_t>(tile)].kind == TileShape::Kind::none &&
        role_of(level.tile_flags(static_cast<TileNumber>(tile)), level.roles) != TileRole::none;
    if (shape.kind == TileShape::Kind::none || has_role || problem_of(shape, size)) continue;
    if (is_bump ? bump_takes_all_of(shape) : !is_unknown_to_article(shape, size)) continue;
    if (count == 0) first = tile;
    if (++count > 3) continue;
    const std::string separator = count > 1 ? ", " : "", name = names.text_of(tile);
    numbers += separator + std::to_string(tile);
    tiles += separator + name;
    has_numbers = has_numbers && name == tile_text(tile);
  }
  if (count == 0) return;
  std::string named = has_numbers ? (count == 1 ? "tile " : "tiles ") + numbers : tiles;
  if (count > 3) named += " and " + std::to_string(count - 3) + " more";
  if (is_bump) {
    report(out, kNotInBump,
           "bodies pass through parts of " + named +
               ": bump does not know ground between two slopes that no level line separates; exact does",
           {}, first);
  } else {
    report(
        out, kNotInArticle,
        "bodies pass through " + named +
            ": the article's solver does not know one-way ground, ceilings and profiles; bump and exact do",
        {}, first);
  }
}

void check_solver_of_curves(const Level& level, std::vector<Problem>& out) {
  if (level.curves.empty() || level.tuning.solver == SolverKind::exact) return;
  report(out, kCurvesNeedExact,
         "curves and segments stop only bodies of the exact solver, but the level's solver is " +
             std::string(solver_name(level.tuning.solver)));
}

void check_conveyors(const Level& level, std::vector<Problem>& out) {
  if (level.tuning.solver == SolverKind::exact) return;
  std::vector<bool> moves(static_cast<std::size_t>(level.tile_count()));
  for (std::size_t tile = 0; tile < moves.size(); ++tile)
    moves[tile] = shape_of_tile(level, static_cast<TileNumber>(tile)).conveyor != 0;
  const std::vector<TileNumber>& cells = level.map.cells().tiles();
  const auto first = std::find_if(cells.begin(), cells.end(), [&](TileNumber tile) { return moves[tile]; });
  if (first == cells.end()) return;
  const auto at = static_cast<int>(first - cells.begin());
  report(out, kConveyorsNeedExact,
         "conveyors carry only bodies of the exact solver, but the level's solver is " +
             std::string(solver_name(level.tuning.solver)),
         Cell{at % level.map.width(), at / level.map.width()}, *first);
}

// Bodies meet with one solver alone, and shape, mass and friction of a kind count only where they meet.
void check_pairs(const Level& level, std::vector<Problem>& out) {
  const Tuning& tuning = level.tuning;
  if (tuning.shared.pairs() == BodyPairs::meet) {
    if (tuning.solver == SolverKind::exact) return;
    report(out, kNeedsMeet,
           "bodies meet only with the solver exact, but the level's solver is " +
               std::string(solver_name(tuning.solver)) + ", where they block one another");
    return;
  }
  const auto first = std::find_if(level.spawns.begin(), level.spawns.end(), [](const Spawn& spawn) {
    const BodyTraits& traits = traits_of(spawn.kind);
    return traits.friction > 0 || traits.shape != BodyShape::box;
  });
  if (first == level.spawns.end()) return;
  const int index = static_cast<int>(first - level.spawns.begin());
  report(out, kNeedsMeet,
         spawn_name(level, index) +
             " moves like a ball: bodies are round, are pushed and rub only with the solver exact and "
             "bodies that meet",
         nearest_cell(level.map, first->position), -1, index);
}

std::vector<Problem> ignored_ground_of(const Level& level, const GroundNames& names) {
  std::vector<Problem> problems;
  check_solver_of_curves(level, problems);
  check_tiles(level, names, problems);
  return problems;
}

void check_solver(const LintContext& context, std::vector<Problem>& out) {
  for (Problem& problem : ignored_ground_of(context.level, context.tiles.names()))
    out.push_back(std::move(problem));
  check_conveyors(context.level, out);
  check_pairs(context.level, out);
  const auto& left_out = context.tiles.names().problem();
  if (const auto problem = left_out ? left_out : ground_problem(context.level))
    report(out, kTooMuchGround, "the level " + *problem);
}

void fix_solver(const LintContext& context, const Problem&, std::vector<Edit>& out) {
  Tuning tuning = context.level.tuning;
  tuning.solver = SolverKind::exact;
  out.push_back(
      single_change("Choose the exact solver for this level", TuningChange{context.level.tuning, tuning}));
}

void fix_meet(const LintContext& context, const Problem&, std::vector<Edit>& out) {
  Tuning tuning = context.level.tuning;
  tuning.solver = SolverKind::exact;
  tuning.shared.bodies = static_cast<double>(BodyPairs::meet);
  const bool is_exact = context.level.tuning.solver == SolverKind::exact;
  out.push_back(single_change(is_exact ? "Let bodies meet" : "Choose the exact solver, and let bodies meet",
                              TuningChange{context.level.tuning, tuning}));
}

}  // namespace

std::vector<Problem> ignored_ground(const Level& level) { return ignored_ground_of(level, {}); }

const RuleGroup& solver_rules() {
  static constexpr const LintRule* kRules[] = {&kCurvesNeedExact, &kConveyorsNeedExact, &kNotInArticle,
                                               &kNotInBump,       &kNeedsMeet,          &kTooMuchGround};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_level = check_solver};
  return kGroup;
}

}  // namespace talus
