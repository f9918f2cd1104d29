// Cuts texts, and hands them to ImGui.
#include "shown_text.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cstdint>

#include "formats/text/utf8_text.h"
#include "wrapped_text.h"

namespace talus {
namespace {

constexpr std::string_view kDot = "\xc2\xb7";  // replaces a character that cannot be shown

// Control characters, letters without a width, and marks of the direction of writing.
bool has_no_picture(std::uint32_t code) {
  return code < 0x20 || (code >= 0x7f && code < 0xa0) || code == 0xad || code == 0x61c ||
         (code >= 0x200b && code <= 0x200f) || (code >= 0x2028 && code <= 0x202e) ||
         (code >= 0x2060 && code <= 0x206f) || code == 0xfeff || (code & 0xfffe) == 0xfffe;
}

std::string cut(std::string_view text, std::size_t most, bool keeps_lines) {
  std::string shown;
  shown.reserve(std::min(text.size(), most) + kDot.size());
  std::size_t at = 0;
  while (at < text.size() && shown.size() < most) {
    const CodePoint letter = first_code_point(text.substr(at));
    if (letter.value == '\n' && keeps_lines)
      shown += '\n';
    else if (letter.value == '\n' || letter.value == '\t')
      shown += ' ';
    else if (letter.value == '\r' && text.substr(at + 1).starts_with('\n'))
      ;  // the line's end follows from the next character
    else if (letter.bytes == 0 || has_no_picture(letter.value))
      shown += kDot;
    else
      shown += text.substr(at, letter.bytes);
    at += std::max<std::size_t>(letter.bytes, 1);
  }
  if (at == text.size()) return shown;
  return shown + (keeps_lines ? "... and " + std::to_string(text.size() - at) + " bytes more" : "...");
}

// "text###id". A "##" in the text would hide the rest of it.
std::string label_of(std::string_view text, std::string_view id) {
  std::string label = shown_line(text, kMaxLabel);
  for (std::size_t at = label.find("##"); at != std::string::npos; at = label.find("##", at))
    label.insert(at + 1, 1, ' ');
  return label.append("###").append(id.empty() ? text.substr(0, kMaxLabel) : id);
}

// Cuts what was typed, then calls the field's own callback.
struct TypedText {
  ImGuiInputTextFlags flags;
  ImGuiInputTextCallback callback;
  void* data;

  static int on_event(ImGuiInputTextCallbackData* event) {
    const auto& typed = *static_cast<TypedText*>(event->UserData);
    if (event->EventFlag == ImGuiInputTextFlags_CallbackEdit) {
      const std::size_t size = static_cast<std::size_t>(event->BufTextLen);
      if (size > kMaxTyped) {
        std::size_t end = kMaxTyped;
        while (end > 0 && (static_cast<unsigned char>(event->Buf[end]) & 0xc0u) == 0x80u) --end;
        event->DeleteChars(static_cast<int>(end), static_cast<int>(size - end));
      }
    }
    if (typed.callback == nullptr || (typed.flags & event->EventFlag) == 0) return 0;
    event->UserData = typed.data;
    return typed.callback(event);
  }
};

}  // namespace

std::string capitalized(std::string_view text) {
  std::string result(text);
  if (!result.empty() && result.front() >= 'a' && result.front() <= 'z')
    result.front() = static_cast<char>(result.front() - 'a' + 'A');
  return result;
}

std::string shown_line(std::string_view text, std::size_t most) { return cut(text, most, false); }

std::string shown_text(std::string_view text, std::size_t most) { return cut(text, most, true); }

std::string text_in_lines(std::string_view text, float width) {
  const std::string shown = shown_text(text);
  const auto fits = [width](std::string_view line) {
    return ImGui::CalcTextSize(line.data(), line.data() + line.size()).x <= width;
  };
  if (fits(shown)) return shown;
  std::string lines;
  for (std::size_t begin = 0, end = 0; end < shown.size(); begin = end + 1) {
    end = std::min(shown.find('\n', begin), shown.size());
    for (const std::string_view line :
         lines_between_words(std::string_view(shown).substr(begin, end - begin), fits))
      lines.append(lines.empty() ? "" : "\n").append(line);
  }
  return lines;
}

void draw_text(std::string_view text) {
  const ImGuiWindow& window = *ImGui::GetCurrentWindow();
  const float wrap = window.DC.TextWrapPos;
  const std::string shown = wrap < 0
                                ? shown_line(text)
                                : text_in_lines(text, ImGui::CalcWrapWidthForPos(window.DC.CursorPos, wrap));
  ImGui::TextUnformatted(shown.data(), shown.data() + shown.size());
}

void draw_text(std::string_view text, ImU32 color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  draw_text(text);
  ImGui::PopStyleColor();
}

void draw_wrapped_text(std::string_view text) {
  ImGui::PushTextWrapPos(0);
  draw_text(text);
  ImGui::PopTextWrapPos();
}

void draw_wrapped_text(std::string_view text, ImU32 color) {
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  draw_wrapped_text(text);
  ImGui::PopStyleColor();
}

void draw_scrolled_text(const char* id, std::string_view text, ImVec2 most, ImU32 color) {
  std::string shown = text_in_lines(text, most.x);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  const auto draw = [&](float width) {
    ImGui::PushTextWrapPos(width);
    ImGui::TextUnformatted(shown.data(), shown.data() + shown.size());
    ImGui::PopTextWrapPos();
  };
  if (ImGui::CalcTextSize(shown.data(), shown.data() + shown.size(), false, most.x).y <= most.y) {
    ImGui::BeginGroup();
    draw(ImGui::GetCursorPosX() + most.x);
    ImGui::EndGroup();
  } else {
    const float width = most.x - ImGui::GetStyle().ScrollbarSize;
    shown = text_in_lines(text, width);
    ImGui::BeginChild(id, most, false, ImGuiWindowFlags_NoNavInputs);
    draw(width);
    ImGui::EndChild();
  }
  ImGui::PopStyleColor();
}

void add_text(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view text) {
  const std::string shown = shown_line(text);
  list.AddText(at, color, shown.data(), shown.data() + shown.size());
}

void add_short_text(ImDrawList& list, ImVec2 at, float right, ImU32 color, std::string_view text) {
  const std::string shown = shown_line(text);
  ImGui::PushStyleColor(ImGuiCol_Text, color);
  ImGui::RenderTextEllipsis(&list, at, {right, at.y + ImGui::GetTextLineHeight()}, right, right, shown.data(),
                            shown.data() + shown.size(), nullptr);
  ImGui::PopStyleColor();
}

void draw_short_text(std::string_view text, float most, ImU32 color) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), size = size_of_text(text);
  const float lowered = ImGui::GetCurrentWindow()->DC.CurrLineTextBaseOffset;
  const float width = std::max(1.0f, std::min(size.x, most));
  ImGui::Dummy({width, size.y + lowered});
  add_short_text(*ImGui::GetWindowDrawList(), {at.x, at.y + lowered}, at.x + width, color, text);
}

