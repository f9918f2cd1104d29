// Finds and removes the chosen curve.
#include "chosen_curve.h"

#include "edit/curve_tools.h"

namespace talus {

int chosen_curve(const Session& session) {
  const int chosen = session.choices().curve;
  const Level& level = session.level();
  if (chosen < 0 || chosen >= static_cast<int>(level.curves.size())) return -1;
  return problem_of(level.curves[static_cast<std::size_t>(chosen)].curve, level.map) ? -1 : chosen;
}

void delete_curve(const Session& session, Actions& actions, const Ui& ui) {
  constexpr double kReach = 4;  // px
  const auto at = ui.view.canvas.hover.pixel;
  int curve = at ? curve_at(session.level(), *at, kReach) : -1;
  if (curve < 0) curve = chosen_curve(session);
  if (curve < 0) return;
  actions.push_back(action::EditLevel{remove_curve(session.level(), curve)});
  actions.push_back(action::SelectCurve{});
}

}  // namespace talus
