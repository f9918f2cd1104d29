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
      {.id = "file/export",
       .label = "Export...",
       .help = "Shows what the level is exported to, what will be written, and how large it is.",
       .key = ctrl_shift('x'),
       .menu = menus::kFileExport,
       .run = toggle<&View::files, &FilesView::exports, &ExportView::open>,
       .checked = is_on<&View::files, &FilesView::exports, &ExportView::open>},
      {.id = "file/export_all",
       .label = "Export all again",
       .help = "Writes all presets of the level; if there are none, opens the window where they are made.",
       .key = ctrl_shift('w'),
       .menu = menus::kFileExport,
       .run =
           [](S session, A actions, U ui) {
             if (session.level().exports.empty())
               ui.view.files.exports.open = true;
             else
               actions.push_back(action::RunExports{});
           },
       .words = "build publish"},
      {.id = "file/export_cancel",
       .label = "Cancel the export",
       .help = "Ends the export, or the preview of one. Files that were not written yet stay "
               "as they "
               "were.",
       .run = emit<action::CancelExport>,
       .enabled =
           [](S session, const Ui&) {
             return session.exporting().running() || session.exporting().previewing();
           }},
  };
}

}  // namespace talus