ImVec2 size_of_text(std::string_view text) {
  const std::string shown = shown_line(text);
  return ImGui::CalcTextSize(shown.data(), shown.data() + shown.size());
}

bool selectable(std::string_view text, std::string_view id, bool chosen, ImGuiSelectableFlags flags,
                ImVec2 size) {
  return ImGui::Selectable(label_of(text, id).c_str(), chosen, flags, size);
}

bool begin_tab_item(std::string_view text, std::string_view id, ImGuiTabItemFlags flags) {
  return ImGui::BeginTabItem(label_of(text, id).c_str(), nullptr, flags);
}

bool menu_item(std::string_view text, std::string_view id, std::string_view keys, bool checked,
               bool enabled) {
  const std::string shown = keys.empty() ? "" : "    " + shown_line(keys);  // apart from the texts
  return ImGui::MenuItem(label_of(text, id).c_str(), shown.empty() ? nullptr : shown.c_str(), checked,
                         enabled);
}

bool begin_menu(std::string_view text, bool enabled) {
  return ImGui::BeginMenu(label_of(text, {}).c_str(), enabled);
}

bool button(std::string_view text, std::string_view id, ImVec2 size) {
  return ImGui::Button(label_of(text, id).c_str(), size);
}

bool small_button(std::string_view text, std::string_view id) {
  return ImGui::SmallButton(label_of(text, id).c_str());
}

bool radio_button(std::string_view text, std::string_view id, bool chosen) {
  return ImGui::RadioButton(label_of(text, id).c_str(), chosen);
}

bool checkbox(std::string_view text, std::string_view id, bool& on) {
  return ImGui::Checkbox(label_of(text, id).c_str(), &on);
}

bool begin_combo(std::string_view id, std::string_view shown, ImGuiComboFlags flags) {
  const std::string preview = shown_line(shown, kMaxLabel);
  return ImGui::BeginCombo(("##" + std::string(id)).c_str(), preview.c_str(), flags);
}

bool input_text(std::string_view id, std::string_view hint, std::string& text, ImGuiInputTextFlags flags,
                ImGuiInputTextCallback callback, void* data) {
  const std::string name = "##" + std::string(id), shown_hint(hint);
  if (text.size() > kMaxTyped) {
    std::string shown = shown_line(text);
    ImGui::InputText(name.c_str(), &shown, ImGuiInputTextFlags_ReadOnly);
    return false;
  }
  TypedText typed{flags, callback, data};
  return ImGui::InputTextWithHint(name.c_str(), shown_hint.c_str(), &text,
                                  flags | ImGuiInputTextFlags_CallbackEdit, TypedText::on_event, &typed);
}

}  // namespace talus
