// Presets and their files in one scrolling table.
#include "asked_exports.h"

#include <filesystem>
#include <string>
#include <vector>

#include "export/exporter.h"
#include "export_preview.h"

namespace talus {
namespace {

constexpr std::size_t kMaxShown = 120;                           // bytes of a name or a path
constexpr float kAskedSizeColumn = 84, kAskedPlaceColumn = 150;  // px at scale 1

struct AskedRow {
  const ExportTask* preset = nullptr;  // null: this row is a file
  const PlannedFile* file = nullptr;
  const ExportOutcome* outcome = nullptr;  // never null
};

bool is_inside_a_letter(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// The text without its middle, with so many bytes left.
std::string without_middle(const std::string& text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  std::size_t head = bytes / 3, tail = text.size() - bytes / 2;
  while (head > 0 && is_inside_a_letter(text[head])) --head;
  while (tail < text.size() && is_inside_a_letter(text[tail])) ++tail;
  return text.substr(0, head) + " ... " + text.substr(tail);
}

// A text of a file in one line, without its middle if it does not fit into the width, px.
std::string fitted(const std::string& text, float width) {
  const std::string line = shown_line(text, kMaxText);
  std::string shown = without_middle(line, kMaxShown);
  for (std::size_t bytes = kMaxShown; bytes > 16 && size_of_text(shown).x > width; bytes -= 4)
    shown = without_middle(line, bytes);
  return shown;
}

std::vector<AskedRow> rows_of(const FinishedRun& asked) {
  std::vector<AskedRow> rows;
  for (const std::size_t task : asked.run.to_allow) {
    const ExportOutcome& outcome = asked.outcomes[task];
    if (outcome.problem) continue;
    rows.push_back({&outcome.task, nullptr, &outcome});
    for (const PlannedFile& file : outcome.files) rows.push_back({nullptr, &file, &outcome});
  }
  return rows;
}

void draw_asked_preset(const ExportTask& task) {
  const Exporter* exporter = find_exporter(task.preset.exporter);
  const std::string name = task.preset.name.empty() ? task.preset.path : task.preset.name;
  draw_text(fitted(name, ImGui::GetContentRegionAvail().x / 3));
  ImGui::SameLine();
  const std::string label = exporter != nullptr ? std::string(exporter->label) : "";
  draw_text(fitted(label, ImGui::GetContentRegionAvail().x), theme::tone(theme::kMuted));
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  if (task.preset.on_save) draw_text("at each save", theme::tone(theme::kMuted));
}

void draw_asked_file(const PlannedFile& file, const ExportOutcome& outcome, Ui& ui) {
  const std::filesystem::path folder = std::filesystem::path(outcome.task.level_file).parent_path();
  const std::filesystem::path relative = std::filesystem::path(file.path).lexically_relative(folder);
  const std::string path = relative.empty() ? file.path : relative.string();
  ImGui::Indent(ui.px(12));
  draw_text(fitted(path, ImGui::GetContentRegionAvail().x));
  ui.item("question/file/" + path, fitted(file.path, ui.px(600)));
  ImGui::Unindent(ui.px(12));
  ImGui::TableNextColumn();
  ui.right_aligned(size_text(file.size));
  ImGui::TableNextColumn();
  const bool is_foreign = outcome.foreign.contains(file.path);
  const bool is_new = file.place == PlannedFile::Place::empty;
  draw_text(is_new       ? "new"
            : is_foreign ? "replaces another file"
                         : "replaces an export",
            theme::tone(is_foreign ? theme::kWarning : theme::kMuted));
}

void draw_asked_row(const AskedRow& row, Ui& ui) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  if (row.preset != nullptr)
    draw_asked_preset(*row.preset);
  else
    draw_asked_file(*row.file, *row.outcome, ui);
}

}  // namespace

void draw_asked_exports(const FinishedRun& asked, float below, Ui& ui) {
  const std::vector<AskedRow> rows = rows_of(asked);
  ImGui::PushStyleVar(ImGuiStyleVar_ChildBorderSize, 1);
  ImGui::BeginChild("asked", {0, -below}, true);
  if (ImGui::BeginTable("files", 3)) {
    ImGui::TableSetupColumn("file");
    ImGui::TableSetupColumn("size", ImGuiTableColumnFlags_WidthFixed, ui.px(kAskedSizeColumn));
    ImGui::TableSetupColumn("place", ImGuiTableColumnFlags_WidthFixed, ui.px(kAskedPlaceColumn));
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()));
    while (clipper.Step()) {
      for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
        draw_asked_row(rows[static_cast<std::size_t>(i)], ui);
    }
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::PopStyleVar();
}

}  // namespace talus
