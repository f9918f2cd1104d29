// Presets at the left, the chosen one at the right.
#include "export_panel.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "edit/export_presets.h"
#include "export/lua_parts.h"
#include "export/preset_clash.h"
#include "export_as.h"
#include "export_preview.h"
#include "panels/commands/commands.h"
#include "panels/ui/dialog.h"
#include "panels/ui/floating_window.h"
#include "panels/ui/fuzzy_match.h"
#include "panels/ui/text_focus.h"

namespace talus {
namespace {

constexpr float kExportWidth = 800, kExportHeight = 480;  // px at scale 1
constexpr float kPresetList = 208, kExportLabels = 60, kBrowse = 80;

void push_export_edit(Edit edit, Actions& actions) {
  if (!edit.empty()) actions.push_back(action::EditLevel{std::move(edit)});
}

const ExportPreset& chosen_preset(const Session& session, const Ui& ui) {
  return session.level().exports[ui.view.files.exports.preset];
}

// Its label with a capital; in sentences it has none.
std::string exporter_title(const Exporter& exporter) { return capitalized(exporter.label); }

std::string target_label(const std::string& id) {
  const Exporter* exporter = find_exporter(id);
  return exporter != nullptr ? exporter_title(*exporter) : id.empty() ? "No target" : "Unknown: " + id;
}

// Most users want a game that they can start, so it comes first.
const Exporter& first_target() {
  const auto all = exporters();
  const auto folder = std::find_if(all.begin(), all.end(), [](const Exporter& e) { return e.is_folder(); });
  return folder != all.end() ? *folder : all.front();
}

// The targets that fit the typed text, the best ones first.
std::vector<const Exporter*> matching_targets(const std::string& typed) {
  std::vector<std::pair<int, const Exporter*>> scored;
  for (const Exporter& exporter : exporters()) {
    const std::string text = std::string(exporter.label) + " " + std::string(exporter.id);
    if (const auto score = fuzzy_score(text, typed))
      scored.emplace_back(typed.empty() ? 0 : -*score, &exporter);
  }
  std::stable_sort(scored.begin(), scored.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Exporter*> found;
  found.reserve(scored.size());
  for (const auto& entry : scored) found.push_back(entry.second);
  return found;
}

void field_label(const char* label, Ui& ui) {
  ImGui::AlignTextToFramePadding();
  draw_text(label);
  ImGui::SameLine(ui.px(kExportLabels));
}

// One line of text up to the window's right side, with "..." if it does not fit.
void draw_short(const std::string& text, ImVec2 at, std::uint32_t color) {
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  add_short_text(*ImGui::GetWindowDrawList(), at, right, theme::tone(color), text);
}

// A field that shows `now`, and keeps the typed text until the field is left. Returns true if the text
// differs then.
bool text_field(const char* widget, const char* hint, std::string& typed, const std::string& now,
                const std::string& help, Ui& ui) {
  take_text_focus(widget, ui);
  input_text(widget, hint, typed);
  const bool changed = ImGui::IsItemDeactivatedAfterEdit() && typed != now;
  const bool active = ImGui::IsItemActive();
  ui.item(widget, help);
  if (typed.size() > kMaxExportText) typed.resize(kMaxExportText);
  if (!active && !changed) typed = now;
  return changed;
}

// A field for a text of the chosen preset.
struct PresetText {
  const char* widget;
  const char* hint;
  std::string help;
  std::string ExportPreset::*member;
  const char* edit;  // label of the change
};

void draw_preset_text(const PresetText& text, std::string& typed, const Session& session, Actions& actions,
                      Ui& ui) {
  ExportPreset preset = chosen_preset(session, ui);
  ImGui::SetNextItemWidth(-1);
  if (!text_field(text.widget, text.hint, typed, preset.*text.member, text.help, ui)) return;
  preset.*text.member = typed;
  push_export_edit(set_export(session.level(), ui.view.files.exports.preset, std::move(preset), text.edit),
                   actions);
}

// All presets except this one.
std::vector<ExportPreset> other_presets(const Session& session, std::size_t index) {
  std::vector<ExportPreset> others = session.level().exports;
  if (index < others.size()) others.erase(others.begin() + static_cast<std::ptrdiff_t>(index));
  return others;
}

ExportPreset new_preset(const Session& session) {
  return with_target({}, first_target(), session.level().exports, session.file_name(), session.path());
}

// A copy that would write the same files gets a path of its own.
ExportPreset copied_preset(const Session& session, ExportPreset copy) {
  copy.name = free_export_name(session.level(), copy.name);
  if (const Exporter* exporter = find_exporter(copy.exporter))
    copy.path = free_path_like(copy, *exporter, session.level().exports, session.path());
  return copy;
}

}  // namespace

void ExportPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  ExportView& view = ui.view.files.exports;
  if (!view.open) return;
  const std::size_t count = session.level().exports.size();
  view.preset = count == 0 ? 0 : std::min(view.preset, count - 1);
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (begin_floating_window({.title = "Export",
                             .open = &view.open,
                             .size = {std::min(ui.px(kExportWidth), window.x - ui.px(32)),
                                      std::min(ui.px(kExportHeight), window.y - ui.px(64))},
                             .least = {ui.px(560), ui.px(360)}})) {
    ImGui::BeginChild("presets", {ui.px(kPresetList), 0}, false, ImGuiWindowFlags_NavFlattened);
    draw_presets(session, actions, ui);
    ImGui::EndChild();
    ImGui::SameLine(0, ui.px(12));
    ImGui::BeginChild("preset", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
    if (count > 0)
      draw_preset(session, actions, ui);
    else
      draw_first_targets(session, actions, ui);
    ImGui::EndChild();
    ui.place("export/window", ImGui::GetWindowPos(),
             {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
              ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  }
  ImGui::End();
  if (view.preset >= count) return;  // it was added in this frame
  const ExportTask task = session.export_task(view.preset);
  if (!session.exporting().previews(session.revision(), task) && session.exporting().takes_preview(task))
    actions.push_back(action::PreviewExport{view.preset});
}

// All that a level without presets needs is a click.
void ExportPanel::draw_first_targets(const Session& session, Actions& actions, Ui& ui) {
  ui.heading("Export for");
  ui.hint(
      "A click writes it into the folder of the level, and keeps that as a preset, which Export writes "
      "again, "
      "and `talus export FILE --all` in a build script.");
  ImGui::Spacing();
  ImGui::BeginChild("targets", {0, 0}, false, ImGuiWindowFlags_NavFlattened);
  for (const Exporter& exporter : exporters()) {
    if (selectable(exporter_title(exporter), exporter.id, false)) export_as(exporter, session, actions);
    ui.item("export/first/" + std::string(exporter.id), exporter.purpose);
  }
  ImGui::EndChild();
}

void ExportPanel::draw_presets(const Session& session, Actions& actions, Ui& ui) {
  ui.heading("Presets of the level");
  const std::vector<ExportPreset>& exports = session.level().exports;
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::BeginChild("list", {0, -(2 * ui.px(theme::kButton) + ui.px(12))}, true);
  const float line = ImGui::GetTextLineHeight();
  for (std::size_t i = 0; i < exports.size(); ++i) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable("##preset", i == ui.view.files.exports.preset, 0, {0, 2 * line}))
      ui.view.files.exports.preset = i;
    ui.item("export/preset" + std::to_string(i),
            exports[i].name + ": " + target_label(exports[i].exporter) + ", to " + exports[i].path);
    ImGui::PopID();
    const std::string name = exports[i].name.empty() ? "(no name)" : exports[i].name;
    const std::string target = (exports[i].on_save ? "On save: " : "") + target_label(exports[i].exporter);
    const bool is_known = find_exporter(exports[i].exporter) != nullptr;
    draw_short(name, at, theme::kText);
    draw_short(target, {at.x, at.y + line}, is_known ? theme::kMuted : theme::kError);
  }
  if (exports.empty()) ui.hint("None yet.");
  ImGui::EndChild();
  ImGui::PopStyleVar();
  draw_preset_buttons(session, actions, ui);
}

// Tooltips of the buttons stand above all of them, not over the next one.
void ExportPanel::draw_preset_buttons(const Session& session, Actions& actions, Ui& ui) {
  const float bars_top = std::exchange(ui.bars_top, ImGui::GetCursorScreenPos().y);
  const Level& level = session.level();
  const bool has_one = !level.exports.empty(), has_room = level.exports.size() < kMaxExports;
  const std::size_t chosen = ui.view.files.exports.preset;  // several buttons may be pressed in one frame
  const float gap = ImGui::GetStyle().ItemSpacing.x, width = (ImGui::GetContentRegionAvail().x - 2 * gap) / 3;
  const auto add = [&](ExportPreset preset) {
    push_export_edit(add_export(level, std::move(preset)), actions);
    ui.view.files.exports.preset = level.exports.size();  // it comes after this frame
  };
  if (ui.text_button("export/add", "Add", !has_one, "Adds a preset.", {}, has_room, width))
    add(new_preset(session));
  ImGui::SameLine();
  if (ui.text_button("export/duplicate", "Copy", false, "Adds a preset like the chosen one.", {},
                     has_one && has_room, width)) {
    add(copied_preset(session, level.exports[chosen]));
  }
  ImGui::SameLine();
  if (ui.text_button("export/remove", "Remove", false,
                     "Removes the preset, but not the files that it wrote; Undo brings it back.", {}, has_one,
                     width))
    push_export_edit(remove_export(level, chosen), actions);
  command_text_button("file/export_all"_command, session, actions, ui,
                      {.label = "Export all",
                       .widget = "export/all",
                       .enabled = has_one && !session.exporting().running(),
                       .width = ImGui::GetContentRegionAvail().x});
  ui.bars_top = bars_top;
}

void ExportPanel::draw_preset(const Session& session, Actions& actions, Ui& ui) {
  if (ui.view.files.exports.preset >= session.level().exports.size())
    return;  // added or removed in this frame
  ui.begin_row();
  draw_name(session, actions, ui);
  draw_target(session, actions, ui);
  draw_path(session, actions, ui);
  draw_parts(session, actions, ui);
  ImGui::SetCursorPosX(ui.px(kExportLabels));
  ExportPreset preset = chosen_preset(session, ui);
  if (ImGui::Checkbox("Export it whenever the level is saved", &preset.on_save))
    push_export_edit(set_export(session.level(), ui.view.files.exports.preset, preset, "Export on save"),
                     actions);
  ui.item("export/on_save", "Saving writes this preset, too.", keys_of("file/save"_command, ui));
  if (!session.allows_export(ui.view.files.exports.preset)) {
    ImGui::SetCursorPosX(ui.px(kExportLabels));
    ui.hint("It came with the file, and writes nothing until you allow it. Export asks.");
    ui.item("export/not_allowed");
  }
  ui.end_row();
  ImGui::Spacing();
  const float line = ImGui::GetTextLineHeightWithSpacing();
  draw_export_files(session, 3 * line + ui.px(theme::kButton) + ui.px(8), ui);
  const float bottom = ImGui::GetWindowHeight() - ui.px(theme::kButton);
  draw_export_notes(session, ui);
  ImGui::SetCursorPosY(bottom);
  draw_export_buttons(session, actions, ui);
}

void ExportPanel::draw_parts(const Session& session, Actions& actions, Ui& ui) {
  const Exporter* exporter = find_exporter(chosen_preset(session, ui).exporter);
  if (exporter == nullptr || !exporter->takes_parts) return;
  field_label("Parts", ui);
  draw_preset_text({"export/parts", "what the game adds while it runs: players, pairs ...",
                    "Parts of the runtime besides those that the level uses, with commas between: " +
                        lua_part_names() + ".",
                    &ExportPreset::parts, "Change export parts"},
                   parts_, session, actions, ui);
}

void ExportPanel::draw_name(const Session& session, Actions& actions, Ui& ui) {
  field_label("Name", ui);
  draw_preset_text({"export/name", "a name, for you and for build scripts",
                    "What the preset is called: `talus export FILE --preset NAME` writes it.",
                    &ExportPreset::name, "Rename export preset"},
                   name_, session, actions, ui);
}

void ExportPanel::draw_target(const Session& session, Actions& actions, Ui& ui) {
  const ExportPreset& preset = chosen_preset(session, ui);
  field_label("Target", ui);
  if (ui.begin_combo("export/target", target_label(preset.exporter), ImGui::GetContentRegionAvail().x,
                     "What is written: type in the list to find one.")) {
    draw_target_choice(session, actions, ui);
    ImGui::EndCombo();
  }
  const Exporter* exporter = find_exporter(preset.exporter);
  ImGui::SetCursorPosX(ui.px(kExportLabels));
  ImGui::BeginGroup();
  if (exporter == nullptr)
    draw_export_problem(ExportProblem::Field::target, session, ui);
  else if (!exporter->purpose.empty())
    ui.hint(exporter->purpose);
  ImGui::EndGroup();
}

void ExportPanel::draw_target_choice(const Session& session, Actions& actions, Ui& ui) {
  if (ImGui::IsWindowAppearing()) {
    target_.clear();
    ImGui::SetKeyboardFocusHere();
  }
  ImGui::SetNextItemWidth(-1);
  input_text("find", "type a few letters", target_);
  ui.item("export/find_target");
  const ExportPreset& preset = chosen_preset(session, ui);
  const auto found = matching_targets(target_);
  const Exporter* taken = key_pressed(ImGuiKey_Enter) && !found.empty() ? found.front() : nullptr;
  if (found.empty()) ui.hint("No target has these letters in its name.");
  for (const Exporter* exporter : found) {
    if (selectable(exporter_title(*exporter), {}, preset.exporter == exporter->id)) taken = exporter;
    ui.item("export/target/" + std::string(exporter->id), exporter->purpose);
  }
  if (taken != nullptr)
    push_export_edit(
        set_export(session.level(), ui.view.files.exports.preset,
                   with_target(preset, *taken, other_presets(session, ui.view.files.exports.preset),
                               session.file_name(), session.path()),
                   "Change export target"),
        actions);
  if (taken != nullptr || key_pressed(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
}

void ExportPanel::draw_path(const Session& session, Actions& actions, Ui& ui) {
  const ExportPreset& preset = chosen_preset(session, ui);
  field_label("Path", ui);
  ImGui::SetNextItemWidth(-ui.px(kBrowse) - ImGui::GetStyle().ItemSpacing.x);
  if (text_field("export/path", "a file or folder, from the folder of the level", path_, preset.path,
                 "Where it is written, relative to the folder of the level's file.", ui)) {
    actions.push_back(action::SetExportPath{ui.view.files.exports.preset, path_});
  }
  ImGui::SameLine();
  if (ui.text_button("export/browse", "Browse...", false, "Chooses the file or folder.", {},
                     find_exporter(preset.exporter) != nullptr, ui.px(kBrowse)))
    ui.ask(request::ShowFileDialog{FileDialog::export_path});
  ImGui::SetCursorPosX(ui.px(kExportLabels));
  ImGui::BeginGroup();
  const ExportOutcome* outcome = shown_outcome(session, ui);
  if (draw_export_problem(ExportProblem::Field::path, session, ui)) {
    if (outcome != nullptr && outcome->problem && outcome->problem->is_outside && !session.path().empty() &&
        ui.text_button("export/allow_place", "Allow this place", false,
                       "Lets this preset write there, although it is outside of the folder of the level."))
      actions.push_back(action::SetExportPath{ui.view.files.exports.preset, preset.path});
    if (session.path().empty() && ui.text_button("export/save", "Save the level...", false,
                                                 "Gives the level a file.", keys_of("file/save"_command, ui)))
      actions.push_back(action::SaveFile{});
  } else {
    ui.hint(outcome != nullptr ? outcome->output : "");
    ui.item("export/output", "The whole path of that place.");
  }
  ImGui::EndGroup();
}

}  // namespace talus
