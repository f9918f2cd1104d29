// Files in a table, sentences and buttons.
#include "export_preview.h"

#include <algorithm>
#include <cstdio>

#include "panels/commands/commands.h"
#include "panels/ui/copy_all.h"

namespace talus {
namespace {

using Place = PlannedFile::Place;

constexpr float kMaxNoteLines = 3;                     // lines of notes beside the files before they scroll
constexpr float kSizeColumn = 84, kPlaceColumn = 210;  // px at scale 1

std::string code_text(std::size_t bytes) {
  const std::string sizes = size_text(bytes) + " of the " + size_text(kMaxTicCode);
  return bytes > kMaxTicCode ? "Too large for TIC-80's free version: its code has " + sizes +
                                   " that are allowed. Use fewer shapes or kinds of bodies."
                             : "Code: " + sizes + " of TIC-80's free version.";
}

// The problem of the shown preset in the last run, if the preset has not changed since.
const ExportOutcome* failed_outcome(const Session& session, const Ui& ui) {
  const ExportTask task = session.export_task(ui.view.files.exports.preset);
  for (const ExportOutcome& outcome : session.exporting().last_run()) {
    if (outcome.problem && outcome.task == task) return &outcome;
  }
  return nullptr;
}

std::string sentence(const FormatError& error) {
  return (error.place.empty() ? capitalized(error.message) : error.place + ": " + error.message) + ".";
}

void draw_file(const PlannedFile& file, const ExportOutcome& outcome, Ui& ui) {
  const bool is_foreign = outcome.foreign.contains(file.path);
  const std::string old = size_text(static_cast<std::size_t>(file.old_size));
  const std::string place = outcome.output.empty()       ? ""
                            : file.place == Place::empty ? "new"
                            : file.place == Place::same  ? "unchanged"
                            : is_foreign                 ? "replaces yours, " + old
                                                         : "replaces " + old;
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_text(file.name);
  ui.item("export/file/" + file.name, file.path);
  ImGui::TableNextColumn();
  ui.right_aligned(size_text(file.size));
  ui.tooltip(std::to_string(file.size) + " bytes");
  ImGui::TableNextColumn();
  const std::uint32_t color = is_foreign                   ? theme::kWarning
                              : file.place == Place::empty ? theme::kAccent
                                                           : theme::kMuted;
  ImGui::PushStyleColor(ImGuiCol_Text, theme::tone(color));
  draw_text(place);
  ImGui::PopStyleColor();
  if (is_foreign) ui.tooltip("The file there is not an export, or was changed since. Exporting asks first.");
}

void draw_kept_file(const PlannedFile& file, Ui& ui) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_text(file.name);
  ui.item("export/file/" + file.name, file.path);
  ImGui::TableNextColumn();
  ui.right_aligned(size_text(static_cast<std::size_t>(file.old_size)));
  ImGui::TableNextColumn();
  ui.hint("kept: this file is yours now");
  ui.tooltip(
      "Exports begin this file, and it is yours to change. Delete it, and the next export begins it anew.");
}

void draw_file_table(const ExportOutcome* outcome, bool is_cancelled, Ui& ui) {
  if (outcome == nullptr)
    return ui.hint(is_cancelled ? "The preview was cancelled. Preview below makes one, Export needs none."
                                : "Making the files, to see how large they are...");
  if (outcome->files.empty()) return ui.hint("No files, as long as there is the error above.");
  if (!ImGui::BeginTable("table", 3, ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("file");
  ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, ui.px(kSizeColumn));
  ImGui::TableSetupColumn("place", ImGuiTableColumnFlags_WidthFixed, ui.px(kPlaceColumn));
  for (const PlannedFile& file : outcome->kept) draw_kept_file(file, ui);
  for (const PlannedFile& file : outcome->files) draw_file(file, *outcome, ui);
  ImGui::EndTable();
}

// "Export 3 files, 44.2 KB"
std::string export_label(const ExportOutcome* outcome) {
  if (outcome == nullptr || outcome->files.empty()) return "Export";
  std::size_t bytes = 0;
  for (const PlannedFile& file : outcome->files) bytes += file.size;
  const std::size_t count = outcome->files.size();
  return "Export " + std::to_string(count) + (count == 1 ? " file, " : " files, ") + size_text(bytes) +
         (outcome->foreign.empty() ? "" : "...");
}

std::string progress_text(const ExportProgress& progress) {
  std::string text = progress.name;
  if (progress.tasks > 1)
    text += " (" + std::to_string(progress.task + 1) + " of " + std::to_string(progress.tasks) + ")";
  if (progress.files == 0)
    return text + ": making the files, " + std::to_string(static_cast<int>(progress.share * 100)) + " %";
  return text + ": " + std::to_string(progress.files_done) + " of " + std::to_string(progress.files) +
         " files, " + size_text(progress.bytes_done) + " of " + size_text(progress.bytes);
}

// A bar with a text, and the button that ends the work.
void draw_progress_row(const char* widget, const std::string& text, double share, const Session& session,
                       Actions& actions, Ui& ui) {
  const float button = ui.px(88), width = ImGui::GetContentRegionAvail().x - button - ui.px(8);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = ui.px(theme::kButton);
  const float done = static_cast<float>(share) * width;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, theme::tone(theme::kControl));
  list.AddRectFilled(at, {at.x + done, at.y + height}, theme::tone(theme::kAccent, 110));
  list.PushClipRect(at, {at.x + width, at.y + height}, true);
  add_text(list, {at.x + ui.px(8), at.y + (height - ImGui::GetTextLineHeight()) / 2},
           theme::tone(theme::kText), text);
  list.PopClipRect();
  ImGui::Dummy({width, height});
  ui.item(widget, text);
  ImGui::SameLine(0, ui.px(8));
  command_text_button("file/export_cancel"_command, session, actions, ui,
                      {.label = "Cancel", .widget = "export/cancel", .width = button});
}

// The progress of a preview that takes long; for a shorter one the bar would flicker.
std::optional<ExportProgress> long_preview(const Session& session) {
  constexpr double kLong = 0.25;  // seconds
  const auto progress = session.exporting().preview_progress();
  return progress && progress->seconds > kLong ? progress : std::nullopt;
}

// Beside the export button: the progress of a preview, or how to get one.
void draw_preview_progress(const std::optional<ExportProgress>& progress, const Session& session,
                           Actions& actions, Ui& ui) {
  if (progress) {
    ImGui::SameLine(0, ui.px(8));
    draw_progress_row("export/preview_progress",
                      "Preview: " + std::to_string(static_cast<int>(progress->share * 100)) + " %",
                      progress->share, session, actions, ui);
  } else if (session.exporting().preview_cancelled()) {
    ImGui::SameLine(0, ui.px(8));
    if (ui.text_button("export/preview_again", "Preview", false,
                       "Makes the files after all, to see how large they are.", {}, true, ui.px(88)))
      actions.push_back(action::PreviewExport{ui.view.files.exports.preset});
  }
}

}  // namespace

