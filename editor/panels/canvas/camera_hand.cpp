// Reads the wheel and the drags.
#include "camera_hand.h"

#include <algorithm>

#include "play_keys.h"

namespace talus {

namespace {

constexpr int kMiddleButton = 2;

// A hand that clicks may tremble.
bool is_middle_drag() {
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 from = io.MouseClickedPos[kMiddleButton];
  const float x = io.MousePos.x - from.x, y = io.MousePos.y - from.y;
  const float farthest = std::max(x * x + y * y, io.MouseDragMaxDistanceSqr[kMiddleButton]);
  return farthest >= io.MouseDragThreshold * io.MouseDragThreshold;
}

}  // namespace

bool middle_button_picks(const Preferences& preferences) {
  if (preferences.middle_picks) return ImGui::IsMouseClicked(kMiddleButton);
  return ImGui::IsMouseReleased(kMiddleButton) && !is_middle_drag();
}

bool space_moves_view(const Session& session, const View& view) {
  return ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space)) && !keys_steer(session, view) &&
         !view.canvas.cursor.on();
}

bool CameraHand::zoom(Camera& camera, ImVec2 at) {
  wheel_ += ImGui::GetIO().MouseWheel;
  const int steps = static_cast<int>(wheel_);
  wheel_ -= static_cast<float>(steps);
  if (steps != 0) camera.zoom_at(at, steps);
  return steps != 0;
}

bool CameraHand::move(Camera& camera, int button) {
  const ImGuiIO& io = ImGui::GetIO();
  if (button != kNone && !is_moving()) {
    button_ = button;
    last_ = io.MousePos;
  }
  if (!is_moving()) return false;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const bool is_click = button_ == kMiddleButton && !is_middle_drag();
  if (!io.MouseDown[button_]) button_ = kNone;
  if (is_click) return false;
  const Vec2 by{last_.x - io.MousePos.x, last_.y - io.MousePos.y};
  last_ = io.MousePos;
  camera.scroll(by);
  return by != Vec2{};
}

}  // namespace talus
