// A modal list with two buttons in each row; the arrows move between rows.
#include "recovery_dialog.h"

#include <algorithm>
#include <ctime>
#include <string>
#include <vector>

#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr std::size_t kMaxInView = 4;  // works before the list scrolls

std::string local_time(std::int64_t seconds) {
  const auto time = static_cast<std::time_t>(seconds);
  std::tm parts{};
  if (localtime_r(&time, &parts) == nullptr) return {};
  char text[64];
  return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S", &parts)};
}

}  // namespace

std::vector<std::string> about_work(const SavedWork& work) {
  if (work.level == nullptr)
    return {"It cannot be recovered, and stays as it is until you discard it:",
            shown_line(work.file + " " + work.problem + ".")};
  std::vector<std::string> about = {work.path.empty() ? "It has no file of its own yet."
                                                      : shown_line(work.path)};
  const std::size_t recordings = work.recordings.size();
  if (recordings == 1)
    about.push_back("With a recording of " + std::to_string(work.recordings.front()->frames) +
                    " frames that you worked on.");
  else if (recordings > 1)
    about.push_back("With " + std::to_string(recordings) + " recordings that you worked on.");
  if (const std::size_t unread = work.unread_recordings.size(); unread > 0)
    about.push_back(shown_line((unread == 1 ? "A recording" : std::to_string(unread) + " recordings") +
                               " with it cannot be read: " + work.unread_recordings.front() + "."));
  return about;
}

std::optional<RecoveryDialog::Answer> RecoveryDialog::draw(std::span<const SavedWork> works, bool reading,
                                                           const Session& session, Ui& ui) {
  const auto is_open = [](const Session&, const View& view) { return view.window.recovery_open; };
  if (!begin_dialog("Recover unsaved work", is_open, {ui.px(640), 0}, session, ui)) return std::nullopt;
  const bool unsaved = session.modified() || !session.unsaved_branches().empty();
  const auto readable =
      std::find_if(works.begin(), works.end(), [](const SavedWork& work) { return work.level != nullptr; });
  // Keys that are pressed before the dialog is seen must not discard anything.
  const bool later_is_first = readable == works.end() || unsaved;
  if (ImGui::IsWindowAppearing()) {
    asked_about_.reset();
    chosen_ = readable == works.end() ? 0 : static_cast<std::size_t>(readable - works.begin());
  }
  std::optional<Answer> answer;
  if (reading)
    ui.hint("Reading what was saved ...");
  else if (works.empty())
    ui.hint("Nothing is left to recover. Unsaved changes are saved automatically every few seconds.");
  else
    ui.hint(
        "Talus ended without saving these. Recovered changes can be undone, and are saved when you save.");
  if (unsaved) ui.hint("Save the open level and its recording first: a recovered one takes their place.");
  const float row = 4 * ImGui::GetTextLineHeightWithSpacing() + ui.px(theme::kButton);
  const std::size_t in_view = std::min(works.size(), kMaxInView);
  if (works.size() > in_view)
    ImGui::BeginChild("works", {0, static_cast<float>(in_view) * row}, false, ImGuiWindowFlags_NavFlattened);
  for (std::size_t i = 0; i < works.size(); ++i) {
    ImGui::Separator();
    if (const auto chosen = draw_work(i, works[i], unsaved, ui)) answer = chosen;
  }
  if (works.size() > in_view) ImGui::EndChild();
  ImGui::Separator();
  const DialogButton later{.widget = "recovery/later",
                           .label = works.empty() ? "Close" : "Later",
                           .help = "Keeps them for the next start, or for File > Recover.",
                           .letter = works.empty() ? 'C' : 'L',
                           .is_default = later_is_first,
                           .is_cancel = true,
                           .width = ui.px(96),
                           .gets_the_keys = later_is_first};
  if (dialog_button(later, ui)) ui.view.window.recovery_open = false;
  ImGui::EndPopup();
  return answer;
}

std::optional<RecoveryDialog::Answer> RecoveryDialog::draw_work(std::size_t index, const SavedWork& work,
                                                                bool unsaved, Ui& ui) {
  std::optional<Answer> answer;
  const std::string saved = "saved " + local_time(work.time);
  draw_short_text(work.name, ImGui::GetContentRegionAvail().x - size_of_text(saved).x - ui.px(16),
                  theme::tone(theme::kText));
  ImGui::SameLine();
  ui.right_aligned(saved, theme::tone(theme::kMuted));
  for (const std::string& line : about_work(work)) ui.hint(line);
  const bool is_readable = work.level != nullptr;
  const bool chosen = chosen_ == index;  // the letters are for this one
  const std::string recover_name = "recovery/recover" + std::to_string(index);
  const DialogButton recover{.widget = recover_name,
                             .label = "Recover",
                             .help = "Opens it, as a change that can be undone.",
                             .letter = chosen ? 'R' : '\0',
                             .is_default = chosen && is_readable,
                             .enabled = !unsaved && is_readable,
                             .width = ui.px(96),
                             .gets_the_keys = chosen};
  if (dialog_button(recover, ui)) answer = Answer{index, Choice::recover};
  if (ImGui::IsItemFocused()) chosen_ = index;
  ImGui::SameLine();
  if (draw_discard(index, ui)) answer = Answer{index, Choice::discard};
  return answer;
}

// Returns true when it is pressed for the second time.
bool RecoveryDialog::draw_discard(std::size_t index, Ui& ui) {
  const std::string name = "recovery/discard" + std::to_string(index);
  const bool asked = asked_about_ == index;
  const DialogButton discard{.widget = name,
                             .label = asked ? "Discard for good" : "Discard",
                             .help = "Deletes it; asks once more.",
                             .letter = chosen_ == index ? 'D' : '\0',
                             .width = ui.px(128)};
  const bool pressed = dialog_button(discard, ui);
  if (pressed) asked_about_ = asked ? std::optional<std::size_t>() : index;
  if (ImGui::IsItemFocused()) chosen_ = index;
  return pressed && asked;
}

}  // namespace talus
