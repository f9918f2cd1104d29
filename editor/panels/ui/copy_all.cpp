#include "copy_all.h"

#include <algorithm>

#include "shown_text.h"

namespace talus {

void draw_copy_all(std::string_view name, const std::string& text, Ui& ui) {
  if (text.size() <= kMaxText) return;
  if (!ui.text_button(name, "Copy all", false, "Copies the whole text, also what is not shown of it."))
    return;
  std::string copied = text;
  std::replace(copied.begin(), copied.end(), '\0', ' ');  // NUL would end it
  ImGui::SetClipboardText(copied.c_str());
}

}  // namespace talus
