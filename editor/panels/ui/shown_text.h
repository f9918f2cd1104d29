// The only way for texts into Dear ImGui. Names, titles and messages come from files, and may have any length
// and any bytes. One text of more than 16,384 letters would end the program, as ImGui counts the vertices of
// a text in 16 bits. `tests/check_texts` checks that panels use these functions.
#pragma once

#include <imgui.h>

#include <string>
#include <string_view>

namespace talus {

inline constexpr std::size_t kMaxLabel = 120;     // bytes of the text of a control
inline constexpr std::size_t kMaxLine = 300;      // bytes of other texts of one line
inline constexpr std::size_t kMaxText = 6000;     // bytes of a text with several lines
inline constexpr std::size_t kMaxTooltip = 1200;  // bytes
inline constexpr std::size_t kMaxTyped = 4096;    // bytes of a text that can be typed

// Returns what is shown of a text: its first `most` bytes, only whole letters. A longer text ends with "..."
// or, if it has several lines, with the number of further bytes. Line ends and tabs become spaces. Other
// control characters, characters that change the direction of writing, and bytes that are not UTF-8 become
// dots.
std::string shown_line(std::string_view text, std::size_t most = kMaxLine);
// The same, with its line ends kept.
std::string shown_text(std::string_view text, std::size_t most = kMaxText);

// The same, broken between words into lines of at most `width` px. ImGui also breaks behind commas and full
// stops, and so inside of numbers. A wider word has a line for itself.
std::string text_in_lines(std::string_view text, float width);

// The text with its first letter as a capital, if that is one of a to z.
std::string capitalized(std::string_view text);

// Text at the cursor, in one line, or wrapped if a wrap position is set.
void draw_text(std::string_view text);
void draw_text(std::string_view text, ImU32 color);
// The same, wrapped at the window's right side.
void draw_wrapped_text(std::string_view text);
void draw_wrapped_text(std::string_view text, ImU32 color);
// Wrapped at `most.x` px, and at most `most.y` px high: a longer text scrolls. Becomes ImGui's last item.
void draw_scrolled_text(const char* id, std::string_view text, ImVec2 most, ImU32 color);
// Onto a canvas, in one line.
void add_text(ImDrawList& list, ImVec2 at, ImU32 color, std::string_view text);
// The same up to `right`, with "..." if it does not fit.
void add_short_text(ImDrawList& list, ImVec2 at, float right, ImU32 color, std::string_view text);
// In one line at the cursor, at most `most` px wide, with "..." if it does not fit.
void draw_short_text(std::string_view text, float most, ImU32 color);
// The size of a text in one line, px.
ImVec2 size_of_text(std::string_view text);

// ImGui's controls with any text. id: tells the control from its neighbours; empty: the text does.
bool selectable(std::string_view text, std::string_view id, bool chosen, ImGuiSelectableFlags flags = 0,
                ImVec2 size = {0, 0});
bool menu_item(std::string_view text, std::string_view id, std::string_view keys = {}, bool checked = false,
               bool enabled = true);
bool begin_menu(std::string_view text, bool enabled = true);
bool button(std::string_view text, std::string_view id, ImVec2 size = {0, 0});
bool small_button(std::string_view text, std::string_view id = {});
bool radio_button(std::string_view text, std::string_view id, bool chosen);
bool checkbox(std::string_view text, std::string_view id, bool& on);
bool begin_tab_item(std::string_view text, std::string_view id, ImGuiTabItemFlags flags = 0);
bool begin_combo(std::string_view id, std::string_view shown, ImGuiComboFlags flags = 0);
// A field for a text. A text of more than kMaxTyped bytes, which only a file can have, is shown but cannot
// be changed. Typed or pasted text is cut to that size.
bool input_text(std::string_view id, std::string_view hint, std::string& text, ImGuiInputTextFlags flags = 0,
                ImGuiInputTextCallback callback = nullptr, void* data = nullptr);

}  // namespace talus
