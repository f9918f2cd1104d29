// Draws a bar over the window while a file is read.
#include "reading_panel.h"

#include <string>

#include "panels/ui/dialog.h"

namespace talus {
namespace {

constexpr double kLong = 0.3;     // s
constexpr float kBarWidth = 360;  // px at scale 1

}  // namespace

bool shows_reading(const Session& session) {
  const auto reading = session.reading();
  return reading && reading->seconds >= kLong;
}

void ReadingPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const auto reading = session.reading();
  const auto reads = [](const Session& now, const View&) { return shows_reading(now); };
  if (!begin_dialog("Reading a file", reads, {0, 0}, session, ui)) return;
  if (reading) {
    draw_short_text("Reading " + reading->name, ui.px(kBarWidth), theme::tone(theme::kText));
    ui.item("reading/name", reading->name);
    const std::string percent = std::to_string(static_cast<int>(reading->share * 100)) + " %";
    ImGui::ProgressBar(static_cast<float>(reading->share), {ui.px(kBarWidth), ui.px(theme::kButton)},
                       percent.c_str());
    ui.item("reading/progress", "How much of the file is read. The level stays as it is until all of it is.");
    const DialogButton cancel{.widget = "reading/cancel",
                              .label = "Cancel",
                              .help = "Goes back to the level as it is.",
                              .letter = 'C',
                              .is_default = true,
                              .is_cancel = true,
                              .width = ui.px(96),
                              .gets_the_keys = true};
    if (dialog_button(cancel, ui)) actions.push_back(action::CancelReading{});
  }
  ImGui::EndPopup();
}

}  // namespace talus
