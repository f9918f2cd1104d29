// A modal list with two buttons a row.
#include "recovery_dialog.h"

#include <ctime>
#include <string>

#include "panels/dialog.h"

namespace talus {
namespace {

std::string local_time(std::int64_t seconds) {
  const auto time = static_cast<std::time_t>(seconds);
  std::tm parts{};
  if (localtime_r(&time, &parts) == nullptr) return {};
  char text[64];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts)};
}

}  // namespace

std::optional<RecoveryDialog::Answer> RecoveryDialog::draw(std::span<const SavedWork> works, bool unsaved,
                                                           Ui& ui) {
  bool& open = ui.view.program.recovery_open;
  if (!begin_dialog("Recover unsaved work", open, {ui.px(640), 0}, ui)) return std::nullopt;
  if (ImGui::IsWindowAppearing()) asked_about_.reset();
  std::optional<Answer> answer;
  if (works.empty())
    ui.hint("Nothing is left to recover. Unsaved changes are saved by themselves every few seconds.");
  else
    ui.hint(
        "Talus ended without saving these. Recovered changes can be undone, and are saved when you save.");
  if (unsaved) ui.hint("Save the open level and its recording first: a recovered one takes their place.");
  for (std::size_t i = 0; i < works.size(); ++i) {
    ImGui::Separator();
    if (const auto chosen = draw_work(i, works[i], unsaved, ui)) answer = chosen;
  }
  ImGui::Separator();
  if (ui.text_button("recovery/later", works.empty() ? "Close" : "Later", false,
                     "Keeps them for the next start, or for File > Recover.", "Esc", true, ui.px(96)) ||
      key_pressed(ImGuiKey_Escape))
    open = false;
  ImGui::EndPopup();
  return answer;
}

std::optional<RecoveryDialog::Answer> RecoveryDialog::draw_work(std::size_t index, const SavedWork& work,
                                                                bool unsaved, Ui& ui) {
  std::optional<Answer> answer;
  const std::string number = std::to_string(index);
  ImGui::TextUnformatted(work.name.c_str());
  ImGui::SameLine();
  ui.right_aligned("saved " + local_time(work.time), theme::tone(theme::kMuted));
  std::string about = work.path.empty() ? "It has no file of its own yet." : work.path;
  if (work.recording)
    about +=
        "\nWith a recording of " + std::to_string(work.recording->frames) + " frames that you worked on.";
  ui.hint(about);
  if (ui.text_button("recovery/recover" + number, "Recover", index == 0,
                     "Opens it, as a change that can be undone.", {}, !unsaved, ui.px(96)))
    answer = Answer{index, Choice::recover};
  ImGui::SameLine();
  const bool asked = asked_about_ == index;
  if (ui.text_button("recovery/discard" + number, asked ? "Discard for good" : "Discard", asked,
                     "Throws it away; asks once more.", {}, true, ui.px(128))) {
    if (asked) answer = Answer{index, Choice::discard};
    asked_about_ = asked ? std::optional<std::size_t>() : index;
  }
  return answer;
}

}  // namespace talus
