#include "exact_hint.h"

#include "edit/level_settings.h"

namespace talus {

void draw_exact_hint(std::string_view sentence, const std::string& widget, const Session& session,
                     Actions& actions, Ui& ui) {
  Tuning tuning = session.level().tuning;
  if (tuning.solver == SolverKind::exact) return;
  ui.hint(sentence);
  tuning.solver = SolverKind::exact;
  if (ui.text_button(widget, "Use the exact solver", false, "Chooses it for the level, as Tuning does."))
    actions.push_back(action::EditLevel{set_tuning(session.level(), tuning)});
}

}  // namespace talus
