// Asking for the ground's tiles.
#include "ground_hint.h"

namespace talus {

void ask_for_ground_tiles(Actions& actions, Ui& ui) {
  ui.view.wants_tab = "brushes";
  actions.push_back(action::ShowMessage{
      "The level has no tiles for ground yet: under Brushes, choose one for the inside, or propose them from "
      "the sheet.",
      true});
}

}  // namespace talus
