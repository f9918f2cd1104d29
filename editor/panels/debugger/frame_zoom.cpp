#include "frame_zoom.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

namespace talus {
namespace {

constexpr double kFewest = 10;         // smallest number of shown frames
constexpr double kZoomOfAStep = 1.25;  // for one click of the wheel

// All frames count as the default, and there is no place beside them.
void clamp_frames(FrameZoom& zoom, std::int64_t last) {
  const auto all = static_cast<double>(std::max<std::int64_t>(last, 1));
  if (zoom.count <= 0 || zoom.count >= all) {
    zoom = {};
    return;
  }
  zoom.count = std::max(zoom.count, std::min(kFewest, all));
  zoom.first = std::clamp(zoom.first, 0.0, all - zoom.count);
}

double count_of(const FrameZoom& zoom, std::int64_t last) {
  return zoom.count > 0 ? zoom.count : static_cast<double>(std::max<std::int64_t>(last, 1));
}

}  // namespace

FrameAxis axis_of(const FrameZoom& zoom, std::int64_t last, float left, float width) {
  FrameZoom shown = zoom;
  clamp_frames(shown, last);
  const auto first = std::llround(shown.first);
  return {left, width, first, first + std::max<std::int64_t>(std::llround(count_of(shown, last)), 1)};
}

void zoom_frames(FrameZoom& zoom, double frame, float steps, std::int64_t last) {
  const double before = count_of(zoom, last);
  const double share = (frame - zoom.first) / before;
  zoom.count = std::max(before * std::pow(kZoomOfAStep, -static_cast<double>(steps)), kFewest);
  zoom.first = frame - share * zoom.count;
  clamp_frames(zoom, last);
}

void pan_frames(FrameZoom& zoom, double frames, std::int64_t last) {
  zoom.first += frames;
  clamp_frames(zoom, last);
}

void show_frame(FrameZoom& zoom, std::int64_t frame, std::int64_t last) {
  if (zoom.count <= 0) return;
  const auto at = static_cast<double>(frame);
  zoom.first = std::clamp(zoom.first, at - zoom.count, at);
  clamp_frames(zoom, last);
}

void handle_frame_zoom(const FrameAxis& axis, std::int64_t last, Ui& ui) {
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetItemUsingMouseWheel();  // the region around it does not scroll
  const ImGuiIO& io = ImGui::GetIO();
  FrameZoom& zoom = ui.view.debugger.frames;
  const double frames_of_px = static_cast<double>(axis.last - axis.first) / axis.width;
  const double frame = static_cast<double>(axis.first) + (io.MousePos.x - axis.left) * frames_of_px;
  if (io.MouseWheel != 0) zoom_frames(zoom, frame, io.MouseWheel, last);
  if (io.MouseDown[2]) pan_frames(zoom, -io.MouseDelta.x * frames_of_px, last);
}

}  // namespace talus
