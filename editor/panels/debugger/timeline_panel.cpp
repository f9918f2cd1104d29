// The strip above the transport.
#include "timeline_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "compare_choice.h"
#include "edit_rule_choice.h"
#include "frame_zoom.h"
#include "panels/commands/commands.h"

namespace talus {
namespace {

constexpr float kTrack = 24, kTakeOver = 142;  // px at scale 1: its height, and the button's width

// Small triangles below the axis, at frames.
void draw_pin(ImDrawList& list, float x, float bottom, float size, ImU32 color) {
  list.AddTriangleFilled({x - size, bottom - size * 1.6f}, {x + size, bottom - size * 1.6f}, {x, bottom},
                         color);
}

class Track {
 public:
  Track(const Session& session, ImVec2 at, ImVec2 size, const Ui& ui)
      : session_(session),
        branch_(session.timeline().current()),
        ui_(ui),
        list_(*ImGui::GetWindowDrawList()),
        min_(at),
        max_({at.x + size.x, at.y + size.y}),
        axis_(axis_of(ui.view.debugger.frames, branch_.last_frame(), at.x + ui.px(6), size.x - ui.px(12))) {}

  const FrameAxis& axis() const { return axis_; }

  void draw() const {
    list_.AddRectFilled(min_, max_, theme::tone(theme::kControl), ui_.px(3));
    list_.PushClipRect(min_, max_, true);
    // The part that is still to be run again is empty.
    const float end = axis_.left + axis_.width;
    const float done = std::clamp(axis_.x_of(static_cast<double>(branch_.run_frame())), axis_.left, end);
    list_.AddRectFilled({axis_.left, middle() - ui_.px(2)}, {end, middle() + ui_.px(2)},
                        theme::color(theme::kDark));
    list_.AddRectFilled({axis_.left, middle() - ui_.px(2)}, {done, middle() + ui_.px(2)},
                        theme::tone(theme::kMuted, 150));
    for (const Chapter& chapter : branch_.chapters)
      if (chapter.first > 0) tick(chapter.first, theme::tone(theme::kWarning, 170));
    if (branch_.parent != 0) tick(branch_.fork, theme::tone(theme::kText, 170));
    float last = axis_.left - ui_.px(8);  // a pin that would cover the one before is left out
    for (const Mark& mark : branch_.marks) {
      const float x = axis_.x_of(static_cast<double>(mark.frame));
      if (x < last + 1 || x > max_.x + ui_.px(4)) continue;
      draw_pin(list_, last = x, middle(), ui_.px(4), theme::tone(theme::kAccent));
    }
    if (const auto parting = session_.debugger().parting_frame(session_.timeline()))
      draw_pin(list_, axis_.x_of(static_cast<double>(*parting)), middle(), ui_.px(5),
               theme::tone(theme::kError));
    ends();
    cursor();
    list_.PopClipRect();
  }

  // The mark whose pin is at this place of the screen, or null.
  const Mark* mark_at(ImVec2 mouse) const {
    for (const Mark& mark : branch_.marks) {
      const float x = axis_.x_of(static_cast<double>(mark.frame));
      if (std::abs(mouse.x - x) <= ui_.px(4) && mouse.y <= middle()) return &mark;
    }
    return nullptr;
  }

 private:
  float middle() const { return std::round((min_.y + max_.y) / 2) + ui_.px(1); }
  void tick(std::int64_t frame, ImU32 color) const {
    const float x = std::round(axis_.x_of(static_cast<double>(frame)));
    list_.AddRectFilled({x, middle() - ui_.px(5)}, {x + ui_.px(1), middle() + ui_.px(5)}, color);
  }
  // The range of shown frames, if these are not all.
  void ends() const {
    if (ui_.view.debugger.frames == FrameZoom{}) return;
    const std::string first = std::to_string(axis_.first), last = std::to_string(axis_.last);
    plate(min_.x + ui_.px(6), first);
    plate(max_.x - ui_.px(6) - size_of_text(last).x, last);
  }
  void plate(float x, const std::string& text) const {
    const float pad = ui_.px(2), y = (min_.y + max_.y - ImGui::GetTextLineHeight()) / 2;
    list_.AddRectFilled({x - pad, min_.y}, {x + size_of_text(text).x + pad, max_.y},
                        theme::tone(theme::kControl));
    add_text(list_, {x, y}, theme::tone(theme::kMuted), text);
  }
  void cursor() const {
    const float x = std::round(axis_.x_of(static_cast<double>(session_.state().frame)));
    list_.AddRectFilled({x - ui_.px(3), min_.y}, {x + ui_.px(3), max_.y}, theme::color(theme::kDark),
                        ui_.px(2));
    list_.AddRectFilled({x - ui_.px(2), min_.y + ui_.px(1)}, {x + ui_.px(2), max_.y - ui_.px(1)},
                        theme::tone(theme::kText), ui_.px(2));
  }

