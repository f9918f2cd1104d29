// Finds flags that contradict each other, that have two meanings, or that change nothing.
#include "../level_text.h"
#include "fix_parts.h"
#include "rule_group.h"

namespace talus {
namespace {

LintFix fix_conflict, fix_idle_flag, fix_shared_flag;

constexpr LintRule kConflict{.code = "flags-conflict",
                             .label = "flags that contradict each other",
                             .by_hand = "Clear all but one of these flags in the flags panel.",
                             .severity = Severity::error,
                             .fix = fix_conflict};
constexpr LintRule kIdle{.code = "flag-idle",
                         .label = "flag that changes nothing",
                         .by_hand = "Clear the flag in the flags panel, or give the tile a shape.",
                         .fix = fix_idle_flag};
constexpr LintRule kShared{.code = "shared-flag",
                           .label = "flag with two meanings",
                           .by_hand = "Give one of the two meanings another flag in the flags panel.",
                           .severity = Severity::error,
                           .fix = fix_shared_flag};

void check_flags(const LintContext& context, int tile, std::vector<Problem>& out) {
  const Level& level = context.level;
  const FlagSet flags = level.tile_flags(static_cast<TileNumber>(tile));
  std::string labels;
  int count = 0, last_flag = FlagRoles::kUnused;
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = level.roles.*info.flag;
    if (!has_flag(flags, flag) || flag == last_flag || info.role == TileRole::none) continue;
    labels += (count == 0 ? "" : " and ") + std::string(info.label);
    last_flag = flag;
    ++count;
  }
  if (count > 1) {
    report(out, kConflict,
           context.tiles.text_of(tile) + " has the flags of " + labels + "; only the first, " +
               role_label(context.tiles[static_cast<std::size_t>(tile)].role) + ", counts",
           {}, tile);
  }
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const bool set = info.role == TileRole::none && has_flag(flags, level.roles.*info.flag);
    if (set && context.tiles.shape(tile).kind == TileShape::Kind::none) {
      report(out, kIdle,
             context.tiles.text_of(tile) + " has the flag of " + std::string(info.label) +
                 ", which changes nothing: it has no shape",
             {}, tile);
    }
  }
}

void check_roles(const LintContext& context, std::vector<Problem>& out) {
  const FlagRoles& roles = context.level.roles;
  const auto& infos = flag_role_infos();
  for (std::size_t i = 0; i < infos.size(); ++i) {
    for (std::size_t j = i + 1; j < infos.size(); ++j) {
      const int flag = roles.*infos[i].flag;
      if (flag == FlagRoles::kUnused || flag != roles.*infos[j].flag) continue;
      report(out, kShared,
             "flag " + std::to_string(flag) + " stands for both " + std::string(infos[i].label) + " and " +
                 std::string(infos[j].label),
             {}, -1, static_cast<int>(j));
    }
  }
}

void fix_conflict(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const auto tile = static_cast<TileNumber>(problem.tile);
  const TileRole kept = context.tiles[tile].role;
  FlagSet flags = level.tile_flags(tile);
  int kept_flag = FlagRoles::kUnused;
  std::string labels;
  for (const FlagRoleInfo& info : flag_role_infos()) {
    if (info.role == kept && kept_flag == FlagRoles::kUnused) kept_flag = level.roles.*info.flag;
  }
  for (const FlagRoleInfo& info : flag_role_infos()) {
    const int flag = level.roles.*info.flag;
    if (info.role == TileRole::none || flag == kept_flag) continue;
    if (!has_flag(flags, flag)) continue;
    flags &= ~flag_bit(flag);
    labels += (labels.empty() ? "" : " and ") + std::string(info.label);
  }
  out.push_back(change_flags(level, tile, flags,
                             "Clear the " + labels + " flag of " + tile_text(tile) + ", which is " +
                                 role_label(kept) + " as before"));
}

void fix_idle_flag(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const auto tile = static_cast<TileNumber>(problem.tile);
  FlagSet flags = level.tile_flags(tile);
  for (const int flag : {level.roles.one_way, level.roles.ceiling}) {
    if (flag != FlagRoles::kUnused) flags &= ~flag_bit(flag);
  }
  out.push_back(
      change_flags(level, tile, flags, "Clear the flags of " + tile_text(tile) + " that change nothing"));
}

void fix_shared_flag(const LintContext& context, const Problem& problem, std::vector<Edit>& out) {
  const Level& level = context.level;
  const FlagRoleInfo& second = flag_role_infos()[static_cast<std::size_t>(problem.object)];
  const int flag = level.roles.*second.flag;
  FlagRoles roles = level.roles;
  roles.*second.flag = FlagRoles::kUnused;
  out.push_back(
      single_change("Let flag " + std::to_string(flag) + " no longer stand for " + std::string(second.label),
                    RolesChange{level.roles, roles}));
}

}  // namespace

const RuleGroup& flag_rules() {
  static constexpr const LintRule* kRules[] = {&kConflict, &kIdle, &kShared};
  static constexpr RuleGroup kGroup{.rules = kRules, .check_tile = check_flags, .check_level = check_roles};
  return kGroup;
}

}  // namespace talus
