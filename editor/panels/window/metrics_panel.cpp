// A table of numbers with their units.
#include "metrics_panel.h"

#include <cstdio>

#include "panels/ui/floating_window.h"

namespace talus {
namespace {

void metric_row(const char* name, const char* format, double value, const char* help, Ui& ui) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  draw_text(name);
  ui.tooltip(help);
  ImGui::TableNextColumn();
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  ui.right_aligned(text, theme::tone(theme::kText));
}

}  // namespace

void MetricsPanel::draw(const Session& session, Actions&, Ui& ui) {
  bool& open = ui.view.window.metrics_open;
  if (!open) return;
  const FrameMetrics& metrics = ui.view.window.metrics;
  const FrameCost last = metrics.last();
  const Series* steps = session.step_times().series();
  if (begin_floating_window({.title = "Times of the window",
                             .open = &open,
                             .place = {0.5f, ui.px(64) / ImGui::GetIO().DisplaySize.y},
                             .pivot = {0.5f, 0},
                             .flags = ImGuiWindowFlags_NoNavInputs})) {
    if (ImGui::BeginTable("metrics", 2)) {
      ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, ui.px(180));
      ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthFixed, ui.px(72));
      constexpr const char* kFrames =
          "Processor time for panels, canvases and overlays; of the last 120 frames.";
      metric_row("interface, median   ms", "%.2f", metrics.median_ms(), kFrames, ui);
      metric_row("interface, longest   ms", "%.2f", metrics.max_ms(), kFrames, ui);
      metric_row("OpenGL, median   ms", "%.2f", metrics.median_ms(&FrameCost::opengl_ms),
                 "Processor time for handing the picture to OpenGL, without showing it. A driver that has no "
                 "graphics hardware draws meanwhile.",
                 ui);
      metric_row("vertices", "%.0f", last.vertices, "Drawn by Dear ImGui in the last frame.", ui);
      metric_row("draw calls", "%.0f", last.draw_calls, "The calls that drew them.", ui);
      if (steps != nullptr && !steps->points().empty())
        metric_row("step   ns", "%.0f", steps->points().back().last,
                   "Of the last step of the simulation, all bodies.", ui);
      ImGui::EndTable();
    }
    ui.place("metrics/window", ImGui::GetWindowPos(),
             {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
              ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
  }
  ImGui::End();
}

}  // namespace talus
