#include "picture_in_list.h"

#include <algorithm>
#include <filesystem>

namespace talus {

void draw_picture_in(const std::shared_ptr<const SheetPicture>& picture, ImVec2 min, ImVec2 max, Ui& ui) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(min, max, theme::color(theme::kDark));
  if (!picture) return;
  const ImVec2 room{max.x - min.x, max.y - min.y};
  const auto width = static_cast<float>(picture->width), height = static_cast<float>(picture->height);
  const float zoom = std::min(room.x / width, room.y / height);
  const ImVec2 from{min.x + (room.x - zoom * width) / 2, min.y + (room.y - zoom * height) / 2};
  list.AddImage(ui.small_pictures->texture(picture), from, {from.x + zoom * width, from.y + zoom * height});
}

void draw_recent_picture(const std::string& file, ImVec2 min, ImVec2 max, Ui& ui) {
  const auto& pictures = ui.view.files.recent_pictures;
  const auto found = pictures.find(file);
  draw_picture_in(found != pictures.end() ? found->second : nullptr, min, max, ui);
}

std::string example_name(const std::string& path) {
  std::string name = std::filesystem::path(path).filename().string();
  name.erase(std::min(name.find('.'), name.size()));
  std::replace(name.begin(), name.end(), '-', ' ');
  return name;
}

}  // namespace talus
