// The lists of overlays, rules and body kinds with one or two more rows each. They replace the program's own
// lists, which are compiled here under another name.
#include <initializer_list>
#include <vector>

#include <talus/level/body_kind.h>
#include "level/lint/rule_group.h"
#include "overlay/overlay_table.h"

#define all_overlays own_overlays
#define rule_groups own_rule_groups
#define body_kinds own_body_kinds
#include "level/body_kind_list.cpp"
#include "level/lint/rule_list.cpp"
#include "overlay/overlay_list.cpp"
#undef all_overlays
#undef rule_groups
#undef body_kinds

namespace talus {
namespace overlay {
extern const Overlay centres;
}
const RuleGroup& name_rules();

namespace {

template <class Row>
std::vector<Row> longer(std::span<const Row> rows, std::initializer_list<Row> more) {
  std::vector<Row> all(rows.begin(), rows.end());
  all.insert(all.end(), more);
  return all;
}

}  // namespace

std::span<const Overlay* const> all_overlays() {
  static const auto kAll = longer<const Overlay*>(own_overlays(), {&overlay::centres});
  return kAll;
}

std::span<const RuleGroup* const> rule_groups() {
  static const auto kAll = longer<const RuleGroup*>(own_rule_groups(), {&name_rules()});
  return kAll;
}

std::span<const BodyTraits> body_kinds() {
  static constexpr BodyTraits kBarrel{.word = "barrel",
                                      .help = "A barrel falls.",
                                      .size = {16, 12},
                                      .foot = Foot::centre,
                                      .ldtk_identifier = "Barrel",
                                      .ldtk_color = "#A0703C",
                                      .svg_color = "#a0703c"};
  static constexpr BodyTraits kRunner{.word = "runner",
                                      .help = "A runner runs by the keys.",
                                      .rule = BodyRule::run,
                                      .takes_keys = true,
                                      .size = {6, 12},
                                      .look = BodyLook::figure,
                                      .ldtk_identifier = "Runner",
                                      .ldtk_color = "#70A03C",
                                      .svg_color = "#70a03c"};
  static const auto kAll = longer<BodyTraits>(own_body_kinds(), {kBarrel, kRunner});
  return kAll;
}

}  // namespace talus
