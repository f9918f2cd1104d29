// The tools and the selection.
#include "selection_hint.h"

namespace talus {

bool meets_selection(const Session& session, Actions& actions, CellRect cells) {
  const auto& selection = session.choices().selection;
  if (!selection || shared(*selection, cells)) return true;
  actions.push_back(
      action::ShowMessage{"The tools stay inside the selection: draw there, or select nothing first."});
  return false;
}

}  // namespace talus
