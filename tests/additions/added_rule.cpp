// A rule of the lint added as docs/adding.md says: its row, its search and its fix.
#include "level/lint/rule_group.h"
#include "level/single_change.h"

namespace talus {
namespace {

LintFix fix_name;

constexpr LintRule kUnnamed{.code = "spawn-unnamed",
                            .label = "body without a name",
                            .by_hand = "Give the body a name in the inspector.",
                            .fix = fix_name};

void check_names(const LintContext& context, std::vector<Problem>& out) {
  for (int i = 0; i < static_cast<int>(context.level.spawns.size()); ++i) {
    if (context.level.spawns[static_cast<std::size_t>(i)].name.empty())
      report(out, kUnnamed, "body " + std::to_string(i + 1) + " has no name", {}, -1, i);
  }
}

void fix_name(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  Spawn spawn = context.level.spawns[static_cast<std::size_t>(problem.object)];
  spawn.name = "somebody";
  out.push_back(change_spawn(context.level, problem.object, spawn, "Name a body"));
}

}  // namespace

const RuleGroup& name_rules() {
  static constexpr const LintRule* kRules[] = {&kUnnamed};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_level = check_names};
  return kGroup;
}

}  // namespace talus