  const Session& session_;
  const Branch& branch_;
  const Ui& ui_;
  ImDrawList& list_;
  const ImVec2 min_, max_;
  const FrameAxis axis_;
};

std::string help_at(const Session& session, const Track& track, ImVec2 mouse) {
  if (const Mark* mark = track.mark_at(mouse))
    return "Mark at frame " + std::to_string(mark->frame) + (mark->name.empty() ? "" : ": " + mark->name);
  std::string text = "Frame " + std::to_string(track.axis().frame_at(mouse.x)) + " of " +
                     std::to_string(session.timeline().last_frame());
  if (const auto parting = session.debugger().parting_frame(session.timeline()))
    text += ". " + compare_choice(session).label + " parts at frame " + std::to_string(*parting) + " (red).";
  return text;
}

}  // namespace

void TimelinePanel::draw(const Session& session, Actions& actions, Ui& ui) {
  const float gap = ImGui::GetStyle().ItemSpacing.x, controls = ui.px(kEditRuleWidth) + ui.px(kTakeOver);
  const float room = ImGui::GetContentRegionAvail().x - controls - 2 * gap;
  draw_track(session, actions, ui, {std::max(room, ui.px(kTrack)), ui.px(kTrack)});
  ImGui::SameLine();
  draw_edit_rule_choice(session, actions, ui);
  ImGui::SameLine();
  draw_take_over(session, actions, ui);
}

// At an earlier frame, play shows the recording again. The picture does not show that, so this does.
void TimelinePanel::draw_take_over(const Session& session, Actions& actions, Ui& ui) {
  const bool replays = session.playback().running && session.timeline().in_past();
  const Command& command = find_command("timeline/fork"_command);
  if (ui.text_button("timeline/take_over", replays ? "End replay, play on" : "Play on from here", replays,
                     "At an earlier frame, play shows the recording. This leaves the recording: playing goes "
                     "on from the shown frame, in a new branch. The players' keys, and the mouse on a ball, "
                     "do the same.",
                     keys_of(command, ui), command.is_enabled(session, ui), ui.px(kTakeOver)))
    command.run(session, actions, ui);
}

void TimelinePanel::draw_track(const Session& session, Actions& actions, Ui& ui, ImVec2 size) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), mouse = ImGui::GetIO().MousePos;
  const std::int64_t last = session.timeline().last_frame();
  if (shown_ != session.state().frame) show_frame(ui.view.debugger.frames, session.state().frame, last);
  shown_ = session.state().frame;
  ImGui::InvisibleButton("track", size);
  const Track track(session, at, size, ui);
  track.draw();
  ui.item("timeline/track", help_at(session, track, mouse),
          keys_of("timeline/back"_command, ui) + "  " + keys_of("play/step"_command, ui) +
              "; wheel zooms, middle button drags");
  handle_frame_zoom(track.axis(), last, ui);
  if (!ImGui::IsItemActive()) return;
  const Mark* mark = ImGui::IsItemActivated() ? track.mark_at(mouse) : nullptr;
  const std::int64_t frame = mark != nullptr ? mark->frame : track.axis().frame_at(mouse.x);
  if (ImGui::IsItemActivated()) actions.push_back(action::Pause{});
  if (frame != session.state().frame) actions.push_back(action::SeekFrame{frame});
}

}  // namespace talus
