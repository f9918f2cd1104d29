#include "body_hint.h"

#include "commands.h"

namespace talus {

void draw_body_hint(std::string_view purpose, const std::string& widget, const Session& session,
                    Actions& actions, Ui& ui) {
  ui.hint("No body chosen: click one with the hand" + std::string(purpose) + ".");
  if (find_command("play/choose_player"_command).is_enabled(session, ui))
    command_text_button("play/choose_player"_command, session, actions, ui,
                        {.widget = widget + "/choose_player"});
  if (ui.view.canvas.paint_in_play)
    command_text_button("canvas/paint_in_play"_command, session, actions, ui, {.widget = widget + "/hand"});
}

}  // namespace talus
