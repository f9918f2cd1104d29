// The commands of exports.
#include "command_table.h"

namespace talus {
namespace {

using S = const Session&;
using A = Actions&;
using U = Ui&;

}  // namespace

std::vector<Command> export_commands() {
  return {
      toggle(
          "file/export", ctrl_shift('x'), "Export...",
          "Shows what the level is exported to, what will be written, and how large it is.",
          [](S, A, U ui) { ui.view.exports.open = !ui.view.exports.open; },
          [](S, const Ui& ui) { return ui.view.exports.open; }),
      also_called(
          "build publish",
          command("file/export_all", ctrl_shift('w'), "Export all again",
                  "Writes all presets of the level as it is now; without any, shows where they are made.",
                  [](S session, A actions, U ui) {
                    if (session.level().exports.empty())
                      ui.view.exports.open = true;
                    else
                      actions.push_back(action::RunExports{});
                  })),
      command("file/export_cancel", {}, "Cancel the export",
              "Ends the export, or the preview of one, within a moment. What has not been written yet stays "
              "as it "
              "was.",
              emit<action::CancelExport>,
              [](S session, const Ui&) {
                return session.exporting().running() || session.exporting().previewing();
              }),
  };
}

}  // namespace talus
