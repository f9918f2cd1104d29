#include "export_as.h"

#include "edit/export_presets.h"
#include "export/preset_clash.h"

namespace talus {

void export_as(const Exporter& exporter, const Session& session, Actions& actions) {
  const std::vector<ExportPreset>& presets = session.level().exports;
  const auto known = find_export(session.level(), exporter.id);
  if (!known) {
    if (presets.size() >= kMaxExports)
      return actions.push_back(action::ShowMessage{
          "The level has as many presets of exports as it can have: delete one in the window of exports.",
          true});
    const ExportPreset preset = with_target({}, exporter, presets, session.file_name(), session.path());
    actions.push_back(action::EditLevel{add_export(session.level(), preset)});
    actions.push_back(action::SetExportPath{presets.size(), preset.path});
  }
  actions.push_back(action::RunExports{known.value_or(presets.size())});
}

}  // namespace talus
