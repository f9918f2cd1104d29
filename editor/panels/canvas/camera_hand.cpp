// Reads the wheel and the drags.
#include "camera_hand.h"

#include "play_keys.h"

namespace talus {

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

bool CameraHand::move(Camera& camera, bool starts) {
  const ImGuiIO& io = ImGui::GetIO();
  if (starts && !moving_) {
    moving_ = true;
    last_ = io.MousePos;
  }
  if (!io.MouseDown[0] && !io.MouseDown[1] && !io.MouseDown[2]) moving_ = false;
  if (!moving_) return false;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  const Vec2 by{last_.x - io.MousePos.x, last_.y - io.MousePos.y};
  last_ = io.MousePos;
  camera.scroll(by);
  return by != Vec2{};
}

}  // namespace talus