std::string size_text(std::size_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + (bytes == 1 ? " byte" : " bytes");
  const double kilobytes = static_cast<double>(bytes) / 1024;
  char text[32];
  if (kilobytes < 1000)
    std::snprintf(text, sizeof text, "%.1f KB", kilobytes);
  else
    std::snprintf(text, sizeof text, "%.1f MB", kilobytes / 1024);
  return text;
}

const ExportOutcome* shown_outcome(const Session& session, const Ui& ui) {
  const auto& preview = session.exporting().preview();
  const ExportTask task = session.export_task(ui.view.files.exports.preset);
  return preview && preview->outcome.task == task ? &preview->outcome : nullptr;
}

bool draw_export_problem(ExportProblem::Field field, const Session& session, Ui& ui) {
  const ExportOutcome* outcome = shown_outcome(session, ui);
  if (outcome == nullptr || !outcome->problem) outcome = failed_outcome(session, ui);
  if (outcome == nullptr || outcome->problem->field != field) return false;
  draw_scrolled_text(("problem" + std::to_string(static_cast<int>(field))).c_str(),
                     sentence(outcome->problem->error),
                     {ImGui::GetContentRegionAvail().x, kMaxNoteLines * ImGui::GetTextLineHeight()},
                     theme::tone(theme::kError));
  ui.item("export/error");
  return true;
}

void draw_export_files(const Session& session, float below, Ui& ui) {
  ui.heading("What will be written");
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::BeginChild("files", {0, -below}, true);
  if (!draw_export_problem(ExportProblem::Field::level, session, ui))
    draw_file_table(shown_outcome(session, ui), session.exporting().preview_cancelled(), ui);
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

void draw_export_notes(const Session& session, Ui& ui) {
  const ExportOutcome* outcome = shown_outcome(session, ui);
  if (outcome == nullptr) return;
  if (outcome->code_bytes)
    draw_wrapped_text(code_text(*outcome->code_bytes),
                      theme::tone(*outcome->code_bytes > kMaxTicCode ? theme::kWarning : theme::kMuted));
  if (outcome->dropped.empty()) return;
  std::string text = "Not in the export: ";
  for (const std::string& what : outcome->dropped)
    text += (&what == &outcome->dropped.front() ? "" : ", ") + what;
  draw_scrolled_text("dropped", text + ".",
                     {ImGui::GetContentRegionAvail().x, kMaxNoteLines * ImGui::GetTextLineHeight()},
                     theme::tone(theme::kWarning));
  ui.item("export/dropped", text + ".");
  draw_copy_all("export/copy_all", text + ".", ui);
}

void draw_export_buttons(const Session& session, Actions& actions, Ui& ui) {
  if (const auto progress = session.exporting().progress())
    return draw_progress_row("export/progress", progress_text(*progress), progress->share, session, actions,
                             ui);
  const ExportOutcome* outcome = shown_outcome(session, ui);
  const std::optional<ExportProgress> preview = long_preview(session);
  const bool works = outcome != nullptr ? !outcome->problem : session.exporting().preview_cancelled();
  const std::string help = outcome != nullptr && !outcome->foreign.empty()
                               ? "Asks before it replaces a file that was not exported."
                               : "Writes this preset's files, all of them or none.";
  if (ui.text_button("export/export", (preview ? "Export" : export_label(outcome)), true, help, {}, works,
                     ui.px(preview ? 88 : 220)))
    actions.push_back(action::RunExports{ui.view.files.exports.preset});
  draw_preview_progress(preview, session, actions, ui);
}

}  // namespace talus
