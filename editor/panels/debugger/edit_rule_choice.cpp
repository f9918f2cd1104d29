#include "edit_rule_choice.h"

#include <string>

#include "panels/commands/commands.h"

namespace talus {
namespace {

std::string short_rule(const EditRule& rule) {
  if (rule.kind == EditRule::Kind::go_on) return "after edits: play on";
  return "after edits: rerun from " +
         std::to_string(rule.kind == EditRule::Kind::from_frame ? rule.frame : 0);
}

}  // namespace

void draw_edit_rule_choice(const Session& session, Actions& actions, Ui& ui) {
  using Kind = EditRule::Kind;
  const EditRule now = session.edit_rule();
  if (!ui.begin_combo("timeline/edit_rule", short_rule(now), ui.px(kEditRuleWidth),
                      "What happens to the recording when the level is edited: it goes on from the shown "
                      "frame on the edited level, or all of it is run again there.",
                      keys_of("timeline/edit_rule"_command, ui)))
    return;
  const std::int64_t frame = now.kind == Kind::from_frame ? now.frame : session.state().frame;
  const auto choice = [&](EditRule rule, const std::string& label, const char* name) {
    if (selectable(label, {}, rule.kind == now.kind)) actions.push_back(action::SetEditRule{rule});
    ui.item(std::string("timeline/rule_") + name);
  };
  choice({Kind::go_on, 0}, "Go on from the shown frame", "go_on");
  choice({Kind::from_start, 0}, "Run the recording again from frame 0", "from_start");
  choice({Kind::from_frame, frame}, "Run it again from frame " + std::to_string(frame), "from_frame");
  ImGui::EndCombo();
}

}  // namespace talus
