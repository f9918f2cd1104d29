// A row for each thing: its colour and name, how many there are, and lists of what it can stand for.
#include "ldtk_mapping_table.h"

#include <array>
#include <span>
#include <string>

#include "formats/ldtk/ldtk_meanings.h"
#include "panels/ui/long_list.h"
#include "panels/ui/shown_text.h"
#include "panels/ui/theme.h"

namespace talus {
namespace {

constexpr float kNameWidth = 170, kShapeWidth = 204, kFlagWidth = 116;          // px at scale 1
constexpr std::array<const char*, 3> kKindLabels = {"value", "tag", "entity"};  // by LdtkMapping::Kind

std::string label_of(std::span<const LdtkWord> words, const std::string& chosen, const std::string& usual) {
  for (const LdtkWord& word : words) {
    if (word.word == chosen) return std::string(word.label);
  }
  return usual;
}

// A list of words; its first row is what the name says.
bool draw_words(const std::string& widget, float width, std::span<const LdtkWord> words,
                const std::string& usual, std::string_view help, std::string& chosen, Ui& ui) {
  bool is_changed = false;
  if (!ui.begin_combo(widget, label_of(words, chosen, usual), ui.px(width), help, {})) return false;
  const auto row = [&](std::string_view label, std::string_view word) {
    if (selectable(label, word, chosen == word)) {
      is_changed = chosen != word;
      chosen = word;
    }
    ui.item(widget + "/" + (word.empty() ? "usual" : std::string(word)));
  };
  row(usual, "");
  for (const LdtkWord& word : words) row(word.label, word.word);
  ImGui::EndCombo();
  return is_changed;
}

void draw_name(const LdtkThing& thing, Ui& ui) {
  const float side = ImGui::GetTextLineHeight();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float down = ui.px(theme::kButton) / 2 - side / 2;  // to the middle of the row
  if (thing.color) {
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + down}, {at.x + side, at.y + down + side},
                                              theme::color(*thing.color));
  }
  ImGui::AlignTextToFramePadding();
  ImGui::Dummy({side, side});
  ImGui::SameLine();
  const std::string name = std::string(kKindLabels[static_cast<std::size_t>(thing.choice.kind)]) + " " +
                           thing.label + ", " + std::to_string(thing.count);
  draw_short_text(name, ui.px(kNameWidth) - ImGui::GetCursorPosX(), theme::tone(theme::kText));
  ImGui::SameLine(ui.px(kNameWidth));
}

}  // namespace

bool draw_ldtk_mapping(const std::vector<LdtkThing>& things, LdtkMapping& mapping, ImVec2 size, Ui& ui) {
  bool is_changed = false;
  ImGui::BeginChild("mapping", size, false, ImGuiWindowFlags_NavFlattened);
  ui.begin_row();
  draw_rows(static_cast<int>(things.size()), [&](int row) {
    const LdtkThing& thing = things[static_cast<std::size_t>(row)];
    LdtkMapping::Choice choice = thing.choice;
    if (const auto* known = mapping.find(choice.kind, choice.of, choice.name)) choice = *known;
    const std::string widget = "choose/thing" + std::to_string(row + 1);
    draw_name(thing, ui);
    bool changes = false;
    if (choice.kind == LdtkMapping::Kind::entity) {
      changes = draw_words(widget + "/body", kShapeWidth, ldtk_body_words(), "default: " + thing.usual,
                           "Which body such entities are.", choice.body, ui);
    } else {
      changes = draw_words(widget + "/shape", kShapeWidth, ldtk_shape_words(), "default: " + thing.usual,
                           "Which ground it is.", choice.shape, ui);
      ImGui::SameLine();
      changes = draw_words(widget + "/flag", kFlagWidth, ldtk_flag_words(), "default flag",
                           "Which flag its tiles have.", choice.flag, ui) ||
                changes;
    }
    if (changes) mapping.set(choice);
    is_changed = is_changed || changes;
  });
  ui.end_row();
  ImGui::EndChild();
  return is_changed;
}

}  // namespace talus
