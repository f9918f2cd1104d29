// The note lies at the side of its target that has room, and the target has a frame.
#include "tour_panel.h"

#include <algorithm>
#include <cfloat>
#include <string>
#include <utility>

namespace talus {
namespace {

constexpr float kNoteWidth = 280, kNoteGap = 12, kFrame = 2;  // px at scale 1

int count() { return static_cast<int>(tour_steps().size()); }

// Above what it points at, and above the bars, else below it; beside a target at the right side of the
// window or a large one at the left, and within another large one, such as a canvas, below the line at its
// top. Always in the window.
ImVec2 place_of_note(const Widget* target, ImVec2 size, float gap, float bars_top) {
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  if (target == nullptr) return {(window.x - size.x) / 2, window.y - size.y - 4 * gap};
  const bool is_large = target->max.y - target->min.y > 2 * size.y;
  float x = target->centre().x - size.x / 2, y = std::min(target->min.y, bars_top) - size.y - gap;
  if (is_large && target->max.x < window.x / 2) {
    x = target->max.x + gap;
    y = target->min.y + gap;
  } else if (is_large) {
    y = target->min.y + 4 * gap;
  } else if (target->centre().x > window.x * 2 / 3) {
    x = target->min.x - size.x - gap;
    y = target->min.y;
  } else if (y < gap) {
    y = target->max.y + gap;
  }
  return {std::clamp(x, gap, std::max(gap, window.x - size.x - gap)),
          std::clamp(y, gap, std::max(gap, window.y - size.y - gap))};
}

// In a window that takes no mouse, so that notes, menus and tooltips lie above the frame.
void draw_frame_around(const Widget& target, float width) {
  const ImVec2 min{target.min.x - width, target.min.y - width},
      max{target.max.x + width, target.max.y + width};
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize(ImGui::GetIO().DisplaySize);
  ImGui::Begin("Tour's frame", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoBackground |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRect({min.x - 1, min.y - 1}, {max.x + 1, max.y + 1}, theme::color(theme::kDark), 0, 0, width + 2);
  list.AddRect(min, max, theme::color(theme::kWarning), 0, 0, width);
  ImGui::End();
}

}  // namespace

void TourPanel::draw(const Session& session, Actions& actions, Ui& ui) {
  TourView& tour = ui.view.tour;
  wait_for_level(session, ui.view);
  if (!tour.open || ui.view.window.welcome_open) return start_.reset();
  tour.step = std::clamp(tour.step, 0, count());
  follow(session, actions, ui);
  const bool is_over = tour.step == count();
  const Widget* target = is_over ? nullptr : ui.widgets.find(tour_steps()[tour.step].target(ui));
  if (target != nullptr) draw_frame_around(*target, ui.px(kFrame));
  ImGui::SetNextWindowPos(place_of_note(target, size_, ui.px(kNoteGap), ui.bars_top));
  ImGui::SetNextWindowSizeConstraints({ui.px(kNoteWidth), 0}, {ui.px(kNoteWidth), FLT_MAX});
  ImGui::PushStyleColor(ImGuiCol_Border, theme::tone(theme::kWarning));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
  ImGui::Begin("Tour", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                   ImGuiWindowFlags_NoNavInputs);
  if (is_over)
    draw_end(ui);
  else
    draw_note(ui);
  size_ = ImGui::GetWindowSize();
  ui.place("tour/note", ImGui::GetWindowPos(),
           {ImGui::GetWindowPos().x + size_.x, ImGui::GetWindowPos().y + size_.y});
  ImGui::End();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

void TourPanel::wait_for_level(const Session& session, View& view) {
  TourView& tour = view.tour;
  if (tour.opens_after < 0) return;
  constexpr int kMaxFrames = 3;  // until an action has been carried out
  tour.open = view.canvas.level_number != tour.opens_after;
  const bool is_coming = session.question() || session.reading();
  frames_waited_ = is_coming ? 0 : frames_waited_ + 1;
  if (!tour.open && frames_waited_ <= kMaxFrames) return;
  frames_waited_ = 0;
  tour.opens_after = -1;
}

void TourPanel::follow(const Session& session, Actions& actions, Ui& ui) {
  int& step = ui.view.tour.step;
  if (step == count()) return;
  if (std::exchange(level_number_, ui.view.canvas.level_number) != ui.view.canvas.level_number)
    start_.reset();
  if (start_) start_->last_frame = std::max(start_->last_frame, session.state().frame);
  if (start_ && tour_steps()[step].is_done(session, ui, *start_)) {
    start_.reset();
    if (++step == count()) return;
  }
  if (start_) return;
  start_ = tour_start(session);
  tour_steps()[step].show(session, actions, ui);
}

void TourPanel::draw_note(Ui& ui) {
  TourView& tour = ui.view.tour;
  const TourStep& step = tour_steps()[tour.step];
  ui.label(step.heading);
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - ui.px(theme::kButton));
  if (ui.icon_button("tour/leave", Icon::close, false, "Leaves the tour. Help > Tour goes on with this step.",
                     {}))
    tour.open = false;
  draw_wrapped_text(step.text(ui));
  ui.item("tour/text");
  ui.muted(std::to_string(tour.step + 1) + " of " + std::to_string(count()));
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - ui.px(64));
  if (ui.text_button("tour/skip", "Skip", false, "Goes to the next step without doing this one.", {}, true,
                     ui.px(64))) {
    ++tour.step;
    start_.reset();
  }
}

void TourPanel::draw_end(Ui& ui) {
  ui.label("That was the tour");
  draw_wrapped_text(
      "Problems lists where bodies stick, and has a fix for many of them. The eye, Why and the timeline work "
      "on "
      "every level that you open.");
  if (ui.text_button("tour/close", "Close", false, "Closes the tour. Help > Tour begins it again."))
    ui.view.tour = {};
}

}  // namespace talus
