// The rules of the lint, in the order in which the panel lists them.
#include "rule_group.h"

namespace talus {

// Each function is at the end of the file of its name.
const RuleGroup& slope_rules();
const RuleGroup& seam_rules();
const RuleGroup& gap_rules();
const RuleGroup& flag_rules();
const RuleGroup& shape_rules();
const RuleGroup& spawn_rules();
const RuleGroup& curve_rules();
const RuleGroup& solver_rules();
const RuleGroup& layer_rules();

std::span<const RuleGroup* const> rule_groups() {
  static const std::array kGroups = {&slope_rules(), &seam_rules(),   &gap_rules(),
                                     &flag_rules(),  &shape_rules(),  &spawn_rules(),
                                     &curve_rules(), &solver_rules(), &layer_rules()};
  return kGroups;
}

}  // namespace talus
