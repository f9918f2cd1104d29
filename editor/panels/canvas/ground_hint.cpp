// Asks for the ground's tiles.
#include "ground_hint.h"

#include "panels/panel_ids.h"

namespace talus {

void ask_for_ground_tiles(Actions& actions, Ui& ui) {
  ui.ask(request::ShowTab(panel_id::kBrushes));
  actions.push_back(action::ShowMessage{
      "The level has no tiles for ground yet: under Brushes, choose one for the inside, or propose them from "
      "the sheet.",
      true});
}

}  // namespace talus
